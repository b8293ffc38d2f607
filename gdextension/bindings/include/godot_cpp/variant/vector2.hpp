// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/core/math.hpp>
#include <godot_cpp/variant/vector2i.hpp>

namespace godot {

/// A direction or a point in two dimensions.
struct Vector2 {
	enum Axis {
		AXIS_X,
		AXIS_Y,
	};

	real_t x = 0;
	real_t y = 0;

	constexpr Vector2() = default;
	constexpr Vector2(real_t p_x, real_t p_y) : x(p_x), y(p_y) {}
	constexpr Vector2(const Vector2i &p_from) : x(real_t(p_from.x)), y(real_t(p_from.y)) {}

	real_t &operator[](int p_axis) { return p_axis == AXIS_X ? x : y; }
	const real_t &operator[](int p_axis) const { return p_axis == AXIS_X ? x : y; }

	constexpr Vector2 operator-() const { return Vector2(-x, -y); }
	constexpr Vector2 operator+(const Vector2 &p_other) const { return Vector2(x + p_other.x, y + p_other.y); }
	constexpr Vector2 operator-(const Vector2 &p_other) const { return Vector2(x - p_other.x, y - p_other.y); }
	constexpr Vector2 operator*(const Vector2 &p_other) const { return Vector2(x * p_other.x, y * p_other.y); }
	constexpr Vector2 operator*(real_t p_factor) const { return Vector2(x * p_factor, y * p_factor); }
	constexpr Vector2 operator/(real_t p_divisor) const { return Vector2(x / p_divisor, y / p_divisor); }
	Vector2 &operator+=(const Vector2 &p_other) { return *this = *this + p_other; }
	Vector2 &operator-=(const Vector2 &p_other) { return *this = *this - p_other; }
	constexpr bool operator==(const Vector2 &p_other) const { return x == p_other.x && y == p_other.y; }
	constexpr bool operator!=(const Vector2 &p_other) const { return !(*this == p_other); }

	constexpr real_t dot(const Vector2 &p_with) const { return x * p_with.x + y * p_with.y; }
	constexpr real_t cross(const Vector2 &p_with) const { return x * p_with.y - y * p_with.x; }
	constexpr real_t length_squared() const { return x * x + y * y; }
	real_t length() const { return std::sqrt(length_squared()); }
	real_t angle() const { return std::atan2(y, x); }
	/// Length one in the same direction; the zero vector stays what it is.
	Vector2 normalized() const {
		const real_t squared = length_squared();
		return squared == 0 ? Vector2() : *this / std::sqrt(squared);
	}
	bool is_equal_approx(const Vector2 &p_other) const {
		return Math::is_equal_approx(x, p_other.x) && Math::is_equal_approx(y, p_other.y);
	}
	bool is_finite() const { return Math::is_finite(x) && Math::is_finite(y); }
};

} // namespace godot
