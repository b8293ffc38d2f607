// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/variant/vector3.hpp>

namespace godot {

/// A box along the axes.
struct AABB {
	Vector3 position;
	Vector3 size;

	constexpr AABB() = default;
	constexpr AABB(const Vector3 &p_position, const Vector3 &p_size) : position(p_position), size(p_size) {}

	constexpr bool operator==(const AABB &p_other) const {
		return position == p_other.position && size == p_other.size;
	}
	constexpr bool operator!=(const AABB &p_other) const { return !(*this == p_other); }
	constexpr Vector3 get_end() const { return position + size; }
};

} // namespace godot
