// SPDX-License-Identifier: MIT
#pragma once

#include "washout_filter.hpp"

#include <cmath>

namespace cueing {

/// Fits value = c0 + c1 t + c2 t^2 to three numbers at once, by least squares with weights.
class Parabola {
public:
	/// A value at a time.
	void add(double p_time, double p_weight, const Triple &p_value) {
		add_row({ 1.0, p_time, p_time * p_time }, p_weight, p_value);
	}
	/// A rate of change at a time.
	void add_rate(double p_time, double p_weight, const Triple &p_rate) {
		add_row({ 0.0, 1.0, 2.0 * p_time }, p_weight, p_rate);
	}
	/// The three coefficients; false where what was added does not determine them.
	bool solve(Triple &r_value, Triple &r_rate, Triple &r_curve) const {
		const auto &m = _matrix;
		const double minors[3] = { m[1][1] * m[2][2] - m[1][2] * m[1][2], m[0][2] * m[1][2] - m[0][1] * m[2][2],
			m[0][1] * m[1][2] - m[0][2] * m[1][1] };
		const double determinant = m[0][0] * minors[0] + m[0][1] * minors[1] + m[0][2] * minors[2];
		if (!(std::fabs(determinant) > 1e-12 * m[0][0] * m[1][1] * m[2][2])) {
			return false;
		}
		const double inverse[3][3] = {
			{ minors[0], minors[1], minors[2] },
			{ minors[1], m[0][0] * m[2][2] - m[0][2] * m[0][2], m[0][1] * m[0][2] - m[0][0] * m[1][2] },
			{ minors[2], m[0][1] * m[0][2] - m[0][0] * m[1][2], m[0][0] * m[1][1] - m[0][1] * m[0][1] },
		};
		Triple *results[3] = { &r_value, &r_rate, &r_curve };
		for (int row = 0; row < 3; row++) {
			for (int axis = 0; axis < 3; axis++) {
				double sum = 0.0;
				for (int column = 0; column < 3; column++) {
					sum += inverse[row][column] * _right[column][axis];
				}
				(*results[row])[axis] = sum / determinant;
			}
		}
		return true;
	}

private:
	void add_row(const Triple &p_row, double p_weight, const Triple &p_value) {
		for (int i = 0; i < 3; i++) {
			for (int j = 0; j < 3; j++) {
				_matrix[i][j] += p_weight * p_row[i] * p_row[j];
				_right[i][j] += p_weight * p_row[i] * p_value[j];
			}
		}
	}

	double _matrix[3][3] = {};
	double _right[3][3] = {};
};

} // namespace cueing
