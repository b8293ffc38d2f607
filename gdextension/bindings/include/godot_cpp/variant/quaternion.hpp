// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/variant/vector3.hpp>

namespace godot {

struct Basis;

/// A rotation, where it has length one.
struct Quaternion {
	real_t x = 0;
	real_t y = 0;
	real_t z = 0;
	real_t w = 1;

	constexpr Quaternion() = default;
	constexpr Quaternion(real_t p_x, real_t p_y, real_t p_z, real_t p_w) : x(p_x), y(p_y), z(p_z), w(p_w) {}
	/// By an angle in rad about an axis.
	Quaternion(const Vector3 &p_axis, real_t p_angle);
	/// The rotation of a basis that only rotates.
	Quaternion(const Basis &p_basis);

	constexpr Quaternion operator-() const { return Quaternion(-x, -y, -z, -w); }
	constexpr Quaternion operator+(const Quaternion &p_other) const {
		return Quaternion(x + p_other.x, y + p_other.y, z + p_other.z, w + p_other.w);
	}
	constexpr Quaternion operator-(const Quaternion &p_other) const {
		return Quaternion(x - p_other.x, y - p_other.y, z - p_other.z, w - p_other.w);
	}
	constexpr Quaternion operator*(real_t p_factor) const {
		return Quaternion(x * p_factor, y * p_factor, z * p_factor, w * p_factor);
	}
	constexpr Quaternion operator/(real_t p_divisor) const { return *this * (1 / p_divisor); }
	/// First the right-hand rotation, then this one.
	constexpr Quaternion operator*(const Quaternion &p_right) const {
		return Quaternion(w * p_right.x + x * p_right.w + y * p_right.z - z * p_right.y,
				w * p_right.y + y * p_right.w + z * p_right.x - x * p_right.z,
				w * p_right.z + z * p_right.w + x * p_right.y - y * p_right.x,
				w * p_right.w - x * p_right.x - y * p_right.y - z * p_right.z);
	}
	Quaternion &operator*=(const Quaternion &p_right) { return *this = *this * p_right; }
	constexpr bool operator==(const Quaternion &p_other) const {
		return x == p_other.x && y == p_other.y && z == p_other.z && w == p_other.w;
	}
	constexpr bool operator!=(const Quaternion &p_other) const { return !(*this == p_other); }

	constexpr real_t dot(const Quaternion &p_with) const {
		return x * p_with.x + y * p_with.y + z * p_with.z + w * p_with.w;
	}
	constexpr real_t length_squared() const { return dot(*this); }
	real_t length() const { return std::sqrt(length_squared()); }
	Quaternion normalized() const { return *this / length(); }
	void normalize() { *this = normalized(); }
	bool is_normalized() const { return Math::is_equal_approx(length_squared(), 1, UNIT_EPSILON); }
	bool is_equal_approx(const Quaternion &p_other) const {
		return Math::is_equal_approx(x, p_other.x) && Math::is_equal_approx(y, p_other.y) &&
				Math::is_equal_approx(z, p_other.z) && Math::is_equal_approx(w, p_other.w);
	}
	bool is_finite() const {
		return Math::is_finite(x) && Math::is_finite(y) && Math::is_finite(z) && Math::is_finite(w);
	}

	/// The opposite rotation; the length must be one.
	constexpr Quaternion inverse() const { return Quaternion(-x, -y, -z, w); }
	/// Rotates a vector; the length must be one.
	constexpr Vector3 xform(const Vector3 &p_vector) const {
		const Vector3 axis(x, y, z);
		const Vector3 turned = axis.cross(p_vector);
		return p_vector + ((turned * w) + axis.cross(turned)) * real_t(2);
	}
	constexpr Vector3 xform_inv(const Vector3 &p_vector) const { return inverse().xform(p_vector); }

	/// In rad.
	real_t angle_to(const Quaternion &p_to) const;
	/// In rad, from 0 to 2 pi.
	real_t get_angle() const;
	Vector3 get_axis() const;
	/// The rotation as axis times angle, in x, y and z.
	Quaternion log() const;
	/// The opposite of log().
	Quaternion exp() const;
	/// Along the shorter arc; both lengths must be one.
	Quaternion slerp(const Quaternion &p_to, real_t p_weight) const;
};

} // namespace godot
