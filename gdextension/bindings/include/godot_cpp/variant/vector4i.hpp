// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/core/defs.hpp>

namespace godot {

/// Four integers.
struct Vector4i {
	enum Axis {
		AXIS_X,
		AXIS_Y,
		AXIS_Z,
		AXIS_W,
	};

	int32_t x = 0;
	int32_t y = 0;
	int32_t z = 0;
	int32_t w = 0;

	constexpr Vector4i() = default;
	constexpr Vector4i(int32_t p_x, int32_t p_y, int32_t p_z, int32_t p_w) : x(p_x), y(p_y), z(p_z), w(p_w) {}

	constexpr bool operator==(const Vector4i &p_other) const {
		return x == p_other.x && y == p_other.y && z == p_other.z && w == p_other.w;
	}
	constexpr bool operator!=(const Vector4i &p_other) const { return !(*this == p_other); }
};

} // namespace godot
