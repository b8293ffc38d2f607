// SPDX-License-Identifier: MIT
#pragma once

#include <coding/person_codec.hpp>

#include <random>

/// People to test the coding with.
namespace people {

using namespace wire;

/// The limbs of scripts/core/limbs.gd.
inline Skeleton skeleton() {
	constexpr int PARENTS[16] = { -1, 0, 1, 2, 2, 4, 5, 2, 7, 8, 0, 10, 11, 0, 13, 14 };
	Skeleton body;
	body.limb_count = 16;
	for (std::size_t i = 0; i < 16; i++) {
		body.parents[i] = PARENTS[i];
	}
	return body;
}

inline float draw(std::mt19937 &p_random, float p_most) {
	return std::uniform_real_distribution<float>(-p_most, p_most)(p_random);
}

inline Quat draw_rotation(std::mt19937 &p_random) {
	std::normal_distribution<float> normal;
	return Quat{ normal(p_random), normal(p_random), normal(p_random), normal(p_random) + 1e-6f }.normalized();
}

inline PersonPose draw_pose(std::mt19937 &p_random) {
	PersonPose pose;
	pose.root = { draw(p_random, 100.0f), draw(p_random, 3.0f), draw(p_random, 100.0f) };
	for (Quat &rotation : pose.orientations) {
		rotation = draw_rotation(p_random);
	}
	return pose;
}

/// The pose a while later: all limbs turn by up to so many radians about any axis.
inline PersonPose moved(std::mt19937 &p_random, const PersonPose &p_pose, float p_most) {
	PersonPose pose = p_pose;
	pose.root = pose.root + Vec3{ draw(p_random, p_most), draw(p_random, p_most), draw(p_random, p_most) };
	for (Quat &rotation : pose.orientations) {
		const Vec3 turn{ draw(p_random, p_most), draw(p_random, p_most), draw(p_random, p_most) };
		rotation = (rotation * kinematics::exp(turn)).normalized();
	}
	return pose;
}

/// The greatest error of any limb, degrees, measured in double precision.
inline double error_of(const PersonPose &p_pose, const PersonPose &p_other, int p_limbs) {
	double most = 0.0;
	for (std::size_t i = 0; i < std::size_t(p_limbs); i++) {
		const Quat a = p_pose.orientations[i];
		const Quat b = p_other.orientations[i];
		const double sign = a.dot(b) < 0.0f ? -1.0 : 1.0;
		const double d[4] = { a.x - sign * b.x, a.y - sign * b.y, a.z - sign * b.z, a.w - sign * b.w };
		const double chord = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2] + d[3] * d[3]);
		most = std::max(most, 4.0 * std::asin(std::min(chord / 2.0, 1.0)) * 180.0 / 3.14159265358979);
	}
	return most;
}

/// Whether two states are the same, as far as a skeleton goes.
inline bool same(const PersonState &p_state, const PersonState &p_other, int p_limbs) {
	bool equal = p_state.root == p_other.root;
	for (std::size_t i = 0; i < std::size_t(p_limbs); i++) {
		equal = equal && p_state.limbs[i] == p_other.limbs[i];
	}
	return equal;
}

} // namespace people
