// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace vehicle {

constexpr float RAD_S_PER_RPM = 0.104719755f;

/// A point of an engine's torque curve at full load.
struct TorquePoint {
	float rpm = 0.0f; ///< 1/min.
	float torque = 0.0f; ///< N m.
};

/// What an engine is.
struct EngineSettings {
	/// At full load, by rising speed. Between two points it is straight, beyond the ends it is none.
	std::vector<TorquePoint> curve;
	float idle_rpm = 700.0f; ///< Held by the governor while nobody accelerates, 1/min.
	float max_rpm = 2600.0f; ///< The governor allows no more, 1/min.
	float inertia = 5.0f; ///< Of all that turns with the crankshaft, kg m^2.
	float friction = 400.0f; ///< Torque that the engine itself takes at its highest speed, N m: what it brakes with.
	/// How fast the fuel follows the pedal, s: the time constant of pump and turbocharger.
	float response = 0.3f;
};

/// A combustion engine with a governor for the idle and the highest speed.
class Engine {
public:
	EngineSettings settings;

	/// Torque at full load at a speed, N m.
	float full_torque(float p_rpm) const;
	/// Torque that friction and pumping take at a speed, N m.
	float drag_torque(float p_rpm) const;
	/// One step: the speed changes by what is left of the torque when the load has its part. Returns the torque
	/// at the shaft before the load, N m. p_load_slope is by how much the load grows with the speed, N m s: the
	/// step is implicit in it, so a stiff coupling does not make the speed swing.
	float step(float p_throttle, float p_load, float p_load_slope, float p_delta);
	/// The same for an engine whose speed something else decides: a clutch that is shut.
	float step_locked(float p_throttle, float p_rpm, float p_delta);

	/// 1/min.
	float rpm() const { return _rpm; }
	/// Share of the full torque that is called for now, 0 to 1.
	float load() const { return _load; }
	/// Torque at the shaft before the load, N m.
	float torque() const { return _torque; }
	void set_running(bool p_running);
	bool is_running() const { return _is_running; }
	/// At idle speed, without load.
	void reset();

private:
	float idle_share() const;
	float fuel(float p_throttle, float p_delta);
	float shaft_torque() const;

	float _rpm = 0.0f;
	float _load = 0.0f;
	float _torque = 0.0f;
	bool _is_running = true;
};

} // namespace vehicle
