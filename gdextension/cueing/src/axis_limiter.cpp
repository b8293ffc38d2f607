// SPDX-License-Identifier: MIT
#include "axis_limiter.hpp"

#include <algorithm>
#include <cmath>

namespace cueing {

void AxisLimiter::reset() {
	const AxisLimits kept = limits;
	*this = AxisLimiter();
	limits = kept;
}

/// The greatest speed for a step after which the axis can still stop within p_room:
/// speed x seconds + speed^2 / (2 acceleration) <= room. It holds at the next step too, however long that is,
/// if the axis brakes.
double AxisLimiter::fastest_towards(double p_room, double p_seconds) const {
	const double per_step = limits.acceleration * p_seconds;
	return std::sqrt(per_step * per_step + 2.0 * limits.acceleration * std::max(p_room, 0.0)) - per_step;
}

void AxisLimiter::step(double p_wanted, double p_seconds) {
	if (limits.travel <= 0.0 || limits.acceleration <= 0.0 || p_seconds <= 0.0) {
		return;
	}
	const double wanted = std::clamp(p_wanted, -limits.travel, limits.travel);
	// Goes with what is wanted, and makes up for what it is behind as fast as it can still stop, at half its
	// acceleration: the other half is for what is wanted to move by.
	const double behind = _wanted - _position;
	const double catch_up = std::min(std::fabs(behind) / p_seconds, std::sqrt(limits.acceleration * std::fabs(behind)));
	const double aim = (wanted - _wanted) / p_seconds + std::copysign(catch_up, behind);
	_wanted = wanted;

	const double change = limits.acceleration * p_seconds;
	const double up = std::min(limits.speed, fastest_towards(limits.travel - _position, p_seconds));
	const double down = std::min(limits.speed, fastest_towards(limits.travel + _position, p_seconds));
	const double highest = std::min(_speed + change, up);
	const double lowest = std::max(_speed - change, -down);
	_speed = std::max(lowest, std::min(aim, highest));
	_position += _speed * p_seconds;
}

} // namespace cueing
