// SPDX-License-Identifier: MIT
#pragma once

#include "range_coder.hpp"
#include "replication/body_state.hpp"

namespace wire {

/// How a rigid body's state is written: as the difference from what its receiver can foresee from a
/// state that it has, or from nothing.
///
/// Differences are Rice codes whose size comes first, once for each of position, velocity, turn and
/// spin: bodies in one heap slide, fall and tumble quite differently.
class BodyCodec {
public:
	/// @param p_base a state that the receiver has, p_ticks old; null if it has none
	static void encode(
			RangeEncoder &p_encoder, const BodyState &p_now, const BodyState *p_base, int p_ticks, int p_tick_rate);
	/// Returns false where what is read can be no body.
	static bool decode(
			RangeDecoder &p_decoder, const BodyState *p_base, int p_ticks, int p_tick_rate, BodyState &r_now);
};

} // namespace wire
