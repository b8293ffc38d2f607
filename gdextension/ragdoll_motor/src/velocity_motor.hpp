// SPDX-License-Identifier: MIT
#pragma once

#include "pose_stream.hpp"
#include "quaternion.hpp"

#include <cstddef>
#include <vector>

namespace ragdoll {

/// Turns "where the limbs are, where they are to be" into target velocities for the joints' motors.
///
/// Each limb is driven relative to its parent: feed-forward with the velocity that the motion has
/// anyway, plus a correction proportional to the error. The target is the *motion's* parent-relative
/// orientation: targets computed from the simulated parent are unstable. What the thesis lacked in
/// section 8.3 (target speed only) is the feed-forward, and enough solver steps.
class VelocityMotor {
public:
	/// @param p_parents index of each limb's parent, which comes before it; -1 for the root
	explicit VelocityMotor(std::vector<int> p_parents);

	std::size_t limb_count() const { return parents.size(); }
	const std::vector<int> &get_parents() const { return parents; }

	/// Angular velocity of each limb relative to its parent, in the limb's own axes, rad/s.
	/// @param p_actual simulated world orientations
	/// @param p_now the motion at the beginning of the step
	/// @param p_next the motion at its end
	/// @param p_gain how fast errors are corrected, 1/s; never above 1 / p_delta_s
	void compute(const std::vector<Quat> &p_actual, const Pose &p_now, const Pose &p_next, float p_delta_s,
			float p_gain, std::vector<Vec3> &r_velocities) const;

	/// World positions of the limbs' joints for a pose, parent first (thesis section 8.1).
	/// @param p_anchors each limb's joint in its parent's frame, m; the root's is ignored
	void joint_positions(const Pose &p_pose, const std::vector<Vec3> &p_anchors, std::vector<Vec3> &r_positions) const;

private:
	std::vector<int> parents;
};

/// The linear velocity (m/s) that brings the root along: feed-forward plus correction, as above.
Vec3 root_velocity(const Vec3 &p_actual, const Vec3 &p_now, const Vec3 &p_next, float p_delta_s, float p_gain);

} // namespace ragdoll
