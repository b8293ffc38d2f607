// SPDX-License-Identifier: MIT
#pragma once

#include "body/composite_inertia.hpp"
#include "joint/joint_drive.hpp"

#include <vector>

namespace ragdoll {

/// GROUNDED: lets the limbs above the legs of somebody who stands at ease give way to what touches them, and come
/// back.
///
/// Each joint becomes a spring with critical damping, whose stiffness is such that what hangs on it would swing with
/// p_frequency, taken at the end of the step (Tan, Liu, Turk 2011, "Stable proportional-derivative controllers",
/// eq. 4): its motor gets the speed that the spring leads to, and no more torque than that takes. The torque depends
/// on error and speed alone, without steps, so that a limb which leans on something comes to rest. (A motor that was
/// stronger on the way back gained energy from each touch: hands on a wall trembled with 111 deg/s.)
/// @param p_inertia in the pose that the bodies have
/// @param p_now, p_next the motion at the beginning and at the end of the step
/// @param p_share how much at ease somebody is, 0 to 1
/// @param p_frequency of the springs, Hz
void ease_limbs(const Rig &p_rig, const CompositeInertia &p_inertia, const RigState &p_state, const Pose &p_now,
		const Pose &p_next, float p_share, float p_frequency, float p_delta_s, std::vector<LimbCommand> &r_commands);

} // namespace ragdoll
