// SPDX-License-Identifier: MIT
#include "ragdoll_plan.hpp"

#include <convert.hpp>

namespace godot {

namespace {

String find_body_fault(const TypedArray<RID> &p_bodies, const RID &p_space) {
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	for (int64_t i = 0; i < p_bodies.size(); i++) {
		const RID body = p_bodies[i];
		if (server->body_get_direct_state(body) == nullptr || server->body_get_space(body) != p_space) {
			return "one of the bodies is none, or is not in the physics space";
		}
		for (int64_t j = 0; j < i; j++) {
			if (RID(p_bodies[j]) == body) {
				return "two limbs have the same body";
			}
		}
	}
	return String();
}

/// A limb's shape in the axes of its body.
ragdoll::LimbShape find_shape(const ragdoll::Limb &p_limb) {
	ragdoll::LimbShape shape;
	shape.turn = p_limb.rest_orientation.inverse() * p_limb.orientation;
	if (p_limb.type == ragdoll::Limb::BOX) {
		shape.type = ragdoll::LimbShape::Type::BOX;
		shape.half = p_limb.size * 0.5f;
	} else {
		shape.type = ragdoll::LimbShape::Type::PILL;
		shape.half = { p_limb.radius, p_limb.length * 0.5f, p_limb.radius };
	}
	return shape;
}

} // namespace

String RagdollPlan::find_fault(const Ref<RagdollProfile> &p_profile, const TypedArray<RID> &p_bodies,
		const PackedVector3Array &p_centres, const RID &p_space) {
	if (p_profile.is_null()) {
		return "there is no profile";
	}
	const String fault = p_profile->find_fault();
	if (!fault.is_empty()) {
		return "the profile has a fault: " + fault;
	}
	const int64_t count = p_profile->get_limbs().size();
	if (p_bodies.size() != count) {
		return "there must be one body for each limb of the profile";
	}
	if (!p_centres.is_empty() && p_centres.size() != count) {
		return "there must be one centre for each limb of the profile, or none at all";
	}
	return p_space.is_valid() ? find_body_fault(p_bodies, p_space) : String("there is no physics space");
}

RagdollPlan::RagdollPlan(const Ref<RagdollProfile> &p_profile, const TypedArray<RID> &p_bodies,
		const PackedVector3Array &p_centres, bool p_has_limits) {
	for (int64_t i = 0; i < p_bodies.size(); i++) {
		const Ref<RagdollLimb> source = p_profile->get_limbs()[i];
		add_limb(p_profile, int(i), p_centres);
		add_spec(source, p_bodies[i], p_has_limits && _segments.back().parent >= 0);
		add_contacts(source, int(i));
	}
}

void RagdollPlan::add_limb(const Ref<RagdollProfile> &p_profile, int p_index, const PackedVector3Array &p_centres) {
	const Ref<RagdollLimb> source = p_profile->get_limbs()[p_index];
	ragdoll::Segment limb;
	const ragdoll::Quat rest = to_core(source->get_rest_orientation());
	limb.parent = p_profile->get_parent_index(p_index);
	limb.centre = rest.inverse().rotate(to_core(source->get_position() - source->get_anchor()));
	if (!p_centres.is_empty()) {
		limb.centre = to_core(p_centres[p_index]);
	}
	if (limb.parent >= 0) {
		const Ref<RagdollLimb> above = p_profile->get_limbs()[limb.parent];
		const ragdoll::Quat turn = to_core(above->get_rest_orientation()).inverse();
		limb.anchor = turn.rotate(to_core(source->get_anchor() - above->get_anchor()));
	}
	limb.rest = to_core(source->get_reset_orientation());
	limb.mass = float(p_profile->get_mass() * source->get_mass_fraction());
	limb.inertia = to_core(source->get_body_inertia(limb.mass));
	limb.max_torque = float(source->get_max_torque());
	limb.is_foot = source->get_is_foot();
	limb.shape = find_shape(source->to_core());
	if (!find_group(source->get_group(), limb.group) || limb.group < 0) {
		limb.group = int(_groups.size());
		_groups.push_back(source->get_group());
	}
	_righted_limb = limb.group == 0 && p_index > 0 ? p_index : _righted_limb;
	_segments.push_back(limb);
	_bones.push_back(source->get_bone());
	_reset_pose.push_back(limb.rest);
}

void RagdollPlan::add_spec(const Ref<RagdollLimb> &p_limb, const RID &p_body, bool p_has_limits) {
	RagdollBodies::JointSpec spec;
	spec.body = p_body;
	spec.has_limits = p_has_limits;
	if (spec.has_limits) {
		spec.axes = _reset_pose.back().inverse() * to_core(p_limb->get_joint_axes());
		// As with motors, the engine's sign of angles is the other way round.
		spec.lower = -p_limb->get_max_angles();
		spec.upper = -p_limb->get_min_angles();
	}
	_specs.push_back(spec);
	_bodies.push_back(p_body);
}

void RagdollPlan::add_contacts(const Ref<RagdollLimb> &p_limb, int p_index) {
	const PackedVector3Array points = p_limb->get_contact_points();
	const ragdoll::Quat turn = to_core(p_limb->get_rest_orientation()).inverse();
	for (int64_t i = 0; i < points.size(); i++) {
		ragdoll::ContactPoint contact;
		contact.limb = p_index;
		contact.local = turn.rotate(to_core(points[i] - p_limb->get_anchor()));
		contact.radius = float(p_limb->get_contact_radius());
		contact.sole = p_limb->get_is_foot();
		_contacts.push_back(contact);
	}
}

std::vector<int> RagdollPlan::get_limb_groups() const {
	std::vector<int> groups;
	groups.reserve(_segments.size());
	for (const ragdoll::Segment &limb : _segments) {
		groups.push_back(limb.group);
	}
	return groups;
}

bool RagdollPlan::find_group(const StringName &p_group, int &r_group) const {
	r_group = -1;
	if (p_group == StringName()) {
		return true;
	}
	for (std::size_t i = 0; i < _groups.size(); i++) {
		if (_groups[i] == p_group) {
			r_group = int(i);
			return true;
		}
	}
	return false;
}

bool RagdollPlan::find_limbs(const PackedStringArray &p_names, std::vector<std::uint8_t> &r_limbs) const {
	r_limbs.assign(_bones.size(), std::uint8_t(p_names.is_empty() ? 1 : 0));
	for (int64_t i = 0; i < p_names.size(); i++) {
		const StringName name = p_names[i];
		bool is_known = false;
		for (std::size_t limb = 0; limb < _bones.size(); limb++) {
			const bool is_meant = _bones[limb] == name || _groups[std::size_t(_segments[limb].group)] == name;
			r_limbs[limb] = std::uint8_t(is_meant || r_limbs[limb] != 0);
			is_known = is_known || is_meant;
		}
		ERR_FAIL_COND_V_MSG(
				!is_known, false, "RagdollMotor: the profile has no bone and no group " + String(name) + ".");
	}
	return true;
}

} // namespace godot
