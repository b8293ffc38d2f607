// SPDX-License-Identifier: MIT
#include "bus/counter_track.hpp"

#include <algorithm>

namespace xbus {

CounterTrack::Step CounterTrack::_jump(uint32_t p_counter, uint32_t p_mask, Step p_otherwise) {
	const bool goes_on = _jumped && ((p_counter - _landed) & p_mask) == _step;
	_landed = p_counter;
	_jumped = !goes_on;
	if (!goes_on) {
		return p_otherwise;
	}
	_last = p_counter;
	return Step::RESET;
}

CounterTrack::Step CounterTrack::see(uint32_t p_counter, unsigned p_bits, uint32_t &r_lost) {
	const uint32_t mask = p_bits >= 32 ? ~uint32_t(0) : (uint32_t(1) << p_bits) - 1U;
	r_lost = 0;
	if (!_known) {
		_known = true;
		_last = p_counter;
		return Step::FIRST;
	}
	const uint32_t ahead = (p_counter - _last) & mask;
	const uint32_t behind = (_last - p_counter) & mask;
	const uint32_t most_ahead = std::min(MAX_LOST * _step, mask / 4U);
	if (ahead == 0) {
		return Step::DUPLICATE;
	}
	if (ahead <= most_ahead) {
		// Part of a step is no sample: a tracker may send between its steps when asked.
		r_lost = (ahead - 1U) / _step;
		_last = p_counter;
		_jumped = false;
		return r_lost > 0 ? Step::GAP : Step::NEXT;
	}
	return _jump(p_counter, mask, behind <= std::min(MAX_LATE * _step, mask / 4U) ? Step::LATE : Step::JUMP);
}

CounterTrack::Step CounterTrack::see(uint32_t p_counter, unsigned p_bits, DeviceStatistics &r_statistics) {
	uint32_t lost = 0;
	const Step step = see(p_counter, p_bits, lost);
	note_step(step, lost, r_statistics);
	return step;
}

void note_step(CounterTrack::Step p_step, uint32_t p_lost, DeviceStatistics &r_statistics) {
	r_statistics.received++;
	r_statistics.lost += p_lost;
	r_statistics.duplicates += p_step == CounterTrack::Step::DUPLICATE ? 1U : 0U;
	r_statistics.late += p_step == CounterTrack::Step::LATE ? 1U : 0U;
	r_statistics.resets += p_step == CounterTrack::Step::RESET ? 1U : 0U;
}

} // namespace xbus
