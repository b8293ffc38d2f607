// SPDX-License-Identifier: MIT
#include "washout_filter.hpp"

#include "integrator.hpp"

#include <algorithm>
#include <cmath>

namespace cueing {

namespace {

/// Longer steps are cut into equal parts: then even the fastest filter that is allowed is exact to 1e-6.
constexpr double MAX_STEP = 0.005;
constexpr int UP = 1;

double limited(double p_value, double p_most) {
	return std::clamp(p_value, -p_most, p_most);
}

double between(double p_from, double p_to, double p_part) {
	return p_from + (p_to - p_from) * p_part;
}

} // namespace

bool Motion::is_finite() const {
	bool all = true;
	for (int axis = 0; axis < 3; axis++) {
		all = all && std::isfinite(specific_force[axis]) && std::isfinite(rates[axis]);
	}
	return all;
}

void WashoutFilter::reset() {
	const WashoutParameters kept = parameters;
	*this = WashoutFilter();
	parameters = kept;
}

const TranslationParameters &WashoutFilter::translation(int p_axis) const {
	return p_axis == UP ? parameters.vertical : parameters.horizontal;
}

void WashoutFilter::step(const Motion &p_motion, double p_seconds) {
	Triple force{};
	Triple rates{};
	for (int axis = 0; axis < 3; axis++) {
		const TranslationParameters &channel = translation(axis);
		const double at_rest = axis == UP ? GRAVITY : 0.0;
		force[axis] = channel.scale * limited(p_motion.specific_force[axis] - at_rest, channel.limit);
		rates[axis] = parameters.rotation.scale * limited(p_motion.rates[axis], parameters.rotation.limit);
	}
	const Triple force_before = _has_begun ? _force : force;
	const Triple rates_before = _has_begun ? _rates : rates;
	const int parts = std::max(1, int(std::ceil(p_seconds / MAX_STEP - 1e-9)));
	for (int part = 1; part <= parts; part++) {
		Triple force_then{};
		Triple rates_then{};
		for (int axis = 0; axis < 3; axis++) {
			force_then[axis] = between(force_before[axis], force[axis], double(part) / parts);
			rates_then[axis] = between(rates_before[axis], rates[axis], double(part) / parts);
		}
		if (part == 1) {
			_force = force_before;
			_rates = rates_before;
		}
		advance(force_then, rates_then, p_seconds / parts);
	}
	_has_begun = true;
}

void WashoutFilter::advance(const Triple &p_force, const Triple &p_rates, double p_seconds) {
	const RotationParameters &turn = parameters.rotation;
	const TiltParameters &tilt = parameters.tilt;
	for (int i = 0; i < 3; i++) {
		Axis &axis = _axes[i];
		const TranslationParameters &channel = translation(i);
		const double square = channel.frequency * channel.frequency;
		const double twice = 2.0 * channel.damping * channel.frequency;
		const Triple factors = { square * channel.third_pole, square + twice * channel.third_pole,
			twice + channel.third_pole };
		// The middle state is the position: it is the input by s / ((s^2 + ...) (s + third_pole)).
		const auto high_pass = [&factors](const Triple &p_state, double p_input) {
			return Triple{ p_state[1], p_state[2],
				p_input - factors[0] * p_state[0] - factors[1] * p_state[1] - factors[2] * p_state[2] };
		};
		axis.translation = integrate(axis.translation, high_pass, _force[i], p_force[i], p_seconds);
		_pose.position[i] = axis.translation[1];
		_velocity[i] = axis.translation[2];
		_acceleration[i] = high_pass(axis.translation, p_force[i])[2];

		const auto low_pass = [&tilt](const std::array<double, 2> &p_state, double p_input) {
			return std::array<double, 2>{ p_state[1],
				tilt.frequency * (tilt.frequency * (p_input - p_state[0]) - 2.0 * tilt.damping * p_state[1]) };
		};
		axis.low_pass = integrate(axis.low_pass, low_pass, _force[i], p_force[i], p_seconds);

		const double stiffness = turn.order == 2 ? turn.frequency * turn.frequency : 0.0;
		const double drag = turn.order == 2 ? 2.0 * turn.damping * turn.frequency : turn.frequency;
		const auto turning = [stiffness, drag](const std::array<double, 2> &p_state, double p_input) {
			return std::array<double, 2>{ p_state[1], p_input - stiffness * p_state[0] - drag * p_state[1] };
		};
		axis.rotation = integrate(axis.rotation, turning, _rates[i], p_rates[i], p_seconds);
	}
	_force = p_force;
	_rates = p_rates;
	advance_tilt(p_seconds);
	for (int i = 0; i < 3; i++) {
		_pose.attitude[i] = _axes[i].rotation[1] + _tilt[i];
	}
}

void WashoutFilter::advance_tilt(double p_seconds) {
	const TiltParameters &tilt = parameters.tilt;
	const double most = std::sin(std::min(tilt.max_angle, 1.5));
	const double step = tilt.max_rate * p_seconds;
	// Nose down for a force from the front to the back, right side up for one to the right.
	const Triple wanted = { -std::asin(limited(_axes[2].low_pass[0] / GRAVITY, most)), 0.0,
		std::asin(limited(_axes[0].low_pass[0] / GRAVITY, most)) };
	for (int i = 0; i < 3; i++) {
		_tilt[i] += limited(wanted[i] - _tilt[i], step);
	}
}

} // namespace cueing
