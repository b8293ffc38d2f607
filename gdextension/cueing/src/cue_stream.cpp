// SPDX-License-Identifier: MIT
#include "cue_stream.hpp"

#include <algorithm>
#include <cmath>

namespace cueing {

namespace {

/// The moment that is shown lies so far before the newest state, s: with states on both sides of it a fit is steadier.
constexpr double DELAY = 0.05;
/// Arrivals of so long count for the clock, s.
constexpr double ARRIVALS = 1.0;
/// The clock is pulled to where the quickest arrivals have it by so much of the time, and set where it is so far off,
/// s.
constexpr double PULL = 0.03;
constexpr double FAR = 0.25;
/// A lost datagram must not hide a teleport, s.
constexpr double TELEPORT_SHOWN = 0.25;
constexpr double MAX_CLOCK_STEP = 0.25;

} // namespace

void CueStream::push(const SeatState &p_state, uint32_t p_tick, double p_now) {
	if (!p_state.is_finite()) {
		return;
	}
	// Where the sender begins anew, its times may begin anew as well.
	if (p_state.time < _estimator.newest_time() - 1.0) {
		_estimator.clear();
		_has_clock = false;
		teleport(p_now);
	}
	if (!_estimator.add(p_state)) {
		_has_clock = false;
		teleport(p_now);
	}
	if (!_has_clock) {
		_arrivals.clear();
	}
	_arrivals.push_back({ p_now, p_now - p_state.time });
	while (_arrivals.front().time < p_now - ARRIVALS) {
		_arrivals.pop_front();
	}
	_last_push = p_now;
	_message.tick = p_tick;
}

void CueStream::teleport(double p_now) {
	_estimator.clear();
	_last_teleport = p_now;
	cueing.teleport();
}

void CueStream::set_paused(bool p_is_paused) {
	_message.is_paused = p_is_paused;
	cueing.set_paused(p_is_paused);
}

/// Only the quickest arrivals came when they were due; all others were late.
void CueStream::follow_clock(double p_seconds) {
	if (_arrivals.empty()) {
		return;
	}
	const auto quickest = std::min_element(_arrivals.begin(), _arrivals.end(),
			[](const Arrival &p_a, const Arrival &p_b) { return p_a.ahead < p_b.ahead; });
	const double off = quickest->ahead - _ahead;
	if (!_has_clock || std::fabs(off) > FAR) {
		_ahead = quickest->ahead;
		_has_clock = true;
		return;
	}
	_ahead += std::clamp(off, -PULL * p_seconds, PULL * p_seconds);
}

const CueMessage &CueStream::step(double p_now) {
	if (!_has_begun) {
		_begin = p_now;
		_last_step = p_now;
		_has_begun = true;
	}
	const double seconds = std::clamp(p_now - _last_step, 0.0, MAX_CLOCK_STEP);
	_last_step = p_now;
	follow_clock(seconds);
	SeatMotion motion;
	const bool is_known = _estimator.estimate(p_now - _ahead - DELAY, motion);
	if (is_known) {
		_message.motion = motion;
	}
	const double age = p_now - _last_push;
	_message.cue = cueing.step(is_known ? &motion.felt : nullptr, seconds, age);
	_message.gain = cueing.gain();
	_message.is_stale = age > cueing.ramps.dead_man;
	_message.has_teleported = p_now - _last_teleport < TELEPORT_SHOWN;
	_message.time_usec = uint64_t((p_now - _begin) * 1e6);
	_message.sequence++;
	return _message;
}

} // namespace cueing
