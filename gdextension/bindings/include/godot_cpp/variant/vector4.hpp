// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/core/math.hpp>
#include <godot_cpp/variant/vector4i.hpp>

namespace godot {

/// Four reals.
struct Vector4 {
	enum Axis {
		AXIS_X,
		AXIS_Y,
		AXIS_Z,
		AXIS_W,
	};

	real_t x = 0;
	real_t y = 0;
	real_t z = 0;
	real_t w = 0;

	constexpr Vector4() = default;
	constexpr Vector4(real_t p_x, real_t p_y, real_t p_z, real_t p_w) : x(p_x), y(p_y), z(p_z), w(p_w) {}

	constexpr Vector4 operator+(const Vector4 &p_other) const {
		return Vector4(x + p_other.x, y + p_other.y, z + p_other.z, w + p_other.w);
	}
	constexpr Vector4 operator-(const Vector4 &p_other) const {
		return Vector4(x - p_other.x, y - p_other.y, z - p_other.z, w - p_other.w);
	}
	constexpr Vector4 operator*(real_t p_factor) const {
		return Vector4(x * p_factor, y * p_factor, z * p_factor, w * p_factor);
	}
	constexpr bool operator==(const Vector4 &p_other) const {
		return x == p_other.x && y == p_other.y && z == p_other.z && w == p_other.w;
	}
	constexpr bool operator!=(const Vector4 &p_other) const { return !(*this == p_other); }
	constexpr real_t dot(const Vector4 &p_with) const {
		return x * p_with.x + y * p_with.y + z * p_with.z + w * p_with.w;
	}
};

} // namespace godot
