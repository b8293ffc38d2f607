// SPDX-License-Identifier: MIT
#pragma once

#include "quaternion.hpp"

#include <string>

namespace ragdoll {

/// What a limb collides as: the two kinds of the thesis (section 6.2).
struct LimbShape {
	enum class Type {
		PILL, ///< A capsule along its Y axis.
		BOX, ///< A box with its edges along its axes.
	};

	Type type = Type::PILL;
	float radius = 0.05f; ///< Of a pill, m.
	float length = 0.1f; ///< Of a pill's cylinder without its caps, m.
	Vec3 size{ 0.1f, 0.1f, 0.1f }; ///< Edge lengths of a box, m.

	/// Principal moments of inertia about the centre, in the shape's own axes, for a mass that is spread
	/// evenly, kg m^2.
	Vec3 inertia(float p_mass) const;
	/// Why this is no shape of a limb, or an empty text if it is one.
	std::string find_fault() const;
};

} // namespace ragdoll
