// SPDX-License-Identifier: MIT
#include "root_drive.hpp"

#include "controller.hpp"

#include <algorithm>

namespace ragdoll {

namespace {

constexpr float GRAVITY = 9.81f;

} // namespace

RootCommand drive_root(RootMode p_mode, const RootSettings &p_settings, const Rig &p_rig, const Vec3 &p_actual,
		const Vec3 &p_now, const Vec3 &p_next, float p_delta_s, float p_strength) {
	RootCommand command;
	command.torque = p_mode == RootMode::PENDULUM ? 0.0f : p_settings.torque * p_strength;
	command.assist_torque = p_settings.torque * p_strength;
	if (is_free(p_mode)) {
		return command;
	}
	command.force_up = p_settings.force * p_strength;
	command.force_across = command.force_up;
	if (p_mode == RootMode::INERTIAL) {
		command.force_across = std::min(command.force_up, p_settings.grip * p_rig.get_mass() * GRAVITY * p_strength);
	}
	const Vec3 error = p_now - p_actual;
	const float distance = error.length();
	Vec3 correction = error * std::min(p_settings.gain, 1.0f / p_delta_s);
	const float most = braking_speed(distance, command.force_across / p_rig.get_mass());
	if (correction.length() > most) {
		correction = correction * (most / std::max(correction.length(), 1e-6f));
	}
	command.velocity = (p_next - p_now) * (1.0f / p_delta_s) + correction;
	return command;
}

Vec3 righting_velocity(const Quat &p_actual, const Quat &p_now, const Quat &p_next, float p_delta_s, float p_gain) {
	const float gain = std::min(p_gain, 1.0f / p_delta_s);
	return log(p_now.inverse() * p_next) * (1.0f / p_delta_s) + log(p_actual.inverse() * p_now) * gain;
}

} // namespace ragdoll
