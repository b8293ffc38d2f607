// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

namespace heading {

/// A mean of angles that grows (of directions: Mardia and Jupp 2000).
struct AngleMean {
	double cosines = 0.0;
	double sines = 0.0;
	double weights = 0.0;
	int count = 0;

	/// Takes an angle, rad.
	void add(double p_angle, double p_weight) {
		cosines += p_weight * std::cos(p_angle);
		sines += p_weight * std::sin(p_angle);
		weights += p_weight;
		count++;
	}
	/// The mean, rad.
	double angle() const { return std::atan2(sines, cosines); }
	/// The standard deviation of the angles, rad.
	double spread() const {
		const double agree = std::hypot(sines, cosines) / std::max(weights, 1e-9);
		return std::sqrt(-2.0 * std::log(std::clamp(agree, 1e-9, 1.0)));
	}
};

} // namespace heading
