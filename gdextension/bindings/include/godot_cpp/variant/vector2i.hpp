// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/core/defs.hpp>

namespace godot {

/// A cell of a grid in two dimensions.
struct Vector2i {
	enum Axis {
		AXIS_X,
		AXIS_Y,
	};

	int32_t x = 0;
	int32_t y = 0;

	constexpr Vector2i() = default;
	constexpr Vector2i(int32_t p_x, int32_t p_y) : x(p_x), y(p_y) {}

	int32_t &operator[](int p_axis) { return p_axis == AXIS_X ? x : y; }
	const int32_t &operator[](int p_axis) const { return p_axis == AXIS_X ? x : y; }

	constexpr Vector2i operator-() const { return Vector2i(-x, -y); }
	constexpr Vector2i operator+(const Vector2i &p_other) const { return Vector2i(x + p_other.x, y + p_other.y); }
	constexpr Vector2i operator-(const Vector2i &p_other) const { return Vector2i(x - p_other.x, y - p_other.y); }
	constexpr Vector2i operator*(int32_t p_factor) const { return Vector2i(x * p_factor, y * p_factor); }
	constexpr bool operator==(const Vector2i &p_other) const { return x == p_other.x && y == p_other.y; }
	constexpr bool operator!=(const Vector2i &p_other) const { return !(*this == p_other); }
};

} // namespace godot
