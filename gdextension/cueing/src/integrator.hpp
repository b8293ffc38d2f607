// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>

namespace cueing {

/// A state a step later (Runge and Kutta's rule of order 4), where p_slope(state, input) is its rate of change and
/// the input changes evenly.
template <std::size_t SIZE, class Slope>
std::array<double, SIZE> integrate(const std::array<double, SIZE> &p_state, const Slope &p_slope, double p_input_before,
		double p_input_after, double p_seconds) {
	const auto ahead = [&p_state](const std::array<double, SIZE> &p_rate, double p_time) {
		std::array<double, SIZE> state = p_state;
		for (std::size_t i = 0; i < SIZE; i++) {
			state[i] += p_rate[i] * p_time;
		}
		return state;
	};
	const double middle = 0.5 * (p_input_before + p_input_after);
	const std::array<double, SIZE> first = p_slope(p_state, p_input_before);
	const std::array<double, SIZE> second = p_slope(ahead(first, 0.5 * p_seconds), middle);
	const std::array<double, SIZE> third = p_slope(ahead(second, 0.5 * p_seconds), middle);
	const std::array<double, SIZE> fourth = p_slope(ahead(third, p_seconds), p_input_after);
	std::array<double, SIZE> mean{};
	for (std::size_t i = 0; i < SIZE; i++) {
		mean[i] = (first[i] + 2.0 * (second[i] + third[i]) + fourth[i]) / 6.0;
	}
	return ahead(mean, p_seconds);
}

} // namespace cueing
