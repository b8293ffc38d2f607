// SPDX-License-Identifier: MIT
#pragma once

#include "body/placement.hpp"

#include <algorithm>
#include <vector>

namespace fixtures {

/// The state of bodies in a pose, at rest or moved as a whole (m/s).
inline ragdoll::RigState state_of(
		const ragdoll::Rig &p_rig, const ragdoll::Pose &p_pose, const ragdoll::Vec3 &p_velocity = {}) {
	ragdoll::RigState state;
	state.resize(p_rig.size());
	std::vector<ragdoll::Vec3> joints;
	ragdoll::place_at_rest(p_rig, p_pose, joints, state);
	std::fill(state.linear.begin(), state.linear.end(), p_velocity);
	return state;
}

} // namespace fixtures
