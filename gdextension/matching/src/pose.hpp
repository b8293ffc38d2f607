// SPDX-License-Identifier: MIT
#pragma once

#include <headings.hpp>
#include <quaternion.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

/// A walker's body from recorded motion: what is recorded, which moment of it fits, and how it is played.
///
/// Frames: Godot's, right-handed, Y up. Rotations are from the reset pose, in which a person faces +Z.
namespace matching {

using kinematics::exp;
using kinematics::facing_of;
using kinematics::log;
using kinematics::Quat;
using kinematics::turn_of;
using kinematics::Vec3;
using kinematics::wrapped;

constexpr float PI = 3.14159265359f;

/// Limbs in the order of scripts/core/limbs.gd.
enum Limb : std::size_t {
	HIPS,
	SPINE,
	CHEST,
	HEAD,
	LEFT_UPPER_ARM,
	LEFT_LOWER_ARM,
	LEFT_HAND,
	RIGHT_UPPER_ARM,
	RIGHT_LOWER_ARM,
	RIGHT_HAND,
	LEFT_UPPER_LEG,
	LEFT_LOWER_LEG,
	LEFT_FOOT,
	RIGHT_UPPER_LEG,
	RIGHT_LOWER_LEG,
	RIGHT_FOOT,
	LIMBS,
};

/// The leg's limbs of a side, 0 left, 1 right.
constexpr std::size_t thigh_of(std::size_t p_side) {
	return LEFT_UPPER_LEG + 3 * p_side;
}
constexpr std::size_t foot_of(std::size_t p_side) {
	return LEFT_FOOT + 3 * p_side;
}

/// The limb of the other side; the trunk's are their own.
constexpr std::size_t mirrored(std::size_t p_limb) {
	if (p_limb < LEFT_UPPER_ARM) {
		return p_limb;
	}
	const std::size_t within = (p_limb - LEFT_UPPER_ARM) % 6;
	return within < 3 ? p_limb + 3 : p_limb - 3;
}

/// A person at a moment.
struct Pose {
	Vec3 hips; ///< Where the hips are.
	std::array<Vec3, 2> ankles{}; ///< Where the ankles are, left and right.
	std::array<Quat, LIMBS> limbs{}; ///< Each limb's rotation from the reset pose.
};

/// The same direction with length 1; another one where there is none.
inline Vec3 unit(const Vec3 &p_vector, const Vec3 &p_else = { 0.0f, -1.0f, 0.0f }) {
	const float length = p_vector.length();
	return length > 1e-5f ? p_vector * (1.0f / length) : p_else;
}

/// A part of the way from one rotation to another, cheaply: for those that are close.
inline Quat blend(const Quat &p_from, const Quat &p_to, float p_share) {
	const float to = p_from.dot(p_to) < 0.0f ? -p_share : p_share;
	const float from = 1.0f - p_share;
	return Quat{ p_from.x * from + p_to.x * to, p_from.y * from + p_to.y * to, p_from.z * from + p_to.z * to,
		p_from.w * from + p_to.w * to }
			.normalized();
}

inline Vec3 blend(const Vec3 &p_from, const Vec3 &p_to, float p_share) {
	return p_from + (p_to - p_from) * p_share;
}

/// From 0 to 1, level at both ends.
inline float eased(float p_share) {
	const float share = p_share < 0.0f ? 0.0f : (p_share > 1.0f ? 1.0f : p_share);
	return share * share * (3.0f - 2.0f * share);
}

} // namespace matching
