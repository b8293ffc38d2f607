// SPDX-License-Identifier: MIT
#pragma once

#include "body/contact_point.hpp"
#include "body/rig.hpp"

#include <vector>

namespace ragdoll {

/// A leg: the limbs by their indices in the rig.
struct Leg {
	int foot = 0;
	int shin = 0;
	int thigh = 0;
};

/// The shortest rotation from one direction to another; none where they are opposite.
Quat rotation_between(const Vec3 &p_from, const Vec3 &p_to);

/// The legs of a body: limbs with soles, what they hang on, and what that hangs on.
std::vector<Leg> find_legs(const Rig &p_rig, const std::vector<ContactPoint> &p_contacts);

/// Moves the foot of a pose without turning it: two-bone inverse kinematics on thigh and shin. The knee
/// opens or closes about its own axis, then the whole leg swings. A leg that is too short lifts the foot
/// rather than drag it.
/// @param p_offset how far the ankle is moved, m
/// @param r_joints the pose's joints, m; those of shin and foot are brought up to date
void bend_leg(const Rig &p_rig, const Leg &p_leg, const Vec3 &p_offset, Pose &r_pose, std::vector<Vec3> &r_joints);

} // namespace ragdoll
