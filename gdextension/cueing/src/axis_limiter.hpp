// SPDX-License-Identifier: MIT
#pragma once

namespace cueing {

/// What an axis of a platform can do: in m and s, or in rad and s.
struct AxisLimits {
	/// To either side of neutral; 0: the platform lacks this axis.
	double travel = 0.0;
	double speed = 0.0;
	double acceleration = 0.0;
};

/// Follows a wanted position as well as an axis can. Where the axis can, it is there exactly, at every step; its
/// travel, speed and acceleration are never exceeded, whatever is wanted: it brakes before the end of its travel.
class AxisLimiter {
public:
	AxisLimits limits;

	/// At rest in neutral.
	void reset();
	/// One step towards a position. The result is position().
	void step(double p_wanted, double p_seconds);
	double position() const { return _position; }
	/// Mean of the last step.
	double speed() const { return _speed; }

private:
	double fastest_towards(double p_room, double p_seconds) const;

	double _position = 0.0;
	double _speed = 0.0;
	double _wanted = 0.0;
};

} // namespace cueing
