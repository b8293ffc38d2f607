// SPDX-License-Identifier: MIT
#pragma once

#include "washout_filter.hpp"

#include <quaternion.hpp>

#include <deque>

namespace cueing {

/// Where the seat's reference point was at a moment.
struct SeatState {
	/// Of the caller's clock, s.
	double time = 0.0;
	/// In the world, m.
	Triple position{};
	kinematics::Quat orientation;
	/// In the world, m/s, where it is known.
	Triple velocity{};
	bool has_velocity = false;
	bool is_finite() const;
};

/// How the seat moved at a moment.
struct SeatMotion {
	/// In the world, m, m/s, m/s^2.
	Triple position{};
	Triple velocity{};
	Triple acceleration{};
	kinematics::Quat orientation;
	/// Felt in the seat.
	Motion felt;
};

/// Specific force and rates from successive states of a seat. A parabola is fitted to the states around a moment,
/// nearer ones with more weight: states are rounded and come unevenly, and differences of differences of them would
/// be noise. The weights go to zero at the ends of the window, so the result has no steps where states come and go.
class MotionEstimator {
public:
	/// Half of the window, s. Where states are rarer than four in it, it grows.
	double half_window = 0.08;

	void clear();
	/// Takes a state. Returns false where it can be no continuation of those before: the vehicle was put elsewhere, or
	/// nothing came for long. Then only this state counts. States that are not newer or no numbers are left out.
	bool add(const SeatState &p_state);
	/// The motion at a moment, but not after the newest state. False with fewer than four states.
	bool estimate(double p_time, SeatMotion &r_motion) const;
	double newest_time() const { return _states.empty() ? 0.0 : _states.back().time; }
	std::size_t size() const { return _states.size(); }

private:
	bool follows(const SeatState &p_state) const;
	double window_at(double p_time) const;

	std::deque<SeatState> _states;
};

} // namespace cueing
