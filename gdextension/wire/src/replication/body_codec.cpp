// SPDX-License-Identifier: MIT
#include "replication/body_codec.hpp"

#include <algorithm>
#include <cstdlib>

namespace wire {

namespace {

constexpr int SIZES = 16;
// Quotients from here on are an escape: the number follows in full.
constexpr uint32_t ESCAPE = 12;
// Chance of 65536 that a quotient goes on by one more.
constexpr uint32_t STOPS = 36000;
// Of 65536: that a body stays as it was, at rest or not; that the turn's left-out component stays.
constexpr uint32_t SAME_REST = 62000;
constexpr uint32_t SAME_CHART = 60000;

// How often each size is needed, of 256: from crates that are pushed about (tests/bench/bench_wire.gd).
struct SizeTable {
	std::array<uint16_t, SIZES + 1> below;
};
constexpr SizeTable accumulate(const std::array<uint16_t, SIZES> &p_shares) {
	SizeTable table{};
	for (std::size_t i = 0; i < SIZES; i++) {
		table.below[i + 1] = uint16_t(table.below[i] + p_shares[i]);
	}
	return table;
}
constexpr SizeTable POSITION = accumulate({ 40, 60, 56, 38, 20, 10, 6, 4, 4, 3, 3, 3, 3, 2, 2, 2 });
constexpr SizeTable VELOCITY = accumulate({ 40, 50, 50, 45, 32, 20, 8, 3, 1, 1, 1, 1, 1, 1, 1, 1 });
constexpr SizeTable TURN = accumulate({ 60, 75, 55, 33, 15, 6, 3, 1, 1, 1, 1, 1, 1, 1, 1, 1 });
constexpr SizeTable SPIN = accumulate({ 40, 55, 55, 45, 32, 15, 5, 1, 1, 1, 1, 1, 1, 1, 1, 1 });
static_assert(POSITION.below[SIZES] == 256 && VELOCITY.below[SIZES] == 256, "shares of 256");
static_assert(TURN.below[SIZES] == 256 && SPIN.below[SIZES] == 256, "shares of 256");

uint32_t zigzag(int32_t p_number) {
	return p_number >= 0 ? uint32_t(p_number) << 1U : (uint32_t(-(p_number + 1)) << 1U) + 1U;
}

int32_t unzigzag(uint32_t p_code) {
	return (p_code & 1U) != 0 ? -int32_t(p_code >> 1U) - 1 : int32_t(p_code >> 1U);
}

void encode_number(RangeEncoder &p_encoder, int32_t p_number, int p_size) {
	const uint32_t code = zigzag(p_number);
	const uint32_t quotient = std::min(code >> uint32_t(p_size), ESCAPE);
	for (uint32_t i = 0; i < quotient; i++) {
		p_encoder.encode_bit(true, STOPS);
	}
	if (quotient == ESCAPE) {
		p_encoder.encode_bits(code, 32);
		return;
	}
	p_encoder.encode_bit(false, STOPS);
	p_encoder.encode_bits(code, p_size);
}

int32_t decode_number(RangeDecoder &p_decoder, int p_size) {
	uint32_t quotient = 0;
	while (quotient < ESCAPE && p_decoder.decode_bit(STOPS)) {
		quotient++;
	}
	if (quotient == ESCAPE) {
		return unzigzag(p_decoder.decode_bits(32));
	}
	return unzigzag((quotient << uint32_t(p_size)) | p_decoder.decode_bits(p_size));
}

using Three = std::array<int32_t, 3>;

void encode_three(RangeEncoder &p_encoder, const Three &p_numbers, const SizeTable &p_table) {
	int best = 0;
	uint32_t least = UINT32_MAX;
	for (int size = 0; size < SIZES; size++) {
		uint32_t bits = 0;
		for (const int32_t number : p_numbers) {
			const uint32_t quotient = zigzag(number) >> uint32_t(size);
			// A quotient takes about 0.86 bits and 1.15 more for each step.
			bits += quotient < ESCAPE ? uint32_t(10 * size) + 9 + 12 * quotient : 460;
		}
		best = bits < least ? size : best;
		least = std::min(bits, least);
	}
	const std::size_t at = std::size_t(best);
	p_encoder.encode(p_table.below[at], uint32_t(p_table.below[at + 1] - p_table.below[at]), 8);
	for (const int32_t number : p_numbers) {
		encode_number(p_encoder, number, best);
	}
}

Three decode_three(RangeDecoder &p_decoder, const SizeTable &p_table) {
	const uint32_t point = p_decoder.peek(8);
	std::size_t size = 0;
	while (p_table.below[size + 1] <= point) {
		size++;
	}
	p_decoder.decode(p_table.below[size], uint32_t(p_table.below[size + 1] - p_table.below[size]));
	Three numbers{};
	for (int32_t &number : numbers) {
		number = decode_number(p_decoder, int(size));
	}
	return numbers;
}

template <typename T>
Three difference(const std::array<T, 3> &p_now, const std::array<T, 3> &p_foreseen) {
	Three result{};
	for (std::size_t i = 0; i < 3; i++) {
		// By way of unsigned numbers, which may wrap.
		result[i] = int32_t(uint32_t(p_now[i]) - uint32_t(p_foreseen[i]));
	}
	return result;
}

// Adds a difference; false where the sum does not fit.
template <typename T>
bool add(const std::array<T, 3> &p_foreseen, const Three &p_difference, int64_t p_most, std::array<T, 3> &r_sum) {
	bool fits = true;
	for (std::size_t i = 0; i < 3; i++) {
		const int64_t sum = int64_t(p_foreseen[i]) + p_difference[i];
		fits = fits && std::abs(sum) <= p_most;
		r_sum[i] = fits ? T(sum) : T(0);
	}
	return fits;
}

uint32_t chance(bool p_usual, uint32_t p_share) {
	return p_usual ? 65536 - p_share : p_share;
}

} // namespace

void BodyCodec::encode(
		RangeEncoder &p_encoder, const BodyState &p_now, const BodyState *p_base, int p_ticks, int p_tick_rate) {
	const BodyState nothing;
	const BodyState &base = p_base != nullptr ? *p_base : nothing;
	p_encoder.encode_bit(p_now.at_rest, chance(base.at_rest, SAME_REST));
	if (!p_now.at_rest) {
		encode_three(p_encoder, difference(p_now.velocity, base.velocity), VELOCITY);
		encode_three(p_encoder, difference(p_now.spin, base.spin), SPIN);
	}
	const std::array<int32_t, 3> position = foresee_position(base, p_now.velocity, p_ticks, p_tick_rate);
	encode_three(p_encoder, difference(p_now.position, position), POSITION);
	const bool same = p_now.turn.dropped == base.turn.dropped;
	p_encoder.encode_bit(!same, SAME_CHART);
	if (!same) {
		p_encoder.encode_bits(p_now.turn.dropped, 2);
	}
	const std::array<int16_t, 3> parts = foresee_turn(base, p_now.spin, p_ticks, p_tick_rate, int(p_now.turn.dropped));
	encode_three(p_encoder, difference(p_now.turn.parts, parts), TURN);
}

bool BodyCodec::decode(
		RangeDecoder &p_decoder, const BodyState *p_base, int p_ticks, int p_tick_rate, BodyState &r_now) {
	const BodyState nothing;
	const BodyState &base = p_base != nullptr ? *p_base : nothing;
	BodyState now;
	now.at_rest = p_decoder.decode_bit(chance(base.at_rest, SAME_REST));
	bool fits = true;
	if (!now.at_rest) {
		fits = add(base.velocity, decode_three(p_decoder, VELOCITY), INT16_MAX, now.velocity);
		fits = add(base.spin, decode_three(p_decoder, SPIN), INT16_MAX, now.spin) && fits;
	}
	const std::array<int32_t, 3> position = foresee_position(base, now.velocity, p_ticks, p_tick_rate);
	const int64_t farthest = int64_t(FARTHEST_M) * 1000;
	fits = add(position, decode_three(p_decoder, POSITION), farthest, now.position) && fits;
	now.turn.dropped = base.turn.dropped;
	if (p_decoder.decode_bit(SAME_CHART)) {
		now.turn.dropped = uint8_t(p_decoder.decode_bits(2));
	}
	const std::array<int16_t, 3> parts = foresee_turn(base, now.spin, p_ticks, p_tick_rate, int(now.turn.dropped));
	fits = add(parts, decode_three(p_decoder, TURN), BODY_TURN_SCALE, now.turn.parts) && fits;
	int square = 0;
	for (const int16_t part : now.turn.parts) {
		square += part * part;
	}
	r_now = now;
	// A little above 1 can come from rounding.
	return fits && square <= (BODY_TURN_SCALE + 2) * (BODY_TURN_SCALE + 2) && !p_decoder.is_bad();
}

} // namespace wire
