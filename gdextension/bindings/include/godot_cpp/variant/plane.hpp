// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/variant/vector3.hpp>

namespace godot {

/// The points whose product with the normal is d.
struct Plane {
	Vector3 normal;
	real_t d = 0;

	constexpr Plane() = default;
	constexpr Plane(real_t p_a, real_t p_b, real_t p_c, real_t p_d) : normal(p_a, p_b, p_c), d(p_d) {}
	constexpr Plane(const Vector3 &p_normal, real_t p_d = 0) : normal(p_normal), d(p_d) {}

	constexpr bool operator==(const Plane &p_other) const { return normal == p_other.normal && d == p_other.d; }
	constexpr bool operator!=(const Plane &p_other) const { return !(*this == p_other); }
	constexpr real_t distance_to(const Vector3 &p_point) const { return normal.dot(p_point) - d; }
};

} // namespace godot
