// SPDX-License-Identifier: MIT
#pragma once

#include "person_state.hpp"

namespace wire {

/// A person's pose at a tick, as it was received.
struct PersonUpdate {
	uint32_t tick = 0; ///< The server's physics tick after which the pose held.
	uint16_t id = 0;
	PersonPose pose;
	uint16_t frame = 0; ///< Id of the body in whose frame the pose is, 0 for the world's.
};

/// A rigid body at a tick, as it was received.
struct BodyUpdate {
	uint32_t tick = 0;
	uint16_t id = 0;
	Vec3 position; ///< m
	Quat orientation;
	Vec3 velocity; ///< m/s
	Vec3 spin; ///< Angular velocity in the world, rad/s.
	bool at_rest = false; ///< It will stay there until an update says otherwise.
};

} // namespace wire
