// SPDX-License-Identifier: MIT
#pragma once

#include <quaternion.hpp>

namespace ragdoll {

using kinematics::angle_between;
using kinematics::exp;
using kinematics::from_axes;
using kinematics::log;
using kinematics::Quat;
using kinematics::slerp;
using kinematics::Vec3;

constexpr float PI = 3.14159265f;
constexpr float TAU = 6.28318531f;

/// What of a vector lies in the level.
inline Vec3 level(const Vec3 &p_vector) {
	return { p_vector.x, 0.0f, p_vector.z };
}

} // namespace ragdoll
