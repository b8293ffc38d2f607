// SPDX-License-Identifier: MIT
#pragma once

#include <drivetrain.hpp>

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_vector2_array.hpp>

namespace godot {

/// Engine, gearbox, brakes and steering of a vehicle. Documented in doc_classes/VehicleDrivetrain.xml.
class VehicleDrivetrain : public RefCounted {
	GDCLASS(VehicleDrivetrain, RefCounted)

public:
	enum Selector {
		AUTOMATIC,
		FORWARD,
		NEUTRAL,
		REVERSE,
	};

	void set_vehicle(double p_mass, double p_wheel_radius, double p_brake_force, double p_parking_force);
	void set_engine(const PackedVector2Array &p_curve, double p_idle_rpm, double p_max_rpm, double p_inertia,
			double p_friction, double p_response);
	void set_gearbox(const PackedFloat32Array &p_forward, const PackedFloat32Array &p_reverse, double p_efficiency,
			double p_shift_time, double p_up_share, double p_down_share);
	void set_converter(double p_stall_ratio, double p_stall_rpm, double p_lock_share);
	void set_track_steering(
			double p_tread, double p_pivot_speed, double p_most_sideways, double p_force, double p_response);
	void set_wheel_steering(double p_wheelbase, double p_max_angle, double p_rate, double p_most_sideways);

	void set_input(double p_throttle, double p_steer, double p_brake, double p_parking, Selector p_selector);
	void set_running(bool p_running) { _core.engine.set_running(p_running); }
	bool is_running() const { return _core.engine.is_running(); }
	void reset() { _core.reset(); }

	double get_rpm() const { return _core.engine.rpm(); }
	double get_load() const { return _core.engine.load(); }
	double get_torque() const { return _core.engine.torque(); }
	int64_t get_gear() const { return _core.gearbox.gear(); }
	double get_brake() const { return _core.brake(); }
	double get_steer_angle() const { return _core.settings.is_tracked ? 0.0 : _core.wheels.angle(); }
	double get_left_force() const { return _core.forces().left; }
	double get_right_force() const { return _core.forces().right; }

	// For running gears.
	void step(const vehicle::DriveMotion &p_motion, float p_delta) { _core.step(_input, p_motion, p_delta); }
	const vehicle::SideForces &get_forces() const { return _core.forces(); }
	const vehicle::Drivetrain &get_core() const { return _core; }

protected:
	static void _bind_methods();

private:
	vehicle::Drivetrain _core;
	vehicle::DriverInput _input;
};

} // namespace godot

VARIANT_ENUM_CAST(VehicleDrivetrain::Selector);
