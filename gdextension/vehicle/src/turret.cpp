// SPDX-License-Identifier: MIT
#include "turret.hpp"

#include <algorithm>
#include <cmath>

using kinematics::Quat;
using kinematics::Vec3;

namespace vehicle {

namespace {

constexpr float FULL_TURN = 2.0f * 3.14159265f;
/// A gun that points straight up has no azimuth: the aim stays this far from there, rad.
constexpr float MAX_ELEVATION = 1.45f;

float wrapped(float p_angle) {
	return std::remainder(p_angle, FULL_TURN);
}

Vec3 direction_of(float p_yaw, float p_pitch) {
	const float level = std::cos(p_pitch);
	return { -level * std::sin(p_yaw), std::sin(p_pitch), -level * std::cos(p_yaw) };
}

float yaw_of(const Vec3 &p_direction) {
	return std::atan2(-p_direction.x, -p_direction.z);
}

float pitch_of(const Vec3 &p_direction) {
	return std::asin(std::clamp(p_direction.y, -1.0f, 1.0f));
}

float share_of(float p_input) {
	return std::isfinite(p_input) ? std::clamp(p_input, -1.0f, 1.0f) : 0.0f;
}

/// A speed on its way to another one.
float approached(float p_now, float p_wanted, float p_change) {
	return std::clamp(p_wanted, p_now - p_change, p_now + p_change);
}

/// The speed that takes a drive over a way to something that moves at p_target within a step or, where that takes
/// longer, lets it brake in time.
float speed_towards(float p_way, float p_target, float p_now, float p_max, float p_acceleration, float p_delta) {
	const float change = p_acceleration * p_delta;
	const float exact = p_way / p_delta;
	if (std::abs(exact - p_now) <= change && std::abs(exact) <= p_max) {
		return exact;
	}
	// What is left of the way when the target has gone on.
	const float left = p_way - p_target * p_delta;
	const float limit = std::min(std::sqrt(2.0f * p_acceleration * std::abs(left)), std::abs(left) / p_delta);
	const float wanted = std::clamp(p_target + std::copysign(limit, left), -p_max, p_max);
	return approached(p_now, wanted, change);
}

} // namespace

void TurretDrive::set_stabilised(bool p_is_stabilised) {
	_is_stabilised = p_is_stabilised;
	_has_aim = false;
}

void TurretDrive::place(float p_yaw, float p_pitch) {
	_yaw = wrapped(p_yaw);
	if (settings.yaw_limit > 0.0f) {
		_yaw = std::clamp(_yaw, -settings.yaw_limit, settings.yaw_limit);
	}
	_pitch = std::clamp(p_pitch, settings.pitch_min, settings.pitch_max);
	_yaw_speed = 0.0f;
	_pitch_speed = 0.0f;
	_yaw_order = 0.0f;
	_pitch_order = 0.0f;
	_has_aim = false;
}

void TurretDrive::_follow_gunner(float p_yaw, float p_pitch, float p_delta) {
	// Against its stop the gun takes no further orders that way.
	const bool is_at_stop =
			(_pitch >= settings.pitch_max && p_pitch > 0.0f) || (_pitch <= settings.pitch_min && p_pitch < 0.0f);
	const float pitch = is_at_stop ? 0.0f : p_pitch;
	_yaw_order = approached(_yaw_order, p_yaw * settings.yaw_rate, settings.yaw_acceleration * p_delta);
	_pitch_order = approached(_pitch_order, pitch * settings.pitch_rate, settings.pitch_acceleration * p_delta);
}

void TurretDrive::_hold_aim(const Quat &p_hull, const Vec3 &p_hull_rate, float p_delta) {
	if (!_has_aim) {
		_aim = p_hull.rotate(direction_of(_yaw, _pitch));
		_last_rate = p_hull_rate;
		_target_yaw = _yaw;
		_target_pitch = _pitch;
		_has_aim = true;
	}
	const float pitch = pitch_of(_aim) + _pitch_order * p_delta;
	_aim = direction_of(yaw_of(_aim) + _yaw_order * p_delta, std::clamp(pitch, -MAX_ELEVATION, MAX_ELEVATION));
	// Bodies move with the speed that they have after a step: it is foreseen from the last two.
	const Vec3 rate = p_hull_rate + (p_hull_rate - _last_rate) * settings.foresight;
	_last_rate = p_hull_rate;
	const Vec3 local = (kinematics::exp(rate * p_delta) * p_hull).inverse().rotate(_aim);
	float yaw = yaw_of(local);
	if (settings.yaw_limit > 0.0f) {
		yaw = std::clamp(yaw, -settings.yaw_limit, settings.yaw_limit);
	}
	const float pitch_wanted = std::clamp(pitch_of(local), settings.pitch_min, settings.pitch_max);
	_yaw_speed = speed_towards(wrapped(yaw - _yaw), wrapped(yaw - _target_yaw) / p_delta, _yaw_speed, settings.yaw_rate,
			settings.yaw_acceleration, p_delta);
	_pitch_speed = speed_towards(pitch_wanted - _pitch, (pitch_wanted - _target_pitch) / p_delta, _pitch_speed,
			settings.pitch_rate, settings.pitch_acceleration, p_delta);
	_target_yaw = yaw;
	_target_pitch = pitch_wanted;
}

void TurretDrive::step(const Quat &p_hull, const Vec3 &p_hull_rate, float p_yaw, float p_pitch, float p_delta) {
	if (!p_hull.is_finite() || !p_hull_rate.is_finite() || !(p_delta > 0.0f)) {
		return;
	}
	_follow_gunner(share_of(p_yaw), share_of(p_pitch), p_delta);
	if (_is_stabilised) {
		_hold_aim(p_hull, p_hull_rate, p_delta);
	} else {
		_yaw_speed = _yaw_order;
		_pitch_speed = _pitch_order;
	}
	_yaw = wrapped(_yaw + _yaw_speed * p_delta);
	if (settings.yaw_limit > 0.0f) {
		_yaw = std::clamp(_yaw, -settings.yaw_limit, settings.yaw_limit);
	}
	_pitch = std::clamp(_pitch + _pitch_speed * p_delta, settings.pitch_min, settings.pitch_max);
}

} // namespace vehicle
