// SPDX-License-Identifier: MIT
#include "balance/ease.hpp"

#include <algorithm>

namespace ragdoll {

namespace {

/// Nobody is at ease whose fastest limb the motion turns faster than this, rad/s.
constexpr float MAX_SPEED = 0.5f;
/// What is left of a joint's torque in any case, as friction of joints and clothes (0.002 to 0.01).
constexpr float FRICTION = 0.005f;

float find_fastest(const Pose &p_now, const Pose &p_next, float p_delta_s) {
	float most = 0.0f;
	for (std::size_t i = 1; i < p_now.orientations.size(); i++) {
		most = std::max(most, angle_between(p_now.orientations[i], p_next.orientations[i]));
	}
	return most / p_delta_s;
}

} // namespace

void ease_limbs(const Rig &p_rig, const CompositeInertia &p_inertia, const RigState &p_state, const Pose &p_now,
		const Pose &p_next, float p_share, float p_frequency, float p_delta_s, std::vector<LimbCommand> &r_commands) {
	// Who moves the arms needs their torque, and that of the trunk which holds them.
	if (p_share <= 0.0f || find_fastest(p_now, p_next, p_delta_s) > MAX_SPEED) {
		return;
	}
	const float step = TAU * p_frequency * p_delta_s;
	for (std::size_t i = 1; i < p_rig.size(); i++) {
		LimbCommand &command = r_commands[i];
		if (p_rig.is_in_leg(i) || command.mode != Actuation::VELOCITY_MOTOR) {
			continue;
		}
		const std::size_t parent = std::size_t(p_rig[i].parent);
		const Quat actual = p_state.orientations[parent].inverse() * p_state.orientations[i];
		const Quat wanted = p_now.orientations[parent].inverse() * p_now.orientations[i];
		const Vec3 error = log(actual.inverse() * wanted);
		const Vec3 turning = p_state.orientations[i].inverse().rotate(p_state.angular[i] - p_state.angular[parent]);
		const Quat next = p_next.orientations[parent].inverse() * p_next.orientations[i];
		const Vec3 forward = log(wanted.inverse() * next) * (1.0f / p_delta_s);
		const Vec3 pull = turning - forward + error * (step * step / p_delta_s);
		const Vec3 velocity = forward + pull * (1.0f / ((1.0f + step) * (1.0f + step)));
		const float spring = (velocity - turning).scaled(p_inertia[i]).length() / p_delta_s;
		const float most = std::min(spring + FRICTION * command.max_torque, command.max_torque);
		command.velocity = command.velocity + (velocity - command.velocity) * p_share;
		command.max_torque += (most - command.max_torque) * p_share;
	}
}

} // namespace ragdoll
