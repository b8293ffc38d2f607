// SPDX-License-Identifier: MIT
#include "turret_drive.hpp"

#include <cmath>

namespace godot {

namespace {

/// Half a turn, rad.
constexpr double MAX_YAW_LIMIT = 3.14159266;

} // namespace

bool TurretDrive::configure(const Vector2 &p_rates, const Vector2 &p_accelerations, double p_yaw_limit,
		double p_pitch_min, double p_pitch_max) {
	const bool can_move = p_rates.x > 0.0 && p_rates.y > 0.0 && p_accelerations.x > 0.0 && p_accelerations.y > 0.0;
	ERR_FAIL_COND_V_MSG(!can_move || !p_rates.is_finite() || !p_accelerations.is_finite(), false,
			"A turret's rates and accelerations are more than 0.");
	ERR_FAIL_COND_V_MSG(!(p_yaw_limit >= 0.0 && p_yaw_limit <= MAX_YAW_LIMIT), false,
			"A turret's limit is between 0 (none) and half a turn.");
	ERR_FAIL_COND_V_MSG(!(p_pitch_min < p_pitch_max && p_pitch_min > -1.5 && p_pitch_max < 1.5), false,
			"A gun's depression is below its elevation, both within 1.5 rad.");
	_drive.settings.yaw_rate = float(p_rates.x);
	_drive.settings.pitch_rate = float(p_rates.y);
	_drive.settings.yaw_acceleration = float(p_accelerations.x);
	_drive.settings.pitch_acceleration = float(p_accelerations.y);
	_drive.settings.yaw_limit = float(p_yaw_limit);
	_drive.settings.pitch_min = float(p_pitch_min);
	_drive.settings.pitch_max = float(p_pitch_max);
	return true;
}

void TurretDrive::step(
		const Transform3D &p_hull, const Vector3 &p_hull_rate, double p_yaw, double p_pitch, double p_delta) {
	const Quaternion turn = p_hull.basis.get_rotation_quaternion();
	_drive.step({ float(turn.x), float(turn.y), float(turn.z), float(turn.w) },
			{ float(p_hull_rate.x), float(p_hull_rate.y), float(p_hull_rate.z) }, float(p_yaw), float(p_pitch),
			float(p_delta));
}

void TurretDrive::place(double p_yaw, double p_pitch) {
	if (std::isfinite(p_yaw) && std::isfinite(p_pitch)) {
		_drive.place(float(p_yaw), float(p_pitch));
	}
}

void TurretDrive::_bind_methods() {
	ClassDB::bind_method(D_METHOD("configure", "rates", "accelerations", "yaw_limit", "pitch_min", "pitch_max"),
			&TurretDrive::configure);
	ClassDB::bind_method(D_METHOD("step", "hull", "hull_rate", "yaw", "pitch", "delta"), &TurretDrive::step);
	ClassDB::bind_method(D_METHOD("place", "yaw", "pitch"), &TurretDrive::place);
	ClassDB::bind_method(D_METHOD("set_stabilised", "is_stabilised"), &TurretDrive::set_stabilised);
	ClassDB::bind_method(D_METHOD("is_stabilised"), &TurretDrive::is_stabilised);
	ClassDB::bind_method(D_METHOD("get_yaw"), &TurretDrive::get_yaw);
	ClassDB::bind_method(D_METHOD("get_pitch"), &TurretDrive::get_pitch);
	ClassDB::bind_method(D_METHOD("get_aim"), &TurretDrive::get_aim);
}

} // namespace godot
