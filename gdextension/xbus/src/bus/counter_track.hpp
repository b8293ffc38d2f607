// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace xbus {

/// Public stats of one device.
struct DeviceStatistics {
	/// Samples taken.
	uint64_t received = 0;
	/// Samples that the counter counted and that never came.
	uint64_t lost = 0;
	/// Samples with the counter of the one before.
	uint64_t duplicates = 0;
	/// Samples with a counter that had passed.
	uint64_t late = 0;
	/// Samples whose values cannot be.
	uint64_t implausible = 0;
	/// How often the counter began anew.
	uint64_t resets = 0;
};

/// Follows a counter that goes up by a constant step and wraps around.
class CounterTrack {
public:
	enum class Step : uint8_t {
		FIRST,
		NEXT,
		/// Samples are missing: `lost` says how many.
		GAP,
		DUPLICATE,
		LATE,
		/// Far from what was expected. Believed only when the next counter goes on from here.
		JUMP,
		/// The one after a jump: the counter has begun anew.
		RESET,
	};

	/// Forward steps that are taken for a loss rather than for a jump, at most a quarter of the counter's range.
	static constexpr uint32_t MAX_LOST = 3000;
	/// Backward steps that are taken for a late sample.
	static constexpr uint32_t MAX_LATE = 16;

	/// How far the counter goes with each sample: the skip factor + 1 of a tracker that stands alone.
	void set_step(uint32_t p_step) { _step = p_step > 0 ? p_step : 1; }
	void forget() { _known = _jumped = false; }

	/// What this counter of so many bits (8, 16 or 32) means. `r_lost`: samples missed before it.
	Step see(uint32_t p_counter, unsigned p_bits, uint32_t &r_lost);
	/// The same, noted in a device's stats.
	Step see(uint32_t p_counter, unsigned p_bits, DeviceStatistics &r_statistics);

private:
	Step _jump(uint32_t p_counter, uint32_t p_mask, Step p_otherwise);

	uint32_t _last = 0;
	uint32_t _landed = 0;
	uint32_t _step = 1;
	bool _known = false;
	bool _jumped = false;
};

/// Notes a step in a device's stats.
void note_step(CounterTrack::Step p_step, uint32_t p_lost, DeviceStatistics &r_statistics);

} // namespace xbus
