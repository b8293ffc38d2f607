// SPDX-License-Identifier: MIT
#pragma once

#include "body/rig.hpp"

namespace ragdoll {

/// What a straight line meets.
struct Hit {
	float share = 1.0f; ///< Of the line, where it is met.
	Vec3 normal; ///< Of its surface, away from it.
	Vec3 velocity; ///< Of its surface, m/s.
};

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
	/// Finds what does not give way and lies between two places (m). Returns whether there is anything.
	virtual bool find_between(const Vec3 & /*p_from*/, const Vec3 & /*p_to*/, Hit & /*r_hit*/) const { return false; }
	bool is_between(const Vec3 &p_from, const Vec3 &p_to) const {
		Hit hit;
		return find_between(p_from, p_to, hit);
	}
};

/// Whether something is in the way of the root's body as it is moved by p_motion (m).
/// @param p_obstacles null where nothing is known
inline bool blocks_root(const Obstacles *p_obstacles, const RigState &p_state, const Vec3 &p_motion) {
	return p_obstacles != nullptr && p_motion.is_finite() &&
			p_obstacles->is_in_way(0, p_state.orientations[0], p_state.centres[0], p_motion);
}

} // namespace ragdoll
