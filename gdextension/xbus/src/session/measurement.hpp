// SPDX-License-Identifier: MIT
#pragma once

#include "session/output_choice.hpp"
#include "session/stream_health.hpp"
#include "session/suit_stream.hpp"

#include <cstddef>
#include <cstdint>

namespace xbus {

/// What a device sends while it measures: checks it, makes frames of it, and notices when it falls silent,
/// sends something else than it was set to, or loses samples. Nothing is allocated.
class Measurement {
public:
	/// A measurement begins, at a time, µs.
	void begin(const KnownDevice &p_device, const OutputChoice &p_choice, uint64_t p_now_usec);
	/// Judges a message; DATA is to be given to take().
	StreamCheck::Verdict judge(const Frame &p_frame, bool p_is_noisy) { return _check.take(p_frame, p_is_noisy); }
	/// Makes a frame of what was judged last.
	const SuitFrame &take(uint64_t p_now_usec);

	bool is_silent(uint64_t p_now_usec, double p_rate_hz) const;
	/// Whether what came since it began had wrong lengths.
	bool has_refused_all() const { return _check.statistics().wrong_sizes > _refused; }
	/// Whether many more samples of a wrong length have come since the last time that this was so.
	bool refuses_many();
	/// How many samples are lost, where it is time to judge.
	StreamHealth::Finding find_damage(const KnownDevice &p_device, uint64_t p_bad_bytes, uint64_t p_now_usec);

	/// Bytes of the longest message of samples; 0 where that is not known.
	std::size_t data_size() const { return _check.data_size(); }
	const StreamStatistics &statistics() const { return _check.statistics(); }
	const DeviceStatistics &device(uint8_t p_bus_id) const { return _check.device(p_bus_id); }
	TrackerFlow flow(int p_tracker, uint64_t p_now_usec) const { return _stream.flow(p_tracker, p_now_usec); }
	double lost_share() const { return _health.lost_share(); }

private:
	StreamCheck _check;
	SuitStream _stream;
	SuitFrame _frame;
	StreamHealth _health;
	uint64_t _heard_usec = 0;
	/// Samples of a wrong length when it began, and when that was reported last.
	uint64_t _refused = 0;
	uint64_t _reported_refused = 0;
};

} // namespace xbus
