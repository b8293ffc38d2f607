// SPDX-License-Identifier: MIT
#include "engine.hpp"

#include <algorithm>
#include <cstddef>

namespace vehicle {

namespace {

/// The governors work over such a share of the speed that they hold.
constexpr float IDLE_BAND = 0.25f;
constexpr float MAX_BAND = 0.05f;

} // namespace

float Engine::full_torque(float p_rpm) const {
	const std::vector<TorquePoint> &curve = settings.curve;
	if (curve.empty() || p_rpm < curve.front().rpm || p_rpm > curve.back().rpm) {
		// Below the first point there is as much as at it, or the engine could never start to pull.
		return curve.empty() || p_rpm > curve.back().rpm ? 0.0f : curve.front().torque;
	}
	for (std::size_t i = 1; i < curve.size(); i++) {
		if (p_rpm <= curve[i].rpm) {
			const float width = curve[i].rpm - curve[i - 1].rpm;
			const float share = width > 0.0f ? (p_rpm - curve[i - 1].rpm) / width : 1.0f;
			return curve[i - 1].torque + share * (curve[i].torque - curve[i - 1].torque);
		}
	}
	return curve.back().torque;
}

float Engine::drag_torque(float p_rpm) const {
	const float share = std::clamp(p_rpm / settings.max_rpm, 0.0f, 2.0f);
	// A third of it is there at any speed; the rest grows with it (Heywood 1988, 13.3: a + b n).
	return p_rpm > 1.0f ? settings.friction * (0.33f + 0.67f * share) : 0.0f;
}

float Engine::idle_share() const {
	// As much fuel as makes up for the friction at idle.
	const float drag = drag_torque(settings.idle_rpm);
	return drag / std::max(drag + full_torque(settings.idle_rpm), 1e-3f);
}

float Engine::fuel(float p_throttle, float p_delta) {
	float wanted = 0.0f;
	if (_is_running) {
		const bool idles = settings.idle_rpm > 0.0f; // Electric motors do not.
		const float idle = !idles ? 0.0f : (settings.idle_rpm - _rpm) / (settings.idle_rpm * IDLE_BAND) + idle_share();
		const float most = (settings.max_rpm - _rpm) / (settings.max_rpm * MAX_BAND) + 1.0f;
		wanted = std::clamp(std::min(std::max(p_throttle, idle), most), 0.0f, 1.0f);
	}
	_load += (wanted - _load) * std::min(1.0f, p_delta / std::max(settings.response, p_delta));
	return _load;
}

float Engine::shaft_torque() const {
	return _load * full_torque(_rpm) - (1.0f - _load) * drag_torque(_rpm);
}

float Engine::step(float p_throttle, float p_load, float p_load_slope, float p_delta) {
	fuel(p_throttle, p_delta);
	_torque = shaft_torque();
	const float change = (_torque - p_load) * p_delta / (settings.inertia + p_load_slope * p_delta);
	_rpm = std::max(0.0f, _rpm + change / RAD_S_PER_RPM);
	return _torque;
}

float Engine::step_locked(float p_throttle, float p_rpm, float p_delta) {
	fuel(p_throttle, p_delta);
	_rpm = std::max(0.0f, p_rpm);
	_torque = shaft_torque();
	return _torque;
}

void Engine::set_running(bool p_running) {
	_is_running = p_running;
	if (p_running && _rpm < settings.idle_rpm) {
		_rpm = settings.idle_rpm;
	}
}

void Engine::reset() {
	_rpm = _is_running ? settings.idle_rpm : 0.0f;
	_load = 0.0f;
}

} // namespace vehicle
