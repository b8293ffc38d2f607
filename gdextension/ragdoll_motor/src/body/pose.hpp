// SPDX-License-Identifier: MIT
#pragma once

#include "base/vectors.hpp"

#include <vector>

namespace ragdoll {

/// The target of every limb at one moment.
struct Pose {
	std::vector<Quat> orientations; ///< World orientation of each limb.
	Vec3 root; ///< World position of the root limb's joint, m.
};

} // namespace ragdoll
