// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/core/math.hpp>
#include <godot_cpp/variant/vector3i.hpp>

namespace godot {

/// A direction, a point or an angular velocity in three dimensions.
struct Vector3 {
	enum Axis {
		AXIS_X,
		AXIS_Y,
		AXIS_Z,
	};

	real_t x = 0;
	real_t y = 0;
	real_t z = 0;

	constexpr Vector3() = default;
	constexpr Vector3(real_t p_x, real_t p_y, real_t p_z) : x(p_x), y(p_y), z(p_z) {}
	constexpr Vector3(const Vector3i &p_from) : x(real_t(p_from.x)), y(real_t(p_from.y)), z(real_t(p_from.z)) {}
	operator Vector3i() const { return Vector3i(int32_t(x), int32_t(y), int32_t(z)); }

	real_t &operator[](int p_axis) { return p_axis == AXIS_X ? x : (p_axis == AXIS_Y ? y : z); }
	const real_t &operator[](int p_axis) const { return p_axis == AXIS_X ? x : (p_axis == AXIS_Y ? y : z); }

	constexpr Vector3 operator-() const { return Vector3(-x, -y, -z); }
	constexpr Vector3 operator+(const Vector3 &p_other) const {
		return Vector3(x + p_other.x, y + p_other.y, z + p_other.z);
	}
	constexpr Vector3 operator-(const Vector3 &p_other) const {
		return Vector3(x - p_other.x, y - p_other.y, z - p_other.z);
	}
	constexpr Vector3 operator*(const Vector3 &p_other) const {
		return Vector3(x * p_other.x, y * p_other.y, z * p_other.z);
	}
	constexpr Vector3 operator/(const Vector3 &p_other) const {
		return Vector3(x / p_other.x, y / p_other.y, z / p_other.z);
	}
	constexpr Vector3 operator*(real_t p_factor) const { return Vector3(x * p_factor, y * p_factor, z * p_factor); }
	constexpr Vector3 operator/(real_t p_divisor) const { return Vector3(x / p_divisor, y / p_divisor, z / p_divisor); }
	Vector3 &operator+=(const Vector3 &p_other) { return *this = *this + p_other; }
	Vector3 &operator-=(const Vector3 &p_other) { return *this = *this - p_other; }
	Vector3 &operator*=(const Vector3 &p_other) { return *this = *this * p_other; }
	Vector3 &operator/=(const Vector3 &p_other) { return *this = *this / p_other; }
	Vector3 &operator*=(real_t p_factor) { return *this = *this * p_factor; }
	Vector3 &operator/=(real_t p_divisor) { return *this = *this / p_divisor; }
	constexpr bool operator==(const Vector3 &p_other) const {
		return x == p_other.x && y == p_other.y && z == p_other.z;
	}
	constexpr bool operator!=(const Vector3 &p_other) const { return !(*this == p_other); }
	constexpr bool operator<(const Vector3 &p_other) const {
		return x != p_other.x ? x < p_other.x : (y != p_other.y ? y < p_other.y : z < p_other.z);
	}

	constexpr real_t dot(const Vector3 &p_with) const { return x * p_with.x + y * p_with.y + z * p_with.z; }
	constexpr Vector3 cross(const Vector3 &p_with) const {
		return Vector3(y * p_with.z - z * p_with.y, z * p_with.x - x * p_with.z, x * p_with.y - y * p_with.x);
	}
	constexpr real_t length_squared() const { return x * x + y * y + z * z; }
	real_t length() const { return std::sqrt(length_squared()); }
	real_t distance_to(const Vector3 &p_to) const { return (p_to - *this).length(); }
	real_t distance_squared_to(const Vector3 &p_to) const { return (p_to - *this).length_squared(); }
	Vector3 direction_to(const Vector3 &p_to) const { return (p_to - *this).normalized(); }
	real_t angle_to(const Vector3 &p_to) const { return std::atan2(cross(p_to).length(), dot(p_to)); }

	/// Length one in the same direction; the zero vector stays what it is.
	Vector3 normalized() const {
		const real_t squared = length_squared();
		return squared == 0 ? Vector3() : *this / std::sqrt(squared);
	}
	void normalize() { *this = normalized(); }
	bool is_normalized() const { return Math::is_equal_approx(length_squared(), 1, UNIT_EPSILON); }

	Vector3 abs() const { return Vector3(std::abs(x), std::abs(y), std::abs(z)); }
	Vector3 lerp(const Vector3 &p_to, real_t p_weight) const {
		return Vector3(x + (p_to.x - x) * p_weight, y + (p_to.y - y) * p_weight, z + (p_to.z - z) * p_weight);
	}
	Vector3 limit_length(real_t p_length = 1) const {
		const real_t now = length();
		return now > 0 && p_length < now ? *this / now * p_length : *this;
	}
	bool is_equal_approx(const Vector3 &p_other) const {
		return Math::is_equal_approx(x, p_other.x) && Math::is_equal_approx(y, p_other.y) &&
				Math::is_equal_approx(z, p_other.z);
	}
	bool is_zero_approx() const {
		return Math::is_zero_approx(x) && Math::is_zero_approx(y) && Math::is_zero_approx(z);
	}
	bool is_finite() const { return Math::is_finite(x) && Math::is_finite(y) && Math::is_finite(z); }
};

// One for each scalar, because an int or double would not choose between them by itself.
constexpr Vector3 operator*(float p_factor, const Vector3 &p_vector) {
	return p_vector * p_factor;
}
constexpr Vector3 operator*(double p_factor, const Vector3 &p_vector) {
	return p_vector * real_t(p_factor);
}
constexpr Vector3 operator*(int32_t p_factor, const Vector3 &p_vector) {
	return p_vector * real_t(p_factor);
}

} // namespace godot
