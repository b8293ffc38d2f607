// SPDX-License-Identifier: MIT
// RagdollMotor: how a profile and its bodies become a driven ragdoll.
#include "ragdoll_motor.hpp"

#include <convert.hpp>

#include <cmath>
#include <utility>

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

} // namespace

bool RagdollMotor::setup(const Ref<RagdollProfile> &p_profile, const TypedArray<RID> &p_bodies,
		const PackedVector3Array &p_centres, const RID &p_space) {
	ERR_FAIL_COND_V_MSG(p_profile.is_null(), false, "RagdollMotor: there is no profile.");
	const String fault = p_profile->find_fault();
	ERR_FAIL_COND_V_MSG(!fault.is_empty(), false, "RagdollMotor: the profile has a fault: " + fault + ".");
	const int64_t count = p_profile->get_limbs().size();
	ERR_FAIL_COND_V_MSG(
			p_bodies.size() != count, false, "RagdollMotor: there must be one body for each limb of the profile.");
	ERR_FAIL_COND_V_MSG(!p_centres.is_empty() && p_centres.size() != count, false,
			"RagdollMotor: there must be one centre for each limb of the profile, or none at all.");
	ERR_FAIL_COND_V_MSG(!p_space.is_valid(), false, "RagdollMotor: there is no physics space.");
	const String obstacle = find_body_fault(p_bodies, p_space);
	ERR_FAIL_COND_V_MSG(!obstacle.is_empty(), false, "RagdollMotor: " + obstacle + ".");
	const String problem = find_physics_problem();
	static bool is_reported = false;
	if (!problem.is_empty() && !is_reported) {
		is_reported = true; // Once is enough: it is the project's.
		WARN_PRINT(problem);
	}
	release();
	if (!make_driver(p_profile, p_bodies, p_centres)) {
		return false;
	}
	apply_settings();
	_bodies = std::make_unique<RagdollBodies>();
	_bodies->make(_driver->get_rig(), std::move(_specs), p_space);
	_bodies->set_righted_limb(_driver->righted_limb);
	_bodies->prepare(_self_collision);
	return true;
}

PackedStringArray RagdollMotor::_get_configuration_warnings() const {
	PackedStringArray warnings;
	const String problem = find_physics_problem();
	if (!problem.is_empty()) {
		warnings.push_back(problem);
	}
	return warnings;
}

TypedArray<RID> RagdollMotor::get_joints() const {
	TypedArray<RID> result;
	for (std::size_t i = 0; _driver && i < _driver->get_rig().size(); i++) {
		result.append(_bodies->get_joint(i));
	}
	return result;
}

void RagdollMotor::add_contacts(const Ref<RagdollLimb> &p_limb, int p_index) {
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

bool RagdollMotor::make_driver(
		const Ref<RagdollProfile> &p_profile, const TypedArray<RID> &p_bodies, const PackedVector3Array &p_centres) {
	const int64_t count = p_bodies.size();
	std::vector<ragdoll::Segment> limbs;
	std::vector<int> limb_groups;
	_groups.clear();
	_bones.clear();
	_control_profile = StringName();
	_reset_pose.clear();
	_specs.clear();
	_body_rids.clear();
	_contacts.clear();
	int righted = -1;
	for (int64_t i = 0; i < count; i++) {
		const Ref<RagdollLimb> source = p_profile->get_limbs()[i];
		ragdoll::Segment limb;
		const ragdoll::Quat rest = to_core(source->get_rest_orientation());
		limb.parent = p_profile->get_parent_index(int(i));
		limb.centre = rest.inverse().rotate(to_core(source->get_position() - source->get_anchor()));
		if (!p_centres.is_empty()) {
			limb.centre = to_core(p_centres[i]);
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
		if (!find_group(source->get_group(), limb.group) || limb.group < 0) {
			limb.group = int(_groups.size());
			_groups.push_back(source->get_group());
		}
		righted = limb.group == 0 && i > 0 ? int(i) : righted;
		limbs.push_back(limb);
		limb_groups.push_back(limb.group);
		_bones.push_back(source->get_bone());
		_reset_pose.push_back(limb.rest);
		RagdollBodies::JointSpec spec;
		spec.body = p_bodies[i];
		spec.has_limits = _anatomical_limits && limb.parent >= 0;
		if (spec.has_limits) {
			spec.axes = limb.rest.inverse() * to_core(source->get_joint_axes());
			// As with motors, the engine's sign of angles is the other way round.
			spec.lower = -source->get_max_angles();
			spec.upper = -source->get_min_angles();
		}
		_specs.push_back(spec);
		_body_rids.push_back(p_bodies[i]);
		add_contacts(source, int(i));
	}
	ragdoll::scale_inertia(limbs, float(_inertia_scale), float(_arm_inertia_scale));
	_driver = std::make_unique<ragdoll::Driver>(ragdoll::Rig(std::move(limbs)), limb_groups, _groups.size(), _contacts);
	_driver->righted_limb = righted;
	_obstacles.attach(_body_rids);
	_state.resize(std::size_t(count));
	_shown.reserve(std::size_t(count));
	resize_body_pose();
	_targets.assign(std::size_t(count) * 4, 0.0f);
	return true;
}

} // namespace godot
