// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>

namespace transport {

/// When a busy thread of a server pauses, to take in all that has come meanwhile at once: waking up
/// costs more than what there is to do. Pauses are short when the main thread's next snapshots are
/// near, so that they leave soon and no sample is late for the tick; long otherwise.
class BatchPause {
public:
	static constexpr int64_t SHORT_USEC = 500;
	static constexpr int64_t LONG_USEC = 2500;
	/// The snapshots are near this long before they are expected, µs.
	static constexpr int64_t NEAR_USEC = 1000;

	/// The main thread has handed over snapshots at a time, µs.
	void handed_over(int64_t p_now_usec) {
		_period_usec = std::clamp(p_now_usec - _last_usec, 2 * NEAR_USEC, 20 * NEAR_USEC);
		_last_usec = p_now_usec;
	}

	/// How long to pause, µs.
	int64_t usec(int64_t p_now_usec) const {
		const int64_t near = _last_usec + _period_usec - NEAR_USEC;
		if (p_now_usec > near + 3 * NEAR_USEC) {
			return 2 * SHORT_USEC; // The main thread is late or has stopped: no telling when.
		}
		return std::clamp(near - p_now_usec, SHORT_USEC, LONG_USEC);
	}

private:
	int64_t _last_usec = 0;
	int64_t _period_usec = 0;
};

} // namespace transport
