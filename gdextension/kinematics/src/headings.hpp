// SPDX-License-Identifier: MIT
#pragma once

#include "quaternion.hpp"

#include <cmath>

namespace kinematics {

// Headings: angles about +Y, rad; 0 faces +Z, as a person does in the reset pose.

constexpr float FULL_TURN = 6.28318531f;

/// What of a vector lies in the level.
inline Vec3 level(const Vec3 &p_vector) {
	return { p_vector.x, 0.0f, p_vector.z };
}

/// The turn to a heading.
inline Quat turn_of(float p_heading) {
	return { 0.0f, std::sin(0.5f * p_heading), 0.0f, std::cos(0.5f * p_heading) };
}

/// An angle between -pi and pi.
inline float wrapped(float p_angle) {
	return std::remainder(p_angle, FULL_TURN);
}

/// The heading of somebody with this rotation; as Rotations.facing_of in scripts.
inline float facing_of(const Quat &p_rotation) {
	const Vec3 front = p_rotation.rotate({ 0.0f, 0.0f, 1.0f });
	return std::atan2(front.x, front.z);
}

} // namespace kinematics
