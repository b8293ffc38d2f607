// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/core/defs.hpp>

namespace godot {

/// A cell of a grid in three dimensions.
struct Vector3i {
	enum Axis {
		AXIS_X,
		AXIS_Y,
		AXIS_Z,
	};

	int32_t x = 0;
	int32_t y = 0;
	int32_t z = 0;

	constexpr Vector3i() = default;
	constexpr Vector3i(int32_t p_x, int32_t p_y, int32_t p_z) : x(p_x), y(p_y), z(p_z) {}

	int32_t &operator[](int p_axis) { return p_axis == AXIS_X ? x : (p_axis == AXIS_Y ? y : z); }
	const int32_t &operator[](int p_axis) const { return p_axis == AXIS_X ? x : (p_axis == AXIS_Y ? y : z); }

	constexpr Vector3i operator-() const { return Vector3i(-x, -y, -z); }
	constexpr Vector3i operator+(const Vector3i &p_other) const {
		return Vector3i(x + p_other.x, y + p_other.y, z + p_other.z);
	}
	constexpr Vector3i operator-(const Vector3i &p_other) const {
		return Vector3i(x - p_other.x, y - p_other.y, z - p_other.z);
	}
	constexpr Vector3i operator*(int32_t p_factor) const { return Vector3i(x * p_factor, y * p_factor, z * p_factor); }
	constexpr bool operator==(const Vector3i &p_other) const {
		return x == p_other.x && y == p_other.y && z == p_other.z;
	}
	constexpr bool operator!=(const Vector3i &p_other) const { return !(*this == p_other); }
};

} // namespace godot
