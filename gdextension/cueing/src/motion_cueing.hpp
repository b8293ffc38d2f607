// SPDX-License-Identifier: MIT
#pragma once

#include "axis_limiter.hpp"
#include "washout_filter.hpp"

namespace cueing {

/// How long the platform takes to come and go, s.
struct Ramps {
	/// Without news for so long, the platform goes to neutral.
	double dead_man = 0.2;
	/// To neutral, without news or while paused.
	double leave = 2.0;
	/// Back from neutral to full motion.
	double enter = 2.0;
	/// To neutral where the vehicle was put elsewhere.
	double teleport = 1.0;
};

/// The pose of a platform from what is felt in the vehicle: washout, ramps, limits.
class MotionCueing {
public:
	WashoutFilter washout;
	Ramps ramps;

	void set_limits(const std::array<AxisLimits, 3> &p_travel, const std::array<AxisLimits, 3> &p_attitude);
	const AxisLimits &travel_limits(int p_axis) const { return _travel[p_axis].limits; }
	const AxisLimits &attitude_limits(int p_axis) const { return _attitude[p_axis].limits; }
	/// At rest in neutral, with no news yet.
	void reset();
	/// While paused the platform is in neutral.
	void set_paused(bool p_is_paused) { _is_paused = p_is_paused; }
	/// The vehicle was put elsewhere: to neutral and back, instead of a jolt.
	void teleport();
	/// One step. p_age is how long ago the vehicle was last heard of, s. Without a motion, or with one that is no
	/// number, the last one goes on until the dead man's time is over.
	const Pose &step(const Motion *p_motion, double p_seconds, double p_age = 0.0);
	const Pose &pose() const { return _pose; }
	/// How far the platform takes part, 0 (neutral) to 1.
	double gain() const;
	/// The platform is on its way to neutral, or there.
	bool is_leaving() const { return !_is_entering; }

private:
	void follow(double p_seconds);

	std::array<AxisLimiter, 3> _travel;
	std::array<AxisLimiter, 3> _attitude;
	Pose _pose;
	Motion _motion;
	/// Along the ramp, 0 to 1.
	double _progress = 0.0;
	double _without_news = 1e9;
	double _leave_time = 2.0;
	bool _is_paused = false;
	bool _is_entering = false;
	bool _is_teleporting = false;
};

} // namespace cueing
