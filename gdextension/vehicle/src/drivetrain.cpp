// SPDX-License-Identifier: MIT
#include "drivetrain.hpp"

#include <algorithm>
#include <cmath>

namespace vehicle {

namespace {

constexpr float DEAD = 0.02f; ///< Pedals and stick below this are not touched.
constexpr float STANDS = 0.4f; ///< Below this (m/s) it stands: it holds itself, and may change its direction.
/// Who turns on the spot as fast as he can runs the engine at such a share of its range.
constexpr float PIVOT_RANGE = 0.5f;
constexpr float PIVOT_BAND = 0.15f; ///< Share of the speed over which the gas comes.
constexpr float POWER_SHARE = 0.8f; ///< Of the engine's power that steering may take.
constexpr float HILL_RESERVE = 1.05f;
constexpr float SMOOTHING = 0.15f; ///< Of the acceleration, s.

float within(float p_value, float p_low, float p_high) {
	return std::isfinite(p_value) ? std::clamp(p_value, p_low, p_high) : 0.0f;
}

} // namespace

DriverInput DriverInput::limited() const {
	return { within(throttle, -1.0f, 1.0f), within(steer, -1.0f, 1.0f), within(brake, 0.0f, 1.0f),
		within(parking, 0.0f, 1.0f), selector };
}

int Drivetrain::direction_of(const DriverInput &p_input, float p_speed) {
	_throttle = std::abs(p_input.throttle);
	_brake = p_input.brake;
	switch (p_input.selector) {
		case Selector::NEUTRAL:
			return 0;
		case Selector::FORWARD:
		case Selector::REVERSE: {
			// A pedal drawn back is a brake here.
			_brake = std::max(_brake, -p_input.throttle);
			_throttle = std::max(0.0f, p_input.throttle);
			const int wanted = p_input.selector == Selector::FORWARD ? 1 : -1;
			return p_speed * float(wanted) < -STANDS ? 0 : wanted;
		}
		case Selector::AUTOMATIC:
			break;
	}
	if (_throttle < DEAD) {
		return _direction == 0 ? 1 : _direction;
	}
	const int wanted = p_input.throttle > 0.0f ? 1 : -1;
	if (p_speed * float(wanted) < -STANDS) {
		_brake = std::max(_brake, _throttle);
		_throttle = 0.0f;
		return _direction == 0 ? -wanted : _direction;
	}
	return wanted;
}

float Drivetrain::pivot_gas(float p_steer) const {
	const float idle = engine.settings.idle_rpm;
	const float wanted = idle + PIVOT_RANGE * std::abs(p_steer) * (engine.settings.max_rpm - idle);
	const float full = std::max(engine.full_torque(engine.rpm()), 1.0f);
	const float carried = (gearbox.neutral_load + engine.drag_torque(engine.rpm())) / full;
	return std::clamp((wanted - engine.rpm()) / (wanted * PIVOT_BAND) + carried, 0.0f, 1.0f);
}

const SideForces &Drivetrain::step(const DriverInput &p_input, const DriveMotion &p_motion, float p_delta) {
	const DriverInput input = p_input.limited();
	const float blend = std::min(1.0f, p_delta / SMOOTHING);
	_acceleration += ((p_motion.speed - _last_speed) / p_delta - _acceleration) * blend;
	_last_speed = p_motion.speed;
	_direction = direction_of(input, p_motion.speed);
	_throttle = engine.is_running() ? _throttle : 0.0f;
	// Who turns on the spot wants the engine to turn faster as well.
	const bool turns = settings.is_tracked && std::abs(input.steer) > DEAD && _throttle < DEAD;
	const bool pivots = turns && std::abs(p_motion.speed) < 2.0f * tracks.settings.pivot_speed;
	const float resistance = float(_direction) * (_drive - settings.mass * _acceleration);
	const float rim = 0.5f * (p_motion.left + p_motion.right);
	const int gear = pivots && _throttle < DEAD ? 0 : _direction;
	const float gas = gear == 0 && pivots ? pivot_gas(input.steer) : _throttle;
	const float engine_speed = std::max(engine.rpm(), 0.5f * engine.settings.idle_rpm) * RAD_S_PER_RPM;
	const float power = 0.5f * std::abs((_forces.right - _forces.left) * (p_motion.right - p_motion.left));
	gearbox.neutral_load = pivots && engine_speed > 1.0f ? power / (engine_speed * gearbox.settings.efficiency) : 0.0f;
	Shaft shaft = gearbox.step(engine, gear, gas, rim, settings.radius, resistance, p_delta);
	// What turns with the wheels takes its share of the force to be brought up to speed.
	const float share = 0.5f * std::abs(shaft.force);
	shaft.force -= std::clamp(shaft.rotating_mass * _acceleration, -share, share);
	_drive = shaft.force;
	_is_holding =
			_throttle < DEAD && !turns && std::abs(p_motion.speed) < STANDS && input.selector != Selector::NEUTRAL;
	// On a slope the brakes stay on until there is enough drive: the driver's foot, or hill hold.
	const float needed = float(_direction) * p_motion.uphill * HILL_RESERVE;
	const bool waits = _throttle >= DEAD && std::abs(p_motion.speed) < STANDS && float(_direction) * _drive < needed;
	_is_waiting = waits && input.selector != Selector::NEUTRAL;
	split(input, p_motion, shaft, p_delta);
	return _forces;
}

void Drivetrain::split(const DriverInput &p_input, const DriveMotion &p_motion, const Shaft &p_shaft, float p_delta) {
	float drive = p_shaft.force;
	float parking = p_input.parking * settings.parking_force;
	if (_is_holding || _is_waiting) {
		parking = settings.parking_force; // It holds itself where it stands, as converters and drivers do.
		drive = 0.0f;
	}
	const float brake = _brake * settings.brake_force;
	_forces = { 0.5f * drive, 0.5f * drive, 0.5f * brake, 0.5f * brake, 0.5f * parking, 0.5f * parking };
	if (!settings.is_tracked) {
		wheels.step(p_input.steer, p_motion.speed, p_delta);
		return;
	}
	// In reverse the nose goes the other way, as it does in a car.
	const bool is_back = _direction < 0 && p_motion.speed < STANDS && _throttle >= DEAD;
	const float steer = is_back ? -p_input.steer : p_input.steer;
	// A part of the power is kept back, with which the engine can still speed up.
	const float power =
			POWER_SHARE * engine.full_torque(engine.rpm()) * engine.rpm() * RAD_S_PER_RPM * gearbox.settings.efficiency;
	const float turning = tracks.step(_is_holding ? 0.0f : steer, p_motion.speed, p_motion.left, p_motion.right,
			p_motion.turning, settings.mass, power, p_delta);
	if (_is_holding || !engine.is_running()) {
		tracks.reset();
		return;
	}
	if (_throttle < DEAD && std::abs(p_input.steer) > DEAD && gearbox.gear() == 0) {
		// On the spot the differential's carrier is held: the tracks' mean is to be zero.
		const float mean = 0.5f * (p_motion.left + p_motion.right);
		const float hold = std::clamp(
				-mean * 0.05f * settings.mass / p_delta, -0.5f * settings.parking_force, 0.5f * settings.parking_force);
		_forces.left += 0.5f * hold;
		_forces.right += 0.5f * hold;
	}
	_forces.left -= turning;
	_forces.right += turning;
}

void Drivetrain::reset() {
	engine.reset();
	gearbox.reset();
	tracks.reset();
	wheels.reset();
	_forces = {};
	_direction = 1;
	_last_speed = 0.0f;
	_acceleration = 0.0f;
	_drive = 0.0f;
}

} // namespace vehicle
