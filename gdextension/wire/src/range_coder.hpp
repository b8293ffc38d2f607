// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace wire {

/// Bits of the probabilities that RangeEncoder and RangeDecoder work with: 1 is 1 << 16.
constexpr int PROBABILITY_BITS = 16;

/// Writes symbols of known probabilities as bytes (a range coder: Martin 1979, Schindler 1998), into a
/// buffer that somebody else owns. What is written ends by itself: the decoder finds its last byte
/// without a length, whatever follows.
class RangeEncoder {
public:
	RangeEncoder(uint8_t *p_buffer, std::size_t p_capacity) : _buffer(p_buffer), _capacity(p_capacity) {}

	/// Writes a symbol that takes p_share of 1 << p_bits, with p_below of the symbols before it.
	/// p_bits is 1 to 16, p_share at least 1.
	void encode(uint32_t p_below, uint32_t p_share, int p_bits = PROBABILITY_BITS) {
		const uint32_t unit = _range >> p_bits;
		const uint32_t before = _low;
		_low += unit * p_below;
		if (_low < before) {
			_carry();
		}
		_range = unit * p_share;
		while (_range < MIN_RANGE) {
			_put(uint8_t(_low >> 24));
			_low <<= 8;
			_range <<= 8;
		}
	}
	/// Writes the lowest p_count bits of a number, 0 to 32 of them, all equally likely.
	void encode_bits(uint32_t p_value, int p_count) {
		while (p_count > 16) {
			p_count -= 16;
			encode((p_value >> p_count) & 0xFFFF, 1, 16);
		}
		if (p_count > 0) {
			encode(p_value & ((1U << p_count) - 1), 1, p_count);
		}
	}
	/// Writes a bit whose chance to be 0 is p_zero of 65536 (1 to 65535).
	void encode_bit(bool p_one, uint32_t p_zero) {
		p_one ? encode(p_zero, (1U << PROBABILITY_BITS) - p_zero) : encode(0, p_zero);
	}
	/// Ends it; nothing may be written any more. Returns the number of bytes, or 0 if the buffer was
	/// too small.
	std::size_t finish() {
		const uint32_t before = _low;
		const uint32_t slack = _range >= 2 * MIN_RANGE ? MIN_RANGE - 1 : 0xFFFF;
		_low += slack;
		if (_low < before) {
			_carry();
		}
		_put(uint8_t(_low >> 24));
		if (slack == 0xFFFF) {
			_put(uint8_t(_low >> 16));
		}
		return _full ? 0 : _size;
	}

	/// Bytes that are written for sure; a few more come at the end.
	std::size_t written() const { return _size; }

	static constexpr uint32_t MIN_RANGE = 1U << 24;

private:
	void _put(uint8_t p_byte) {
		if (_size < _capacity) {
			_buffer[_size++] = p_byte;
		} else {
			_full = true;
		}
	}
	// The first byte never overflows: all that is written is a fraction below 1.
	void _carry() {
		std::size_t at = _full ? 0 : _size;
		while (at > 0) {
			--at;
			++_buffer[at];
			if (_buffer[at] != 0) {
				break;
			}
		}
	}

	uint8_t *_buffer;
	std::size_t _capacity;
	std::size_t _size = 0;
	uint32_t _low = 0;
	uint32_t _range = 0xFFFFFFFF;
	bool _full = false;
};

/// Reads what a RangeEncoder wrote. Any bytes can be read: what makes no sense gives some symbols, and
/// is_bad() then tells if it notices.
class RangeDecoder {
public:
	RangeDecoder(const uint8_t *p_bytes, std::size_t p_size) : _bytes(p_bytes), _size(p_size) {
		for (int i = 0; i < 4; i++) {
			_code = (_code << 8) | _next();
		}
	}

	/// Where the next symbol lies in 0 to (1 << p_bits) - 1; then call decode() with its share.
	uint32_t peek(int p_bits = PROBABILITY_BITS) {
		_unit = _range >> p_bits;
		const uint32_t point = _code / _unit;
		if (point >> p_bits != 0) {
			_bad = true;
			return (1U << p_bits) - 1;
		}
		return point;
	}
	/// Goes on behind a symbol that peek() found.
	void decode(uint32_t p_below, uint32_t p_share) {
		_code -= _unit * p_below;
		_range = _unit * p_share;
		while (_range < RangeEncoder::MIN_RANGE) {
			_code = (_code << 8) | _next();
			_range <<= 8;
		}
	}
	uint32_t decode_bits(int p_count) {
		uint32_t value = 0;
		while (p_count > 16) {
			p_count -= 16;
			value = (value << 16) | _take(16);
		}
		return p_count > 0 ? (value << p_count) | _take(p_count) : value;
	}
	bool decode_bit(uint32_t p_zero) {
		const bool one = peek() >= p_zero;
		one ? decode(p_zero, (1U << PROBABILITY_BITS) - p_zero) : decode(0, p_zero);
		return one;
	}
	/// Bytes that the encoder wrote up to here, if it ended here.
	std::size_t used() const { return _taken - 4 + (_range >= 2 * RangeEncoder::MIN_RANGE ? 1 : 2); }
	/// Whether this cannot come from an encoder, or is cut off.
	bool is_bad() const { return _bad || used() > _size; }

private:
	uint8_t _next() {
		const uint8_t byte = _taken < _size ? _bytes[_taken] : 0;
		_taken++;
		return byte;
	}
	uint32_t _take(int p_count) {
		const uint32_t value = peek(p_count);
		decode(value, 1);
		return value;
	}

	const uint8_t *_bytes;
	std::size_t _size;
	std::size_t _taken = 0;
	uint32_t _code = 0;
	uint32_t _range = 0xFFFFFFFF;
	uint32_t _unit = 1;
	bool _bad = false;
};

} // namespace wire
