// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/core/math.hpp>

namespace godot {

/// Red, green, blue and opacity, each from 0 to 1 (or more, where it shines).
struct Color {
	float r = 0;
	float g = 0;
	float b = 0;
	float a = 1;

	constexpr Color() = default;
	constexpr Color(float p_r, float p_g, float p_b, float p_a = 1) : r(p_r), g(p_g), b(p_b), a(p_a) {}

	constexpr bool operator==(const Color &p_other) const {
		return r == p_other.r && g == p_other.g && b == p_other.b && a == p_other.a;
	}
	constexpr bool operator!=(const Color &p_other) const { return !(*this == p_other); }
	bool is_equal_approx(const Color &p_other) const {
		return Math::is_equal_approx(r, p_other.r) && Math::is_equal_approx(g, p_other.g) &&
				Math::is_equal_approx(b, p_other.b) && Math::is_equal_approx(a, p_other.a);
	}
};

} // namespace godot
