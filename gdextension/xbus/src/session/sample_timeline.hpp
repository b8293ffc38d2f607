// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

namespace xbus {

/// Estimates when a sample was taken, by its counter and the times at which samples arrive.
///
/// The quickest arrivals are right, all others waited somewhere: an earlier arrival than expected moves
/// the line at once, later ones draw it by so little that only a drift of the clocks is followed. A device that
/// measures at another rate than it was asked for is believed, once it has done so for two seconds.
class SampleTimeline {
public:
	/// Begins anew: a new stream, or one of another period, µs.
	void reset(double p_period_usec) {
		_period_usec = p_period_usec;
		_is_known = false;
		_has_span = false;
		_measured_usec = 0.0;
	}

	/// The time of a sample that arrived now, µs.
	uint64_t timestamp(uint64_t p_counter, uint64_t p_arrival_usec) {
		measure(p_counter, p_arrival_usec);
		const double expected = double(p_counter) * _period_usec;
		const double offset = double(p_arrival_usec) - expected;
		const double late = offset - _offset;
		if (!_is_known || late < 0.0 || late > MAX_LATE_USEC) {
			_offset = offset;
			_is_known = true;
		} else {
			_offset += late * DRIFT;
		}
		return uint64_t(expected + _offset);
	}

private:
	/// Later than that it is no delay, but another stream.
	static constexpr double MAX_LATE_USEC = 250000.0;
	/// Part of a delay by which the line moves: clocks that differ by 100 parts in a million, a hundred samples a
	/// second, need 1 µs a sample.
	static constexpr double DRIFT = 0.001;

	/// A period is measured over so long, µs.
	static constexpr uint64_t SPAN_USEC = 1000000;
	/// Parts of a period by which one is another than expected, and by which two measured ones are alike.
	static constexpr double ANOTHER = 0.05;
	static constexpr double ALIKE = 0.02;

	/// Notes the true period, and takes it over where two spans agree that it is another.
	void measure(uint64_t p_counter, uint64_t p_arrival_usec) {
		if (_has_span && p_arrival_usec < _span_usec + SPAN_USEC) {
			return;
		}
		if (_has_span && p_counter > _span_counter) {
			const double measured = double(p_arrival_usec - _span_usec) / double(p_counter - _span_counter);
			const bool is_another = std::abs(measured - _period_usec) > ANOTHER * _period_usec;
			if (is_another && std::abs(measured - _measured_usec) < ALIKE * measured) {
				_period_usec = measured;
				_is_known = false;
			}
			_measured_usec = measured;
		}
		_span_counter = p_counter;
		_span_usec = p_arrival_usec;
		_has_span = true;
	}

	double _period_usec = 10000.0;
	/// Of the span before, or 0.
	double _measured_usec = 0.0;
	uint64_t _span_counter = 0;
	uint64_t _span_usec = 0;
	bool _has_span = false;
	double _offset = 0.0;
	bool _is_known = false;
};

} // namespace xbus
