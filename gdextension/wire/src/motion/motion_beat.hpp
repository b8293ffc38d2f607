// SPDX-License-Identifier: MIT
#pragma once

#include "coding/number_model.hpp"
#include "coding/person_contexts.hpp"

#include <algorithm>
#include <cstdint>

namespace wire {

/// A number that changes little from datagram to datagram, coded as steps away from what is expected.
/// How far it strayed so far tells how it is coded: a steady one takes a fraction of a bit.
struct MotionSteps {
	static constexpr int64_t MAX_STEPS = 1000; ///< What strays farther is coded as a whole.

	int32_t spread = 64; ///< Mean of the steps so far, 1 / 16.

	/// How the next one is coded.
	NumberModel model() const {
		constexpr int SHAPE = 2; // Heavy tails: a thread that wakes up late is very late.
		NumberModel model;
		model.level = log16(uint64_t(std::max(spread, 2)));
		model.shares = SHARES_WITHIN[SHAPE];
		return model;
	}
	/// What is known after a number of steps.
	MotionSteps after(int64_t p_steps) const {
		const int64_t size = std::min<int64_t>(p_steps < 0 ? -p_steps : p_steps, MAX_STEPS);
		return { int32_t((spread + 16 * size) / 2) };
	}
};

/// When datagrams are due: that of a source that samples at a steady rate, whose phase may move.
struct MotionBeat {
	static constexpr int64_t PERIOD_USEC = 16667; ///< Time between two datagrams where nothing else is known.
	static constexpr int64_t MAX_PERIOD_USEC = 1000000;
	static constexpr int64_t SMALL_USEC = 10; ///< Off by more, the period moves by 1 / 16 us.
	static constexpr int64_t LARGE_USEC = 1000; ///< Off by more, twice by nearly the same, it is another period.
	static constexpr int64_t ALIKE_USEC = 200;

	int64_t time_usec = 0; ///< When this datagram's first sample was taken, Unix time.
	int64_t period = PERIOD_USEC * 16; ///< Time between two, 1 / 16 us.
	int64_t off_usec = 0; ///< How much longer than the period it took, a datagram.
	MotionSteps steps; ///< How far times were off.

	/// When the datagram that is so many later is due, us.
	int64_t due_usec(int64_t p_later) const { return time_usec + period * p_later / 16; }
	/// The beat at that datagram, whose time was coded as so many steps.
	MotionBeat after(int64_t p_later, int64_t p_time_usec, int64_t p_steps) const {
		MotionBeat beat = *this;
		beat.time_usec = p_time_usec;
		beat.steps = steps.after(p_steps);
		beat.off_usec = (p_time_usec - due_usec(p_later)) / p_later;
		const int64_t size = beat.off_usec < 0 ? -beat.off_usec : beat.off_usec;
		const int64_t apart = beat.off_usec - off_usec;
		if (size > LARGE_USEC && size <= MAX_PERIOD_USEC && apart <= ALIKE_USEC && apart >= -ALIKE_USEC) {
			beat.period += 16 * beat.off_usec;
		} else if (size > SMALL_USEC) {
			beat.period += beat.off_usec < 0 ? -1 : 1;
		}
		beat.period = std::clamp<int64_t>(beat.period, 0, MAX_PERIOD_USEC * 16);
		return beat;
	}
};

} // namespace wire
