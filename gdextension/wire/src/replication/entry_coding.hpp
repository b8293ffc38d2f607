// SPDX-License-Identifier: MIT
#pragma once

#include "range_coder.hpp"
#include "replication/datagram.hpp"

namespace wire {

/// What stands before each person and body in a datagram: who it is, and what it is coded against.

/// Of 65536: that an entry is coded against the datagram's usual baseline; that another entry follows;
/// that a body has a baseline at all.
constexpr uint32_t IS_USUAL = 62000;
constexpr uint32_t GOES_ON = 64500;
constexpr uint32_t HAS_BASE = 63500;

/// A whole number from 0 on, small ones in few bits (exponential Golomb code, Teuhola 1978).
inline void encode_count(RangeEncoder &p_encoder, uint32_t p_count, int p_low_bits) {
	uint32_t rest = p_count + (1U << p_low_bits);
	int bits = p_low_bits;
	while ((rest >> bits) > 1) {
		p_encoder.encode_bit(true, 1U << 15);
		bits++;
	}
	p_encoder.encode_bit(false, 1U << 15);
	p_encoder.encode_bits(rest, bits);
}

/// Reads it; numbers above 65535 come back as 65536.
inline uint32_t decode_count(RangeDecoder &p_decoder, int p_low_bits) {
	int bits = p_low_bits;
	while (bits < 17 && p_decoder.decode_bit(1U << 15)) {
		bits++;
	}
	const uint32_t count = ((1U << bits) | p_decoder.decode_bits(bits)) - (1U << p_low_bits);
	return count > 65535 ? 65536 : count;
}

constexpr int AGE_BITS = 7;
constexpr int SPACING_BITS = 3;

/// The baseline of a person.
inline void encode_baseline(RangeEncoder &p_encoder, const Baseline &p_base, bool p_is_usual) {
	p_encoder.encode_bit(!p_is_usual, IS_USUAL);
	if (!p_is_usual) {
		p_encoder.encode_bits(uint32_t(p_base.age), AGE_BITS);
		p_encoder.encode_bits(uint32_t(p_base.spacing), SPACING_BITS);
	}
}

inline Baseline decode_baseline(RangeDecoder &p_decoder, const Baseline &p_usual) {
	if (!p_decoder.decode_bit(IS_USUAL)) {
		return p_usual;
	}
	Baseline base;
	base.age = int(p_decoder.decode_bits(AGE_BITS));
	base.spacing = int(p_decoder.decode_bits(SPACING_BITS));
	return base;
}

/// Of 65536: that a person who is sent without a base is in the world's frame.
constexpr uint32_t IS_IN_WORLD = 64000;

/// The frame of a person that is sent without a base; with one it is the base's.
inline void encode_frame(RangeEncoder &p_encoder, uint16_t p_frame) {
	p_encoder.encode_bit(p_frame != 0, IS_IN_WORLD);
	if (p_frame != 0) {
		p_encoder.encode_bits(p_frame, 16);
	}
}

inline uint16_t decode_frame(RangeDecoder &p_decoder) {
	return p_decoder.decode_bit(IS_IN_WORLD) ? uint16_t(p_decoder.decode_bits(16)) : uint16_t(0);
}

/// What bodies and entities with fields are sorted by, and the id of such a number.
inline uint16_t thing_number(uint16_t p_id) {
	return uint16_t(p_id - FIRST_THING);
}
inline uint16_t thing_id(uint16_t p_number) {
	return uint16_t(p_number + FIRST_THING);
}

/// Of 65536: that an entity's fields are coded against a state as old as that of the entity before, or of the usual
/// baseline; that otherwise it is a state that the client has, not those that it was spawned with.
constexpr uint32_t SAME_FIELD_BASE = 60000;
constexpr uint32_t HAS_FIELD_BASE = 32768;
constexpr int FIELD_AGE_BITS = 6;

} // namespace wire
