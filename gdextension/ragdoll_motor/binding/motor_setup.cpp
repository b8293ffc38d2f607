// SPDX-License-Identifier: MIT
// RagdollMotor: how a profile and its bodies become a driven ragdoll.
#include "ragdoll_motor.hpp"

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
	_plan = RagdollPlan(p_profile, p_bodies, p_centres, _anatomical_limits);
	make_driver();
	apply_settings();
	_bodies = std::make_unique<RagdollBodies>();
	_bodies->make(_driver->get_rig(), _plan.get_specs(), p_space);
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

void RagdollMotor::make_driver() {
	std::vector<ragdoll::Segment> limbs = _plan.get_segments();
	ragdoll::scale_inertia(limbs, float(_inertia_scale), float(_arm_inertia_scale));
	_driver = std::make_unique<ragdoll::Driver>(
			ragdoll::Rig(std::move(limbs)), _plan.get_limb_groups(), _plan.get_group_count(), _plan.get_contacts());
	_driver->righted_limb = _plan.get_righted_limb();
	_control_profile = StringName();
	_obstacles.attach(_plan.get_bodies());
	const std::size_t count = _plan.get_segments().size();
	_state.resize(count);
	_shown.reserve(count);
	resize_body_pose();
	_targets.assign(count * 4, 0.0f);
}

} // namespace godot
