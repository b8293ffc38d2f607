// SPDX-License-Identifier: MIT
#pragma once

#include "body/rig.hpp"

namespace ragdoll {

/// What stands in people's way. The core asks; whoever knows the world implements it (ObstacleSweep).
class Obstacles {
public:
	Obstacles() = default;
	Obstacles(const Obstacles &) = default;
	Obstacles &operator=(const Obstacles &) = default;
	virtual ~Obstacles() = default;

	/// Whether a limb's body would meet something that does not give way, if it were moved by p_motion (m) from
	/// p_centre (m), the position of its centre.
	virtual bool is_in_way(
			std::size_t p_limb, const Quat &p_orientation, const Vec3 &p_centre, const Vec3 &p_motion) const = 0;
	/// Whether something that does not give way lies between two places (m).
	virtual bool is_between(const Vec3 & /*p_from*/, const Vec3 & /*p_to*/) const { return false; }
};

/// Whether something is in the way of the root's body as it is moved by p_motion (m).
/// @param p_obstacles null where nothing is known
inline bool blocks_root(const Obstacles *p_obstacles, const RigState &p_state, const Vec3 &p_motion) {
	return p_obstacles != nullptr && p_motion.is_finite() &&
			p_obstacles->is_in_way(0, p_state.orientations[0], p_state.centres[0], p_motion);
}

} // namespace ragdoll
