// SPDX-License-Identifier: MIT
#pragma once

#include "source_clock.hpp"

#include <utility>
#include <vector>

namespace clocks {

/// When the samples of a stream were measured, in this machine's time, from the sender's clock, or from its count
/// alone, and the times at which they arrive. Times only go up, and are never later than the arrival, but for
/// samples that come at once.
class StreamTime {
public:
	/// The time of a sample, µs, that arrived at one; `p_source_usec` is the sender's own time.
	int64_t at(int64_t p_source_usec, int64_t p_arrival_usec) {
		if (p_arrival_usec - _last_arrival > GAP_USEC || p_arrival_usec < _last_arrival) {
			_clock.resume();
		}
		_last_arrival = p_arrival_usec;
		return later(int64_t(_clock.timestamp(p_source_usec, uint64_t(p_arrival_usec))), p_arrival_usec);
	}

	/// The same from the sender's count: it is taken to measure evenly.
	int64_t at_count(int64_t p_counter, int64_t p_arrival_usec) {
		if (_counter < 0 || p_counter < _counter || p_arrival_usec - _last_arrival > GAP_USEC) {
			_counted.reset();
			_first.clear();
			_period_usec = 0.0;
		}
		_counter = p_counter;
		_last_arrival = p_arrival_usec;
		int64_t time = p_arrival_usec;
		if (_period_usec > 0.0) {
			time = counted(p_counter, p_arrival_usec);
		} else {
			measure_period(p_counter, p_arrival_usec, time);
		}
		return later(time, p_arrival_usec);
	}

	/// The same where the arrival is all that is known.
	int64_t at_arrival(int64_t p_arrival_usec) {
		_last_arrival = p_arrival_usec;
		return later(p_arrival_usec, p_arrival_usec);
	}

private:
	/// A count and when it came, µs.
	using Arrival = std::pair<int64_t, int64_t>;

	/// Over which the period is first measured, roughly, and how many samples of it are kept.
	static constexpr int64_t SPAN_USEC = 1000000;
	static constexpr std::size_t MAX_FIRST = 1024;
	/// After so long without a sample the clocks are compared anew; no sample waits so long on its way.
	static constexpr int64_t GAP_USEC = 500000;
	/// Two samples are at least so far apart.
	static constexpr int64_t STEP_USEC = 100;

	int64_t counted(int64_t p_counter, int64_t p_arrival) {
		return int64_t(_counted.timestamp(std::llround(double(p_counter) * _period_usec), uint64_t(p_arrival)));
	}

	/// Keeps the samples of the first span; at its end the clock gets them all.
	void measure_period(int64_t p_counter, int64_t p_arrival, int64_t &r_time) {
		if (_first.size() < MAX_FIRST) {
			_first.emplace_back(p_counter, p_arrival);
		}
		const auto [counter, arrival] = _first.front();
		if (p_arrival - arrival < SPAN_USEC || p_counter == counter) {
			return;
		}
		_period_usec = double(p_arrival - arrival) / double(p_counter - counter);
		// Between the quickest of the first third and of the last: those that waited say nothing of it.
		for (int round = 0; round < 2; ++round) {
			const Arrival from = quickest(0, _first.size() / 3 + 1);
			const Arrival to = quickest(_first.size() * 2 / 3, _first.size());
			if (to.first > from.first && to.second > from.second) {
				_period_usec = double(to.second - from.second) / double(to.first - from.first);
			}
		}
		for (const auto &[known, came] : _first) {
			r_time = counted(known, came);
		}
		r_time = counted(p_counter, p_arrival);
		_first.clear();
	}

	Arrival quickest(std::size_t p_begin, std::size_t p_end) const {
		const auto late = [this](const Arrival &p_one) {
			return double(p_one.second) - double(p_one.first) * _period_usec;
		};
		return *std::min_element(_first.begin() + std::ptrdiff_t(p_begin), _first.begin() + std::ptrdiff_t(p_end),
				[&](const Arrival &p_a, const Arrival &p_b) { return late(p_a) < late(p_b); });
	}

	int64_t later(int64_t p_time, int64_t p_arrival) {
		int64_t time = p_arrival - p_time > GAP_USEC ? p_arrival : p_time;
		if (time <= _last_time && _last_time - time < GAP_USEC) {
			time = _last_time + STEP_USEC;
		}
		_last_time = time;
		return time;
	}

	SourceClock _clock;
	SourceClock _counted{ true, true };
	int64_t _last_arrival = 0;
	int64_t _last_time = 0;
	int64_t _counter = -1;
	double _period_usec = 0.0;
	/// Of the first span.
	std::vector<Arrival> _first;
};

} // namespace clocks
