// SPDX-License-Identifier: MIT
#include "body/placement.hpp"

namespace ragdoll {

void place_at_rest(const Rig &p_rig, const Pose &p_pose, std::vector<Vec3> &r_joints, RigState &r_state) {
	p_rig.joint_positions(p_pose, r_joints);
	for (std::size_t i = 0; i < p_rig.size(); i++) {
		r_state.orientations[i] = p_pose.orientations[i];
		r_state.centres[i] = r_joints[i] + p_pose.orientations[i].rotate(p_rig[i].centre);
		r_state.linear[i] = {};
		r_state.angular[i] = {};
	}
	r_state.root = p_pose.root;
}

void set_in_motion(const Rig &p_rig, const Pose &p_now, const Pose &p_next, float p_delta_s,
		std::vector<Vec3> &r_joints_next, RigState &r_state) {
	const float rate = 1.0f / p_delta_s;
	p_rig.joint_positions(p_next, r_joints_next);
	for (std::size_t i = 0; i < p_rig.size(); i++) {
		const Vec3 centre = r_joints_next[i] + p_next.orientations[i].rotate(p_rig[i].centre);
		r_state.linear[i] = (centre - r_state.centres[i]) * rate;
		const Quat turn = p_next.orientations[i] * p_now.orientations[i].inverse();
		r_state.angular[i] = log(turn) * rate;
	}
}

} // namespace ragdoll
