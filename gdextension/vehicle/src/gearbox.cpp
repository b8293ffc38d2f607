// SPDX-License-Identifier: MIT
#include "gearbox.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace vehicle {

namespace {

constexpr float RPM_PER_RAD_S = 9.54929659f;
/// The lock-up clutch opens again when the turbine is slower than so much of what the pump may be at least.
constexpr float UNLOCK_RPM_SHARE = 1.15f;
/// A gear must overcome the resistance with so much to spare.
constexpr float RESERVE = 1.05f;
/// Share of the fuel that the engine gets while the gears change.
constexpr float SHIFT_FUEL = 0.4f;

} // namespace

float Gearbox::ratio(int p_gear) const {
	const std::vector<float> &gears = p_gear > 0 ? settings.forward : settings.reverse;
	const int index = std::abs(p_gear) - 1;
	if (p_gear == 0 || index >= int(gears.size())) {
		return 0.0f;
	}
	return p_gear > 0 ? gears[std::size_t(index)] : -gears[std::size_t(index)];
}

void Gearbox::reset() {
	_gear = 0;
	_wanted = 0;
	_shift_left = 0.0f;
	_since_shift = 1e3f;
	_is_locked = false;
}

int Gearbox::best_change(const Engine &p_engine, int p_direction, float p_throttle, float p_speed, float p_radius,
		float p_resistance) const {
	const int gear = std::abs(_gear);
	const int count = int((p_direction > 0 ? settings.forward : settings.reverse).size());
	const float along = std::max(0.0f, p_speed * float(p_direction));
	const auto rpm_in = [&](int p_in) {
		return along / p_radius * std::abs(ratio(p_in * p_direction)) * RPM_PER_RAD_S;
	};
	const float highest = p_engine.settings.max_rpm;
	// With little gas it shifts at lower speeds.
	const float ease = 0.6f + 0.4f * p_throttle;
	const float up = highest * settings.up_share * ease;
	const float down = highest * settings.down_share * ease;
	if (gear < count && rpm_in(gear) > up) {
		const float rpm = rpm_in(gear + 1);
		const float force = p_engine.full_torque(rpm) * std::abs(ratio((gear + 1) * p_direction)) / p_radius;
		if (force * settings.efficiency > p_resistance * RESERVE || p_throttle < 0.5f) {
			return gear + 1;
		}
	}
	if (gear > 1 && rpm_in(gear) < down && rpm_in(gear - 1) < up * 0.97f) {
		return gear - 1;
	}
	return gear;
}

void Gearbox::choose(const Engine &p_engine, int p_direction, float p_throttle, float p_speed, float p_radius,
		float p_resistance, float p_delta) {
	_since_shift += p_delta;
	if (_shift_left > 0.0f) {
		_shift_left -= p_delta;
		if (_shift_left <= 0.0f) {
			_gear = _wanted;
			_since_shift = 0.0f;
		}
		return;
	}
	const int way = _gear > 0 ? 1 : (_gear < 0 ? -1 : 0);
	if (way != p_direction) {
		_gear = p_direction; // Into first gear or reverse, or neutral: the clutches of standstill are quick.
		_is_locked = false;
		_since_shift = 0.0f;
		return;
	}
	if (p_direction == 0 || _since_shift < settings.hold_time) {
		return;
	}
	const int best = best_change(p_engine, p_direction, p_throttle, p_speed, p_radius, p_resistance) * p_direction;
	if (best != _gear) {
		_wanted = best;
		_shift_left = settings.shift_time;
		_is_locked = false;
	}
}

Shaft Gearbox::through_converter(
		Engine &r_engine, float p_throttle, float p_turbine_rpm, float p_factor, float p_delta) {
	const float pump = std::max(r_engine.rpm(), 1.0f);
	const float slip = std::clamp(p_turbine_rpm / pump, 0.0f, 1.5f);
	const float bridge = settings.lock_share;
	// The pump takes torque by the square of its speed (so much, that the engine at full load comes to the stall
	// speed), less and less as the turbine comes near its speed, and gives some back when it is overtaken.
	const float fall = slip < bridge ? 1.0f : std::clamp((1.0f - slip) / (1.0f - bridge), -1.0f, 1.0f);
	const float stall = r_engine.full_torque(settings.stall_rpm) / (settings.stall_rpm * settings.stall_rpm);
	const float pump_torque = stall * pump * pump * fall;
	const float slope = std::abs(2.0f * stall * pump * fall) * RPM_PER_RAD_S;
	r_engine.step(p_throttle, pump_torque, slope, p_delta);
	const float multiple = 1.0f + (settings.stall_ratio - 1.0f) * std::clamp(1.0f - slip / bridge, 0.0f, 1.0f);
	_is_locked = p_turbine_rpm > bridge * pump && p_turbine_rpm > r_engine.settings.idle_rpm * UNLOCK_RPM_SHARE;
	return { pump_torque * multiple * p_factor, 0.0f };
}

Shaft Gearbox::step(Engine &r_engine, int p_direction, float p_throttle, float p_speed, float p_radius,
		float p_resistance, float p_delta) {
	choose(r_engine, p_direction, p_throttle, p_speed, p_radius, p_resistance, p_delta);
	const float per_metre = ratio(_gear) / p_radius; // Turns of the shaft (rad) for a metre at the rim.
	const float shaft_rpm = p_speed * per_metre * RPM_PER_RAD_S;
	if (_gear == 0) {
		r_engine.step(p_throttle, neutral_load, 0.0f, p_delta);
		return {};
	}
	if (is_shifting()) {
		// The engine is brought to the speed of the next gear meanwhile, with little fuel.
		const float next =
				std::max(std::abs(p_speed * ratio(_wanted)) / p_radius * RPM_PER_RAD_S, r_engine.settings.idle_rpm);
		const float share = std::min(1.0f, p_delta / (_shift_left + p_delta));
		r_engine.step_locked(SHIFT_FUEL * p_throttle, r_engine.rpm() + share * (next - r_engine.rpm()), p_delta);
		return {};
	}
	const float factor = per_metre * settings.efficiency;
	if (!has_converter() || _is_locked) {
		_is_locked = !has_converter() || shaft_rpm > r_engine.settings.idle_rpm * UNLOCK_RPM_SHARE;
		const float torque = r_engine.step_locked(p_throttle, shaft_rpm, p_delta);
		// Losses help to brake: the wheels turn the shaft through them.
		return { torque > 0.0f ? torque * factor : torque * per_metre,
			r_engine.settings.inertia * per_metre * per_metre };
	}
	return through_converter(r_engine, p_throttle, std::max(0.0f, shaft_rpm), factor, p_delta);
}

} // namespace vehicle
