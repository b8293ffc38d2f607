// SPDX-License-Identifier: MIT
#include "balance/ease.hpp"

#include <algorithm>

namespace ragdoll {

void ease_limbs(const Rig &p_rig, const Balance &p_balance, const RigState &p_state, const Pose &p_now,
		const Pose &p_next, float p_delta_s, std::vector<LimbCommand> &r_commands) {
	float fastest = 0.0f;
	for (std::size_t i = 1; i < p_rig.size(); i++) {
		const float turned = angle_between(p_now.orientations[i], p_next.orientations[i]);
		fastest = std::max(fastest, turned / p_delta_s);
	}
	if (fastest > EASE_MAX_SPEED) {
		return; // Who moves the arms needs their torque, and that of the trunk which holds them.
	}
	for (std::size_t i = 1; i < p_rig.size(); i++) {
		LimbCommand &command = r_commands[i];
		if (p_rig.is_in_leg(i) || command.mode != Actuation::VELOCITY_MOTOR) {
			continue;
		}
		const std::size_t parent = std::size_t(p_rig[i].parent);
		const Quat actual = p_state.orientations[parent].inverse() * p_state.orientations[i];
		const Quat wanted = p_now.orientations[parent].inverse() * p_now.orientations[i];
		const Vec3 error = p_state.orientations[i].rotate(log(actual.inverse() * wanted));
		const Vec3 turning = p_state.angular[i] - p_state.angular[parent];
		command.max_torque *= p_balance.get_stiffness(error.length(), error.dot(turning) > 0.0f);
	}
}

} // namespace ragdoll
