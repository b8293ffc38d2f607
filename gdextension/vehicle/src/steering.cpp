// SPDX-License-Identifier: MIT
#include "steering.hpp"

#include <algorithm>
#include <cmath>

namespace vehicle {

namespace {

/// Share of the vehicle's mass that the steering's gain is made for: a track that has lost the ground weighs less.
constexpr float GAIN_SHARE = 0.08f;
constexpr float STRAIGHT = 0.02f;
/// Below such a difference (m/s) that nobody wants, steering lets the tracks be.
constexpr float STEER_DEAD = 1e-3f;

} // namespace

float TrackSteering::step(float p_steer, float p_speed, float p_left, float p_right, float p_turning, float p_mass,
		float p_power, float p_delta) {
	const float fastest = settings.most_sideways * settings.tread / std::max(std::abs(p_speed), 0.1f);
	const float wanted = p_steer * std::min(2.0f * settings.pivot_speed, fastest);
	// Tracks slip unevenly: a driver who wants to go straight on steers against it.
	const float against = std::abs(p_steer) < STRAIGHT && std::abs(p_speed) > 1.0f
			? -settings.straightness * p_turning * settings.tread
			: 0.0f;
	_difference += (wanted + against - _difference) * std::min(1.0f, p_delta / settings.response);
	const float error = 0.5f * (_difference - (p_right - p_left));
	const float gain = GAIN_SHARE * p_mass / p_delta;
	const float apart = std::max(std::abs(p_right - p_left), 0.1f);
	const float most = std::min(settings.force, p_power / apart);
	if (std::abs(_difference) < STEER_DEAD && std::abs(p_speed) < 0.2f) {
		_sum *= std::max(0.0f, 1.0f - p_delta / settings.response); // At rest nothing keeps the tracks apart.
	}
	_sum = std::clamp(_sum + 0.3f * error * gain * p_delta / settings.response, -most, most);
	return std::clamp(error * gain + _sum, -most, most);
}

void TrackSteering::reset() {
	_difference = 0.0f;
	_sum = 0.0f;
}

float WheelSteering::step(float p_steer, float p_speed, float p_delta) {
	const float squared = std::max(p_speed * p_speed, 0.01f);
	// On a circle of radius r the acceleration is v^2 / r, and r = wheelbase / tan(angle).
	const float fastest = std::atan(settings.most_sideways * settings.wheelbase / squared);
	const float wanted = p_steer * std::min(settings.max_angle, fastest);
	const float most = settings.rate * p_delta;
	_angle += std::clamp(wanted - _angle, -most, most);
	return _angle;
}

float WheelSteering::angle_at(float p_ahead, float p_right) const {
	if (std::abs(_angle) < 1e-4f) {
		return 0.0f;
	}
	// The middle of the circle lies so far to the left of the middle.
	const float left = settings.wheelbase / std::tan(_angle);
	return std::atan(p_ahead / (left + p_right));
}

} // namespace vehicle
