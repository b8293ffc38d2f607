// SPDX-License-Identifier: MIT
#pragma once

#include "balance/anatomy.hpp"

#include <vector>

namespace ragdoll {

/// How somebody lies who is to get up. On a side, whether he turns over to the face or to the back.
enum class Lie : int {
	FACE_UP,
	FACE_DOWN,
	LEFT_SIDE,
	RIGHT_SIDE,
	LEFT_BACK,
	RIGHT_BACK,
	KNEELS, ///< The hips are upright, the feet behind the knees.
};
constexpr int LIE_COUNT = 7;

/// What a stage is for.
enum class RisePart : int {
	TUCKING, ///< Limbs come to where they can push.
	ROLLING, ///< They bring the body over its feet.
	RISING, ///< It straightens up into the motion's pose.
};

/// One of the poses on the way up.
struct RiseStage {
	RisePart part = RisePart::TUCKING;
	float blend_s = 0.0f; ///< How long it takes to come to the pose.
	float most_s = 0.0f; ///< Who has not arrived after so long chooses another way.
	float within = 0.0f; ///< Arrived is whose hips are off by less than this, rad; 0: everybody.
	float torque = 0.0f; ///< Greatest torque from outside at the hips, as a vector, N m.
	/// How much of what the capture point is off the feet all but the feet lean the other way, 0 to 1. Where there is
	/// any, nobody arrives whose capture point is not over the feet.
	float lean = 0.0f;
	bool only_rolls = false; ///< The torque turns the hips about the body's length only.
	JointAngles pose; ///< Not of the last stage.
};

/// The stages on the way up. The last one of those who only turn over leads to nothing: they choose anew.
const std::vector<RiseStage> &get_stages(Lie p_lie);

} // namespace ragdoll
