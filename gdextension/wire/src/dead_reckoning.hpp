// SPDX-License-Identifier: MIT
#pragma once

#include "updates.hpp"

#include <algorithm>

namespace wire {

/// Nobody predicts a body for longer than this, s: then it stands where it got to.
constexpr float MAX_PREDICTION_S = 1.0f;

/// Where a body is.
struct BodyTransform {
	Vec3 position; ///< m
	Quat orientation;
};

/// Where a body is believed to be so many seconds after an update (0 to MAX_PREDICTION_S; more and
/// less are cut off): straight on at its velocity and spin. Server and clients use this one formula, so
/// that the server knows how wrong its clients are (dead reckoning: Aronson 1997, thesis section 7.2).
inline BodyTransform predict(const BodyUpdate &p_update, float p_seconds) {
	if (p_update.at_rest) {
		return { p_update.position, p_update.orientation };
	}
	const float seconds = std::min(std::max(p_seconds, 0.0f), MAX_PREDICTION_S);
	return { p_update.position + p_update.velocity * seconds,
		(kinematics::exp(p_update.spin * seconds) * p_update.orientation).normalized() };
}

} // namespace wire
