// SPDX-License-Identifier: MIT
#pragma once

#include "engine.hpp"

#include <vector>

namespace vehicle {

/// What a gearbox is, with the torque converter before it.
struct GearboxSettings {
	/// Turns of the input shaft for one of the wheel, first gear first: final drive and all.
	std::vector<float> forward;
	std::vector<float> reverse;
	float efficiency = 0.85f; ///< Share of the power that reaches the wheels.
	float shift_time = 0.5f; ///< For so long a shift interrupts the drive, s.
	float hold_time = 1.2f; ///< No shift comes sooner after another, s.
	float up_share = 0.94f; ///< Shifts up at such a share of the engine's highest speed with the pedal down.
	float down_share = 0.5f; ///< Shifts down below such a share with the pedal down.
	/// Torque of the converter's turbine over that of its pump when the vehicle stands; 1 and less: there is no
	/// converter, the shaft is the engine's own (an electric motor).
	float stall_ratio = 2.2f;
	float stall_rpm = 1700.0f; ///< Speed that the engine reaches at full load when the vehicle stands, 1/min.
	float lock_share = 0.85f; ///< From this ratio of turbine to pump on a clutch bridges the converter.
};

/// What drives the wheels.
struct Shaft {
	float force = 0.0f; ///< At the wheels' rims, all together, forward positive, N.
	float rotating_mass = 0.0f; ///< What turns with the wheels, as mass at their rims, kg.
};

/// An automatic gearbox behind a torque converter with a lock-up clutch.
class Gearbox {
public:
	GearboxSettings settings;
	/// Load on the engine while no gear is in, N m: steering on the spot.
	float neutral_load = 0.0f;

	/// One step of engine, converter and gears.
	///
	/// p_direction is 1 for driving forward, -1 for reverse, 0 for neutral; p_speed the wheels' rims' (m/s, forward
	/// positive), p_radius the wheels' (m), p_resistance the force that holds the vehicle back (N, against the
	/// way it is to go): it does not shift up where the next gear could not overcome it.
	Shaft step(Engine &r_engine, int p_direction, float p_throttle, float p_speed, float p_radius, float p_resistance,
			float p_delta);

	/// 1 and up forward, -1 and down reverse, 0 none.
	int gear() const { return _gear; }
	bool is_shifting() const { return _shift_left > 0.0f; }
	bool is_locked() const { return _is_locked; }
	/// Turns of the shaft for one of the wheel in a gear; negative in reverse.
	float ratio(int p_gear) const;
	/// Whether there is a torque converter.
	bool has_converter() const { return settings.stall_ratio > 1.0f; }
	void reset();

private:
	void choose(const Engine &p_engine, int p_direction, float p_throttle, float p_speed, float p_radius,
			float p_resistance, float p_delta);
	int best_change(const Engine &p_engine, int p_direction, float p_throttle, float p_speed, float p_radius,
			float p_resistance) const;
	Shaft through_converter(Engine &r_engine, float p_throttle, float p_turbine_rpm, float p_factor, float p_delta);

	int _gear = 0;
	int _wanted = 0;
	float _shift_left = 0.0f;
	float _since_shift = 1e3f;
	bool _is_locked = false;
};

} // namespace vehicle
