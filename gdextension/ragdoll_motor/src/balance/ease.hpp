// SPDX-License-Identifier: MIT
#pragma once

#include "balance/balance.hpp"
#include "joint/controller.hpp"

#include <vector>

namespace ragdoll {

/// Nobody is at ease whose fastest limb the motion turns faster than this, rad/s.
constexpr float EASE_MAX_SPEED = 0.5f;

/// GROUNDED: lets the limbs above the legs of somebody who stands at ease give way: lowers their motors' torque
/// to what the balance leaves them.
/// @param p_now, p_next the motion at the beginning and at the end of the step
void ease_limbs(const Rig &p_rig, const Balance &p_balance, const RigState &p_state, const Pose &p_now,
		const Pose &p_next, float p_delta_s, std::vector<LimbCommand> &r_commands);

} // namespace ragdoll
