// SPDX-License-Identifier: MIT
#pragma once

namespace vehicle {

/// How a tracked vehicle is steered: a double differential, which makes one track faster by what the other loses
/// (so the power of the inner track goes to the outer one), driven by a hydrostatic motor.
struct TrackSteeringSettings {
	float tread = 2.8f; ///< Between the middles of the tracks, m.
	float pivot_speed = 1.9f; ///< Of either track, in opposite ways, when it turns on the spot, m/s.
	float most_sideways = 3.5f; ///< Acceleration to the side that the driver is given at most, m/s^2.
	float force = 250e3f; ///< Of either track from steering at most, N.
	float response = 0.25f; ///< The time constant of the hydrostatic motor, s.
	float straightness = 3.0f; ///< How much a turn that nobody wants is steered against.
};

/// Forces that steering adds to the two tracks.
class TrackSteering {
public:
	TrackSteeringSettings settings;

	/// One step. p_steer is -1 (right) to 1 (left); p_speed the vehicle's, p_left and p_right the tracks' (m/s,
	/// forward positive), p_mass the vehicle's (kg), p_turning the hull's
	/// rate (rad/s), p_power what the engine can give (W).
	/// Returns the force on the right track (N); the left one gets its opposite.
	float step(float p_steer, float p_speed, float p_left, float p_right, float p_turning, float p_mass, float p_power,
			float p_delta);
	/// Difference of speed between the right and the left track that it is after now, m/s.
	float difference() const { return _difference; }
	void reset();

private:
	float _difference = 0.0f;
	float _sum = 0.0f; ///< The integral part of the force, N.
};

/// How wheels are steered.
struct WheelSteeringSettings {
	float max_angle = 0.6f; ///< Of a wheel in the middle of the vehicle, rad.
	float rate = 1.0f; ///< How fast the driver can turn it from the middle to the end, rad/s.
	float most_sideways = 5.0f; ///< Acceleration to the side that the driver is given at most, m/s^2.
	float wheelbase = 3.0f; ///< m.
};

/// Angle of steered wheels, and of each by Ackermann: the axles of all wheels meet in one point.
class WheelSteering {
public:
	WheelSteeringSettings settings;

	/// One step; returns the angle of a wheel in the middle, rad, to the left positive.
	float step(float p_steer, float p_speed, float p_delta);
	float angle() const { return _angle; }
	/// Angle of a wheel that stands p_ahead of the unsteered axle and p_right of the middle, m.
	float angle_at(float p_ahead, float p_right) const;
	void reset() { _angle = 0.0f; }

private:
	float _angle = 0.0f;
};

} // namespace vehicle
