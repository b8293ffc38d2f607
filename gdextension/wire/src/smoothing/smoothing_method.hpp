// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

namespace wire {

/// How a client makes smooth motion of updates (docs/smoothing.md compares them).
enum class SmoothingMethod {
	NONE, ///< The newest update as it is.
	LINEAR, ///< Between two updates, BUFFER_S behind.
	EXTRAPOLATE_LERP, ///< The thesis's (7.1): from what is shown to where the next update will be.
	HERMITE, ///< Like LINEAR, along a cubic curve.
	ERROR_OFFSET, ///< The newest update, dead-reckoned to now; the jump at each update decays.
	ADAPTIVE_LOW_DELAY, ///< As far behind as most updates are late; beyond the newest it goes on a little.
};

constexpr int SMOOTHING_METHOD_COUNT = 6;

/// How far LINEAR and HERMITE stay behind the quickest arrivals, s; further if updates are so rare or
/// late that the next one would not be there.
constexpr double BUFFER_S = 0.04;

/// Beyond the newest update a person goes on ever slower, and no longer than this in sum, s.
constexpr double REACH_S = 0.06;
/// ERROR_OFFSET wants to be where the server is now, and guesses further.
constexpr double FAR_REACH_S = 0.3;

/// For how much of a time beyond the newest update (s, not below 0) motion is carried on, s.
inline double carried_on(double p_ahead, double p_reach) {
	return p_reach * (1.0 - std::exp(-p_ahead / p_reach));
}

} // namespace wire
