// SPDX-License-Identifier: MIT
#pragma once

// Comparisons with the engine's tolerances. For everything else there is <cmath>.

#include <godot_cpp/core/defs.hpp>

#include <cmath>

#define CMP_EPSILON 0.00001f
#define CMP_EPSILON2 (CMP_EPSILON * CMP_EPSILON)
#define UNIT_EPSILON 0.001f

namespace godot::Math {

inline bool is_equal_approx(real_t p_left, real_t p_right, real_t p_tolerance) {
	// The first test is for infinities of the same sign.
	return p_left == p_right || std::abs(p_left - p_right) < p_tolerance;
}

inline bool is_equal_approx(real_t p_left, real_t p_right) {
	const real_t relative = CMP_EPSILON * std::abs(p_left);
	return is_equal_approx(p_left, p_right, relative < CMP_EPSILON ? CMP_EPSILON : relative);
}

inline bool is_zero_approx(real_t p_value) {
	return std::abs(p_value) < CMP_EPSILON;
}

inline bool is_finite(real_t p_value) {
	return std::isfinite(p_value);
}

} // namespace godot::Math
