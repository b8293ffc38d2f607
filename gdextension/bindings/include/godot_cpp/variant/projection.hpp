// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/variant/vector4.hpp>

namespace godot {

/// A 4x4 matrix by its columns.
struct Projection {
	Vector4 columns[4] = { Vector4(1, 0, 0, 0), Vector4(0, 1, 0, 0), Vector4(0, 0, 1, 0), Vector4(0, 0, 0, 1) };

	constexpr Projection() = default;
	constexpr Projection(const Vector4 &p_x, const Vector4 &p_y, const Vector4 &p_z, const Vector4 &p_w) :
			columns{ p_x, p_y, p_z, p_w } {}

	Vector4 &operator[](int p_column) { return columns[p_column]; }
	constexpr const Vector4 &operator[](int p_column) const { return columns[p_column]; }
	constexpr bool operator==(const Projection &p_other) const {
		return columns[0] == p_other.columns[0] && columns[1] == p_other.columns[1] &&
				columns[2] == p_other.columns[2] && columns[3] == p_other.columns[3];
	}
	constexpr bool operator!=(const Projection &p_other) const { return !(*this == p_other); }
};

} // namespace godot
