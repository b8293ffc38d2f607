// SPDX-License-Identifier: MIT
#pragma once

#include "quaternion.hpp"

#include <vector>

namespace level {

using kinematics::Vec3;

/// Rays from a point in the air of the light's grid.
constexpr int GRID_RAYS = 96;

/// Axes with z along a normal.
struct Frame {
	Vec3 x;
	Vec3 y;
	Vec3 z;
	Vec3 turn(const Vec3 &p_vector) const { return x * p_vector.x + y * p_vector.y + z * p_vector.z; }
};

/// Axes around a normal of unit length; near ones give near ones almost everywhere.
Frame frame_of(const Vec3 &p_normal);
/// Directions above the plane of x and y whose density falls with the cosine from z, evenly spread
/// (sunflower spiral, projected from the unit disc: Malley's method).
std::vector<Vec3> hemisphere(int p_count);
/// Directions to all sides, evenly spread.
std::vector<Vec3> sphere(int p_count);

} // namespace level
