// SPDX-License-Identifier: MIT
#include "root/root_drive.hpp"

#include "joint/controller.hpp"

#include <algorithm>

namespace ragdoll {

RootCommand drive_root(RootMode p_mode, const RootSettings &p_settings, const Rig &p_rig, const RigState &p_actual,
		const Vec3 &p_now, const Vec3 &p_next, float p_delta_s, float p_strength) {
	RootCommand command;
	command.torque = p_settings.torque * p_strength;
	if (p_mode == RootMode::GROUNDED) {
		return command;
	}
	command.force_up = p_settings.force * p_strength;
	command.force_across = command.force_up;
	if (p_mode == RootMode::INERTIAL) {
		// Soles hold by what presses them to the ground: without gravity by nothing.
		const float weight = p_rig.get_mass() * std::max(-p_actual.gravity.y, 0.0f);
		command.force_across = std::min(command.force_up, p_settings.grip * weight * p_strength);
	}
	const float gain = std::min(p_settings.gain, 1.0f / p_delta_s);
	const Vec3 error = p_now - p_actual.root;
	const Vec3 across{ error.x, 0.0f, error.z };
	const float braked = command.force_across / p_rig.get_mass();
	const Vec3 correction = (across * gain).limited(braking_speed(across.length(), braked));
	// What sinks is braked by what the force has left besides the weight; what rises, by the weight too.
	const float pull = error.y > 0.0f ? -p_actual.gravity.y : p_actual.gravity.y;
	const float fastest = braking_speed(std::fabs(error.y), command.force_up / p_rig.get_mass() + pull);
	command.velocity = (p_next - p_now) * (1.0f / p_delta_s) + correction;
	command.velocity.y += std::clamp(error.y * gain, -fastest, fastest);
	return command;
}

} // namespace ragdoll
