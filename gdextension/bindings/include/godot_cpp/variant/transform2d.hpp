// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/variant/vector2.hpp>

namespace godot {

/// A position and an orientation in the plane: x axis, y axis, origin.
struct Transform2D {
	Vector2 columns[3] = { Vector2(1, 0), Vector2(0, 1), Vector2(0, 0) };

	constexpr Transform2D() = default;
	constexpr Transform2D(const Vector2 &p_x_axis, const Vector2 &p_y_axis, const Vector2 &p_origin) :
			columns{ p_x_axis, p_y_axis, p_origin } {}

	Vector2 &operator[](int p_column) { return columns[p_column]; }
	constexpr const Vector2 &operator[](int p_column) const { return columns[p_column]; }
	constexpr bool operator==(const Transform2D &p_other) const {
		return columns[0] == p_other.columns[0] && columns[1] == p_other.columns[1] && columns[2] == p_other.columns[2];
	}
	constexpr bool operator!=(const Transform2D &p_other) const { return !(*this == p_other); }
};

} // namespace godot
