// SPDX-License-Identifier: MIT
#pragma once

#include "base/vectors.hpp"

namespace ragdoll {

/// A point of a body that may touch the ground (the sample points of thesis section 8.4.1, and those of
/// knees, hands, hips and the like).
struct ContactPoint {
	int limb = 0;
	Vec3 local; ///< In the limb's frame, m.
	float radius = 0.0f; ///< Of the flesh around it, m.
	bool sole = false; ///< One of a foot's.
};

} // namespace ragdoll
