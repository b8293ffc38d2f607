// SPDX-License-Identifier: MIT
#pragma once

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

} // namespace wire
