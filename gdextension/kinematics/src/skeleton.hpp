// SPDX-License-Identifier: MIT
#pragma once

#include "quaternion.hpp"

#include <array>

namespace kinematics {

/// Most limbs that a person can have.
constexpr int MAX_LIMBS = 32;

/// How the limbs of a person hang together. Parents come before their children, the root is first.
///
/// A limb's frame is that of its body: the origin is where the body's is, the axes are its bone's.
struct Skeleton {
	int limb_count = 0;
	std::array<int, MAX_LIMBS> parents{}; ///< Index of each limb's parent, -1 for the root.
	std::array<Vec3, MAX_LIMBS> joints_in_parent{}; ///< The joint in the parent's frame, m.
	std::array<Vec3, MAX_LIMBS> joints_in_limb{}; ///< The same joint in the limb's own frame, m.

	/// Whether every parent comes before its child and only the first limb has none.
	bool is_sound() const {
		if (limb_count < 1 || limb_count > MAX_LIMBS || parents[0] != -1) {
			return false;
		}
		for (int i = 1; i < limb_count; i++) {
			if (parents[std::size_t(i)] < 0 || parents[std::size_t(i)] >= i) {
				return false;
			}
		}
		return true;
	}
};

/// Where every limb of a person is.
struct PersonPose {
	Vec3 root; ///< Position of the root limb's frame in the world, m.
	std::array<Quat, MAX_LIMBS> orientations{}; ///< Orientation of each limb's frame in the world.
};

/// Positions of all limbs' frames in the world (m) by forward kinematics: joints have no gaps,
/// whatever the orientations (thesis section 6.3).
inline void position_limbs(
		const Skeleton &p_skeleton, const PersonPose &p_pose, std::array<Vec3, MAX_LIMBS> &r_positions) {
	r_positions[0] = p_pose.root;
	for (std::size_t i = 1; i < std::size_t(p_skeleton.limb_count); i++) {
		const std::size_t parent = std::size_t(p_skeleton.parents[i]);
		const Vec3 joint = r_positions[parent] + p_pose.orientations[parent].rotate(p_skeleton.joints_in_parent[i]);
		r_positions[i] = joint - p_pose.orientations[i].rotate(p_skeleton.joints_in_limb[i]);
	}
}

} // namespace kinematics
