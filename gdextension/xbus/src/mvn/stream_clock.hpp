// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

namespace mvn {

/// Estimates when samples were taken, by the sender's time code and the times at which they arrive.
///
/// The quickest arrivals of the last seconds show how far the two clocks are apart; all others waited
/// somewhere. Where the time code does not run as time does (stopped, slow motion, left at zero) the arrival is
/// all that is known.
class StreamClock {
public:
	/// The time of a sample that arrived now, µs, never later than its arrival.
	uint64_t timestamp(uint32_t p_time_code_ms, uint64_t p_arrival_usec) {
		const int64_t arrival = int64_t(p_arrival_usec);
		const int64_t code = int64_t(p_time_code_ms) * 1000;
		if (!_is_known || code < _last_code || arrival < _last_arrival || arrival - _last_arrival > GAP_USEC) {
			begin(code, arrival);
		}
		_last_code = code;
		_last_arrival = arrival;
		const int64_t passed = arrival - _began_arrival;
		if (passed >= SPAN_USEC) {
			const int64_t apart = (code - _began_code) - passed;
			_runs = (apart < 0 ? -apart : apart) * 20 <= passed;
			_before = _quickest;
			_quickest = arrival - code;
			_began_code = code;
			_began_arrival = arrival;
		}
		_quickest = std::min(_quickest, arrival - code);
		if (!_runs) {
			return p_arrival_usec;
		}
		const int64_t time = code + std::min(_quickest, _before);
		return arrival - time > GAP_USEC ? p_arrival_usec : uint64_t(time);
	}

private:
	/// Over which it is judged whether the time code runs.
	static constexpr int64_t SPAN_USEC = 1000000;
	/// After this time without a sample everything is reset; no sample waits this long.
	static constexpr int64_t GAP_USEC = 500000;

	void begin(int64_t p_code, int64_t p_arrival) {
		_is_known = true;
		_runs = false;
		_began_code = p_code;
		_began_arrival = p_arrival;
		_quickest = _before = p_arrival - p_code;
	}

	bool _is_known = false;
	bool _runs = false;
	int64_t _last_code = 0;
	int64_t _last_arrival = 0;
	int64_t _began_code = 0;
	int64_t _began_arrival = 0;
	int64_t _quickest = 0;
	int64_t _before = 0;
};

} // namespace mvn
