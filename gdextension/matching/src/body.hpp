// SPDX-License-Identifier: MIT
#pragma once

#include "pose.hpp"

namespace matching {

/// What is known of a body's size: enough for legs that reach the ground. In the reset pose's axes, m.
struct Body {
	float hip_height = 1.0f; ///< Of the hips above the soles, with straight legs side by side.
	std::array<Vec3, 2> hip_joints{}; ///< From the hips to where the legs begin.
	float thigh = 0.44f;
	float shank = 0.44f;
	float ankle_height = 0.09f; ///< Of the ankles above the soles.
	float foot = 0.15f; ///< From the ankle to the ball, along the ground.

	/// A body of usual proportions by the height of the hips; lengths that are known (above 0) replace the usual ones.
	static Body of(float p_hip_height, float p_thigh = 0.0f, float p_shank = 0.0f, float p_foot = 0.0f);

	/// Finds the height of the hips.
	void measure();
	/// The ball of the foot and the heel from the ankle, on the sole.
	Vec3 ball() const { return { 0.0f, -ankle_height, foot }; }
	Vec3 heel() const { return { 0.0f, -ankle_height, -0.35f * foot }; }
	float leg() const { return thigh + shank; }
};

/// Bends a leg (hip joint, knee, ankle) so that the ankle is at a place in the world, as far as it reaches; the knee
/// stays on its side. Thigh and shank turn no more about their lengths than they must.
/// Returns where the ankle is.
Vec3 reach(const Vec3 &p_hip_joint, const Vec3 &p_ankle, float p_thigh, float p_shank, const Vec3 &p_front,
		Quat &r_thigh, Quat &r_shank);

/// Where the ankle of a side is, by the rotations of a pose.
Vec3 ankle_of(const Body &p_body, const Pose &p_pose, std::size_t p_side);

} // namespace matching
