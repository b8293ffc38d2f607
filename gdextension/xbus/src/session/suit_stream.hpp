// SPDX-License-Identifier: MIT
#pragma once

#include "bus/stream_check.hpp"
#include "session/line_budget.hpp"
#include "session/suit_frame.hpp"

#include <source_clock.hpp>

#include <array>
#include <cstdint>

namespace xbus {

/// How a tracker's samples come.
struct TrackerFlow {
	/// When the newest came, µs; 0 if none did.
	uint64_t newest_usec = 0;
	/// Samples per second, over the last second or two.
	double rate_hz = 0.0;
};

/// Makes frames of what a `StreamCheck` has decoded: numbers samples over the wraps of the counter, estimates when
/// they were taken, and how they come.
class SuitStream {
public:
	/// A new measurement begins, of so many samples per second; counters may begin anywhere.
	void restart(double p_rate_hz);

	/// The frame of a message that arrived now.
	void take(const StreamCheck &p_check, uint64_t p_now_usec, SuitFrame &r_frame);

	/// How a tracker's samples come, as of now.
	TrackerFlow flow(int p_tracker, uint64_t p_now_usec) const;

private:
	struct Meter {
		uint64_t newest_usec = 0;
		uint64_t began_usec = 0;
		uint32_t count = 0;
		double rate_hz = 0.0;
	};

	uint64_t count_on(const Sample &p_sample);
	void meter(int p_tracker, uint64_t p_now_usec);
	static void read(const Sample &p_sample, TrackerReading &r_reading);

	/// The counters times the period that was asked for.
	clocks::SourceClock _clock{ true };
	double _period_usec = 10000.0;
	std::array<Meter, MAX_TRACKERS> _meters{};
	uint64_t _counter = 0;
	uint32_t _last = 0;
	bool _has_last = false;
};

} // namespace xbus
