// SPDX-License-Identifier: MIT
#include "control/limb_control.hpp"

#include <algorithm>

namespace ragdoll {

void apply_to_joint(const LimbControl &p_control, const Rig &p_rig, const ControlSettings &p_usual, std::size_t p_limb,
		float p_blend_s, ActuationTable &r_table) {
	const float blend = std::clamp(p_control.physics_blend, 0.0f, 1.0f);
	const float own = p_rig[p_limb].max_torque;
	const float most = p_control.parent_angular.most;
	const float share = most > 0.0f && own > 0.0f ? most / own : 1.0f;
	const bool is_sprung = p_control.mode == Actuation::SPRING_TORQUE;
	r_table.set_limb_mode(blend > 0.0f ? p_control.mode : Actuation::DIRECT_SET, p_limb, p_blend_s);
	r_table.set_limb_share(std::max(p_control.strength, 0.0f) * share, p_limb, p_blend_s);
	r_table.set_limb_spring(p_control.parent_angular.strength, p_control.parent_angular.damping_ratio,
			is_sprung ? p_usual.torque_frequency : p_usual.position_frequency, p_limb, p_blend_s);
	r_table.set_physics_blend(blend, p_limb, p_blend_s);
}

void blend_shown(const Rig &p_rig, const ActuationTable &p_table, const Pose &p_motion, const RigState &p_state,
		std::vector<Quat> &r_orientations, Vec3 &r_root_centre) {
	r_orientations = p_state.orientations;
	r_root_centre = p_state.centres[0];
	if (!p_table.is_blended() || p_motion.orientations.size() != p_rig.size()) {
		return;
	}
	for (std::size_t i = 0; i < p_rig.size(); i++) {
		r_orientations[i] = slerp(p_motion.orientations[i], p_state.orientations[i], p_table.get_physics_blend(i));
	}
	const Vec3 target = p_motion.root + p_motion.orientations[0].rotate(p_rig[0].centre);
	r_root_centre = target + (r_root_centre - target) * p_table.get_physics_blend(0);
}

} // namespace ragdoll
