// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace xbus {

/// Tells when a sample was taken from its counter and the times at which samples arrive.
///
/// The quickest arrivals tell the truth, all others waited somewhere: an earlier arrival than expected moves
/// the line at once, later ones draw it by so little that only a drift of the clocks is followed.
class SampleTimeline {
public:
	/// Begins anew: a new stream, or one of another period, µs.
	void reset(double p_period_usec) {
		_period_usec = p_period_usec;
		_is_known = false;
	}

	/// The time of a sample that arrived now, µs.
	uint64_t place(uint64_t p_counter, uint64_t p_arrival_usec) {
		const double expected = double(p_counter) * _period_usec;
		const double offset = double(p_arrival_usec) - expected;
		const double late = offset - _offset;
		if (!_is_known || late < 0.0 || late > MOST_LATE_USEC) {
			_offset = offset;
			_is_known = true;
		} else {
			_offset += late * DRIFT;
		}
		return uint64_t(expected + _offset);
	}

private:
	/// Later than that it is no delay, but another stream.
	static constexpr double MOST_LATE_USEC = 250000.0;
	/// Part of a delay by which the line moves: clocks that differ by 100 parts in a million, a hundred samples a
	/// second, need 1 µs a sample.
	static constexpr double DRIFT = 0.001;

	double _period_usec = 10000.0;
	double _offset = 0.0;
	bool _is_known = false;
};

} // namespace xbus
