// SPDX-License-Identifier: MIT
#pragma once

#include "coding/fixed_tables.hpp"
#include "coding/person_model.hpp"
#include "range_coder.hpp"

#include <cstdint>

namespace wire {

/// About 16 times the logarithm to base 2 of a number above 0, in whole numbers.
inline int log16(uint64_t p_number) {
	// Number of the highest bit, by an instruction: it is asked for a hundred times in each person.
	const int whole = 63 - __builtin_clzll(p_number);
	const uint64_t mantissa = whole >= 4 ? p_number >> (whole - 4) : p_number << (4 - whole);
	return 16 * whole + LOG16_OF_MANTISSA[mantissa & 15];
}

/// Where a number is expected, and how far from there: what its probability is made of.
///
/// Positions are in 1 / FRACTION units. The number is p_first + p_step * m for some whole m.
struct NumberModel {
	int64_t expected = 0; ///< In 1 / FRACTION units.
	int level = 0; ///< 16 times the logarithm to base 2 of the spread, in 1 / FRACTION units.
	const uint16_t *shares = nullptr; ///< SHARE_POINTS of them: what lies within multiples of the spread.
	int64_t first = 0; ///< One of the numbers that can be.
	int step = 1; ///< Distance of those that can be: 1 or 2.
};

/// Symbols of a number: buckets of 1 << shift numbers each; the middle one has the expected number.
class NumberSymbols {
public:
	/// Buckets to each side of the middle one; the last ones stand for all beyond.
	static constexpr int MAX_BUCKETS = 40;
	static constexpr int MIN_LEVEL = 16;
	static constexpr int MAX_LEVEL = 255;

	explicit NumberSymbols(const NumberModel &p_model) : _model(p_model) {
		const int level =
				p_model.level < MIN_LEVEL ? MIN_LEVEL : (p_model.level > MAX_LEVEL ? MAX_LEVEL : p_model.level);
		const int octaves = level / 16 - 7 - (p_model.step > 1 ? 1 : 0);
		shift = octaves > 0 ? octaves : 0;
		const int64_t width = int64_t(FRACTION_OF_UNIT) * p_model.step;
		const int64_t offset = p_model.expected - FRACTION_OF_UNIT * p_model.first + width / 2;
		// Rounded down; shifts, as a division by what is not known takes longer than all else here.
		const int64_t nearest = offset >> (p_model.step > 1 ? FRACTION_BITS + 1 : FRACTION_BITS);
		middle = nearest >> shift;
		_stride = width * (int64_t(1) << shift);
		_edge = FRACTION_OF_UNIT * p_model.first + middle * _stride - p_model.expected - width / 2;
		_reciprocal = RECIPROCAL_OF_LEVEL[level & 15];
		_scale = 6 + level / 16;
	}

	/// Share of 65536 of all buckets below p_bucket (relative to the middle), -MAX_BUCKETS to MAX_BUCKETS + 1.
	uint32_t below(int p_bucket) const {
		if (p_bucket <= -MAX_BUCKETS) {
			return 0;
		}
		if (p_bucket > MAX_BUCKETS) {
			return 1U << PROBABILITY_BITS;
		}
		const int64_t edge = _edge + p_bucket * _stride;
		const uint64_t distance = uint64_t(edge < 0 ? -edge : edge);
		// In 1 / 1024 of the spread.
		const uint64_t multiple = (distance * _reciprocal) >> _scale;
		const uint32_t half = _share_within(multiple);
		return uint32_t(p_bucket + MAX_BUCKETS) + (edge < 0 ? HALF - half : HALF + half);
	}
	/// The bucket that has a point of 65536, -MAX_BUCKETS to MAX_BUCKETS.
	int bucket_at(uint32_t p_point) const {
		// Steps that double from the middle, where most are; then their halves.
		int low = 0;
		int high = 1;
		if (below(0) <= p_point) {
			while (high <= MAX_BUCKETS && below(high) <= p_point) {
				const int step = 2 * (high - low);
				low = high;
				high = low + step > MAX_BUCKETS ? MAX_BUCKETS + 1 : low + step;
			}
		} else {
			high = 0;
			low = -1;
			while (low > -MAX_BUCKETS && below(low) > p_point) {
				const int step = 2 * (high - low);
				high = low;
				low = high - step < -MAX_BUCKETS ? -MAX_BUCKETS : high - step;
			}
		}
		while (high - low > 1) {
			const int between = low + (high - low) / 2;
			below(between) <= p_point ? low = between : high = between;
		}
		return low;
	}
	int64_t number_of(int64_t p_index) const { return _model.first + p_index * _model.step; }
	/// The bucket that an index is in, relative to the middle one.
	int64_t bucket_of(int64_t p_index) const { return (p_index >> shift) - middle; }
	int64_t index_of(int64_t p_number) const {
		const int64_t difference = p_number - _model.first;
		return _model.step > 1 ? difference / 2 : difference;
	}

	int shift = 0;
	int64_t middle = 0;

private:
	static constexpr int FRACTION_BITS = 4;
	static constexpr int FRACTION_OF_UNIT = 1 << FRACTION_BITS;
	static constexpr uint32_t HALF = (1U << (PROBABILITY_BITS - 1)) - MAX_BUCKETS - 1;

	uint32_t _share_within(uint64_t p_distance) const {
		const uint64_t at = p_distance >> 6;
		if (at >= SHARE_POINTS - 1) {
			return _model.shares[SHARE_POINTS - 1];
		}
		const uint32_t from = _model.shares[at];
		return from + (((_model.shares[at + 1] - from) * uint32_t(p_distance & 63)) >> 6);
	}

	const NumberModel &_model;
	// The lower edge of the middle bucket, how far it is from one bucket to the next, and what makes a distance one in
	// 1 / 1024 of the spread.
	int64_t _edge = 0;
	int64_t _stride = 0;
	uint64_t _reciprocal = 0;
	int _scale = 0;
};

/// Writes numbers and bits.
class NumberWriter {
public:
	explicit NumberWriter(RangeEncoder &p_encoder) : _encoder(p_encoder) {}

	bool number(const NumberModel &p_model, int64_t &p_number) {
		const NumberSymbols symbols(p_model);
		const int64_t index = symbols.index_of(p_number);
		const int64_t away = symbols.bucket_of(index);
		constexpr int64_t MAX = NumberSymbols::MAX_BUCKETS;
		const int bucket = int(away < -MAX ? -MAX : (away > MAX ? MAX : away));
		const uint32_t below = symbols.below(bucket);
		_encoder.encode(below, symbols.below(bucket + 1) - below);
		if (bucket == MAX || bucket == -MAX) {
			_excess(uint64_t((away < 0 ? -away : away) - MAX));
		}
		_encoder.encode_bits(uint32_t(index & ((int64_t(1) << symbols.shift) - 1)), symbols.shift);
		return true;
	}
	bool bit(uint32_t p_zero, bool &p_one) {
		_encoder.encode_bit(p_one, p_zero);
		return true;
	}
	bool bits(int p_count, uint32_t &p_value) {
		_encoder.encode_bits(p_value, p_count);
		return true;
	}

private:
	void _excess(uint64_t p_excess) {
		int size = 0;
		while (((p_excess + 1) >> (size + 1)) != 0) {
			size++;
		}
		_encoder.encode_bits(uint32_t(size), 5);
		_encoder.encode_bits(uint32_t((p_excess + 1) & ((uint64_t(1) << size) - 1)), size);
	}

	RangeEncoder &_encoder;
};

/// Reads what a NumberWriter wrote; false where that cannot be.
class NumberReader {
public:
	explicit NumberReader(RangeDecoder &p_decoder) : _decoder(p_decoder) {}

	bool number(const NumberModel &p_model, int64_t &r_number) {
		const NumberSymbols symbols(p_model);
		constexpr int MAX = NumberSymbols::MAX_BUCKETS;
		const uint32_t point = _decoder.peek();
		const int low = symbols.bucket_at(point);
		const uint32_t below = symbols.below(low);
		_decoder.decode(below, symbols.below(low + 1) - below);
		int64_t away = low;
		if (low == MAX || low == -MAX) {
			const uint32_t size = _decoder.decode_bits(5);
			const int64_t beyond = int64_t((uint64_t(1) << size) | _decoder.decode_bits(int(size))) - 1;
			away += low < 0 ? -beyond : beyond;
		}
		const int64_t index =
				(symbols.middle + away) * (int64_t(1) << symbols.shift) + int64_t(_decoder.decode_bits(symbols.shift));
		r_number = symbols.number_of(index);
		return !_decoder.is_bad();
	}
	bool bit(uint32_t p_zero, bool &r_one) {
		r_one = _decoder.decode_bit(p_zero);
		return !_decoder.is_bad();
	}
	bool bits(int p_count, uint32_t &r_value) {
		r_value = _decoder.decode_bits(p_count);
		return !_decoder.is_bad();
	}

private:
	RangeDecoder &_decoder;
};

} // namespace wire
