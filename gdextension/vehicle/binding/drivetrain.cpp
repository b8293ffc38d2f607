// SPDX-License-Identifier: MIT
#include "drivetrain.hpp"

#include <utility>

namespace godot {

void VehicleDrivetrain::set_vehicle(
		double p_mass, double p_wheel_radius, double p_brake_force, double p_parking_force) {
	ERR_FAIL_COND_MSG(!(p_mass > 0.0 && p_wheel_radius > 0.0),
			"VehicleDrivetrain: the mass and the radius of the wheels must be above zero.");
	_core.settings.mass = float(p_mass);
	_core.settings.radius = float(p_wheel_radius);
	_core.settings.brake_force = float(p_brake_force);
	_core.settings.parking_force = float(p_parking_force);
}

void VehicleDrivetrain::set_engine(const PackedVector2Array &p_curve, double p_idle_rpm, double p_max_rpm,
		double p_inertia, double p_friction, double p_response) {
	ERR_FAIL_COND_MSG(!(p_max_rpm > 0.0 && p_inertia > 0.0),
			"VehicleDrivetrain: the engine's highest speed and inertia must be above zero.");
	vehicle::EngineSettings settings;
	for (const Vector2 &point : p_curve) {
		settings.curve.push_back({ point.x, point.y });
	}
	settings.idle_rpm = float(p_idle_rpm);
	settings.max_rpm = float(p_max_rpm);
	settings.inertia = float(p_inertia);
	settings.friction = float(p_friction);
	settings.response = float(p_response);
	_core.engine.settings = std::move(settings);
	_core.engine.reset();
}

void VehicleDrivetrain::set_gearbox(const PackedFloat32Array &p_forward, const PackedFloat32Array &p_reverse,
		double p_efficiency, double p_shift_time, double p_up_share, double p_down_share) {
	vehicle::GearboxSettings &settings = _core.gearbox.settings;
	settings.forward.assign(p_forward.ptr(), p_forward.ptr() + p_forward.size());
	settings.reverse.assign(p_reverse.ptr(), p_reverse.ptr() + p_reverse.size());
	settings.efficiency = float(p_efficiency);
	settings.shift_time = float(p_shift_time);
	settings.up_share = float(p_up_share);
	settings.down_share = float(p_down_share);
	_core.gearbox.reset();
}

void VehicleDrivetrain::set_converter(double p_stall_ratio, double p_stall_rpm, double p_lock_share) {
	vehicle::GearboxSettings &settings = _core.gearbox.settings;
	settings.stall_ratio = float(p_stall_ratio);
	settings.stall_rpm = float(p_stall_rpm);
	settings.lock_share = float(p_lock_share);
}

void VehicleDrivetrain::set_track_steering(
		double p_tread, double p_pivot_speed, double p_most_sideways, double p_force, double p_response) {
	_core.settings.is_tracked = true;
	_core.tracks.settings = { float(p_tread), float(p_pivot_speed), float(p_most_sideways), float(p_force),
		float(p_response) };
}

void VehicleDrivetrain::set_wheel_steering(
		double p_wheelbase, double p_max_angle, double p_rate, double p_most_sideways) {
	_core.settings.is_tracked = false;
	_core.wheels.settings = { float(p_max_angle), float(p_rate), float(p_most_sideways), float(p_wheelbase) };
}

void VehicleDrivetrain::set_input(
		double p_throttle, double p_steer, double p_brake, double p_parking, Selector p_selector) {
	_input.throttle = float(p_throttle);
	_input.steer = float(p_steer);
	_input.brake = float(p_brake);
	_input.parking = float(p_parking);
	_input.selector = vehicle::Selector(p_selector);
}

void VehicleDrivetrain::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_vehicle", "mass", "wheel_radius", "brake_force", "parking_force"),
			&VehicleDrivetrain::set_vehicle);
	ClassDB::bind_method(D_METHOD("set_engine", "curve", "idle_rpm", "max_rpm", "inertia", "friction", "response"),
			&VehicleDrivetrain::set_engine);
	ClassDB::bind_method(
			D_METHOD("set_gearbox", "forward", "reverse", "efficiency", "shift_time", "up_share", "down_share"),
			&VehicleDrivetrain::set_gearbox);
	ClassDB::bind_method(
			D_METHOD("set_converter", "stall_ratio", "stall_rpm", "lock_share"), &VehicleDrivetrain::set_converter);
	ClassDB::bind_method(D_METHOD("set_track_steering", "tread", "pivot_speed", "most_sideways", "force", "response"),
			&VehicleDrivetrain::set_track_steering);
	ClassDB::bind_method(D_METHOD("set_wheel_steering", "wheelbase", "max_angle", "rate", "most_sideways"),
			&VehicleDrivetrain::set_wheel_steering);
	ClassDB::bind_method(D_METHOD("set_input", "throttle", "steer", "brake", "parking", "selector"),
			&VehicleDrivetrain::set_input, DEFVAL(AUTOMATIC));
	ClassDB::bind_method(D_METHOD("set_running", "running"), &VehicleDrivetrain::set_running);
	ClassDB::bind_method(D_METHOD("is_running"), &VehicleDrivetrain::is_running);
	ClassDB::bind_method(D_METHOD("reset"), &VehicleDrivetrain::reset);
	ClassDB::bind_method(D_METHOD("get_rpm"), &VehicleDrivetrain::get_rpm);
	ClassDB::bind_method(D_METHOD("get_load"), &VehicleDrivetrain::get_load);
	ClassDB::bind_method(D_METHOD("get_torque"), &VehicleDrivetrain::get_torque);
	ClassDB::bind_method(D_METHOD("get_gear"), &VehicleDrivetrain::get_gear);
	ClassDB::bind_method(D_METHOD("get_brake"), &VehicleDrivetrain::get_brake);
	ClassDB::bind_method(D_METHOD("get_steer_angle"), &VehicleDrivetrain::get_steer_angle);
	ClassDB::bind_method(D_METHOD("get_left_force"), &VehicleDrivetrain::get_left_force);
	ClassDB::bind_method(D_METHOD("get_right_force"), &VehicleDrivetrain::get_right_force);
	BIND_ENUM_CONSTANT(AUTOMATIC);
	BIND_ENUM_CONSTANT(FORWARD);
	BIND_ENUM_CONSTANT(NEUTRAL);
	BIND_ENUM_CONSTANT(REVERSE);
}

} // namespace godot
