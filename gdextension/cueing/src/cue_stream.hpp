// SPDX-License-Identifier: MIT
#pragma once

#include "datagrams.hpp"
#include "motion_cueing.hpp"

#include <deque>

namespace cueing {

/// From states of a vehicle, as they come, to messages at even times. Knows no clock, thread or socket: it is told
/// the time.
class CueStream {
public:
	MotionCueing cueing;

	/// A state that came at p_now (s, any steady clock).
	void push(const SeatState &p_state, uint32_t p_tick, double p_now);
	/// The vehicle was put elsewhere. States that jump are noticed without it.
	void teleport(double p_now);
	void set_paused(bool p_is_paused);
	/// The message for a moment, later than the one before.
	const CueMessage &step(double p_now);
	const CueMessage &message() const { return _message; }

private:
	struct Arrival {
		double time = 0.0;
		double ahead = 0.0;
	};

	void follow_clock(double p_seconds);

	MotionEstimator _estimator;
	/// How far our clock is ahead of the states', of the last second.
	std::deque<Arrival> _arrivals;
	double _ahead = 0.0;
	bool _has_clock = false;
	double _last_push = -1e9;
	double _last_teleport = -1e9;
	double _last_step = 0.0;
	double _begin = 0.0;
	bool _has_begun = false;
	CueMessage _message;
};

} // namespace cueing
