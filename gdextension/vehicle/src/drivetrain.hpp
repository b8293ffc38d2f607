// SPDX-License-Identifier: MIT
#pragma once

#include "engine.hpp"
#include "gearbox.hpp"
#include "steering.hpp"

namespace vehicle {

/// Which way the driver wants to go.
enum class Selector {
	AUTOMATIC, ///< Forward or reverse as the pedal says, once the vehicle stands.
	FORWARD,
	NEUTRAL,
	REVERSE,
};

/// What the driver does. Anything that is not a number counts as nothing.
struct DriverInput {
	float throttle = 0.0f; ///< -1 to 1; below zero brakes, and drives back with the automatic selector.
	float steer = 0.0f; ///< -1 (right) to 1 (left).
	float brake = 0.0f; ///< 0 to 1.
	float parking = 0.0f; ///< 0 to 1.
	Selector selector = Selector::AUTOMATIC;

	/// The same within its limits.
	DriverInput limited() const;
};

/// What the drivetrain is told of the vehicle.
struct DriveMotion {
	float speed = 0.0f; ///< Of the hull, forward, m/s.
	float left = 0.0f; ///< Of the left track or wheels at the rim, m/s.
	float right = 0.0f; ///< Of the right ones, m/s.
	float turning = 0.0f; ///< About the hull's upward axis, rad/s, to the left positive.
	float uphill = 0.0f; ///< What gravity holds back, N: above zero where the vehicle looks uphill.
};

/// What is not engine, gearbox or steering.
struct DrivetrainSettings {
	float mass = 50e3f; ///< Of the whole vehicle, kg.
	float radius = 0.6f; ///< Of the wheels that the gears are made for, m.
	float brake_force = 300e3f; ///< Of all brakes together at the ground, N.
	float parking_force = 300e3f; ///< Of the parking brake, N.
	bool is_tracked = true;
};

/// Forces at the rims of the two sides, N. Drives are signed (forward positive), brakes are not.
struct SideForces {
	float left = 0.0f;
	float right = 0.0f;
	float left_brake = 0.0f;
	float right_brake = 0.0f;
	float left_parking = 0.0f;
	float right_parking = 0.0f;
};

/// From what the driver does to the forces at the rims of the two sides.
class Drivetrain {
public:
	Engine engine;
	Gearbox gearbox;
	TrackSteering tracks;
	WheelSteering wheels;
	DrivetrainSettings settings;

	const SideForces &step(const DriverInput &p_input, const DriveMotion &p_motion, float p_delta);
	const SideForces &forces() const { return _forces; }
	/// Where the brake is now, 0 to 1: also that of the pedal for driving back while it rolls forward.
	float brake() const { return _brake; }
	/// Whether nobody drives and the vehicle stands: it may go to sleep.
	bool is_at_rest() const { return _is_holding; }
	void reset();

private:
	int direction_of(const DriverInput &p_input, float p_speed);
	float pivot_gas(float p_steer) const;
	void split(const DriverInput &p_input, const DriveMotion &p_motion, const Shaft &p_shaft, float p_delta);

	SideForces _forces;
	int _direction = 1;
	float _throttle = 0.0f;
	float _brake = 0.0f;
	float _last_speed = 0.0f;
	float _acceleration = 0.0f; ///< m/s^2, smoothed.
	float _drive = 0.0f; ///< At the rims, N.
	bool _is_holding = false;
	bool _is_waiting = false; // For enough drive to start uphill.
};

} // namespace vehicle
