// SPDX-License-Identifier: MIT
#pragma once

#include "body.hpp"

#include <quaternion.hpp>

#include <cmath>

namespace heading {

/// Where a limb points to, rad about the vertical, and how well that is defined, 0 to 1.
struct LimbHeading {
	double angle = 0.0;
	double defined = 0.0;
};

/// How far a limb is turned about the vertical (the twist of its rotation).
inline LimbHeading twist_of(const kinematics::Quat &p_rotation) {
	return { 2.0 * std::atan2(double(p_rotation.y), double(p_rotation.w)),
		std::hypot(double(p_rotation.y), double(p_rotation.w)) };
}

/// Which way the axis of a limb's knee points, which is to the left in the reset pose: thigh and shank
/// share it however the knee is bent and the leg is tilted.
inline LimbHeading hinge_of(const kinematics::Quat &p_rotation) {
	const kinematics::Vec3 axis = p_rotation.rotate({ 1.0f, 0.0f, 0.0f });
	return { std::atan2(-double(axis.z), double(axis.x)), std::hypot(double(axis.x), double(axis.z)) };
}

} // namespace heading
