// SPDX-License-Identifier: MIT
#pragma once

#include "base/vectors.hpp"

namespace ragdoll {

/// What stands in people's way. The world answers.
class Obstacles {
public:
	Obstacles() = default;
	Obstacles(const Obstacles &) = default;
	Obstacles &operator=(const Obstacles &) = default;
	virtual ~Obstacles() = default;

	/// Whether a limb's body would meet something that does not give way if it were moved from a position of
	/// its centre (m) by so much (m).
	virtual bool is_in_way(
			std::size_t p_limb, const Quat &p_orientation, const Vec3 &p_centre, const Vec3 &p_motion) const = 0;
};

} // namespace ragdoll
