// SPDX-License-Identifier: MIT
#pragma once

#include "body/rig.hpp"

#include <vector>

namespace ragdoll {

/// Puts bodies into a pose, at rest.
/// @param r_joints gets the pose's joints, m
void place_at_rest(const Rig &p_rig, const Pose &p_pose, std::vector<Vec3> &r_joints, RigState &r_state);

/// Gives bodies that have been put into the pose p_now the velocities with which they come to p_next.
/// @param r_joints_next gets the joints of p_next, m
void set_in_motion(const Rig &p_rig, const Pose &p_now, const Pose &p_next, float p_delta_s,
		std::vector<Vec3> &r_joints_next, RigState &r_state);

} // namespace ragdoll
