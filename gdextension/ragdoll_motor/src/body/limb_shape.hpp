// SPDX-License-Identifier: MIT
#pragma once

#include "base/vectors.hpp"

namespace ragdoll {

/// The solid that a limb is: a pill or a box around its centre.
struct LimbShape {
	enum class Type : int {
		NONE, ///< Not known: the limb is in nothing's way.
		PILL,
		BOX,
	};

	Type type = Type::NONE;
	Quat turn; ///< The shape's axes in the limb's frame; a pill runs along Y.
	Vec3 half; ///< Half of a box's sizes, m. Of a pill: its radius, half of its cylinder's length, its radius.
};

} // namespace ragdoll
