// SPDX-License-Identifier: MIT
#pragma once

#include "motion/motion_packet.hpp"
#include "range_coder.hpp"

namespace wire {

/// Writes numbers.
class MotionWriter {
public:
	explicit MotionWriter(RangeEncoder &p_encoder) : _encoder(p_encoder) {}

	void bit(bool &p_one, uint32_t p_zero) { _encoder.encode_bit(p_one, p_zero); }
	void bits(uint32_t &p_value, int p_count) { _encoder.encode_bits(p_value, p_count); }
	bool person(const PersonCodec &p_codec, PersonState &p_now, const PersonState *p_base, const PersonState *p_before,
			int p_age, int p_older) {
		p_codec.encode(_encoder, p_now, p_base, p_before, p_age, p_older);
		return true;
	}

private:
	RangeEncoder &_encoder;
};

/// Reads them.
class MotionReader {
public:
	explicit MotionReader(RangeDecoder &p_decoder) : _decoder(p_decoder) {}

	void bit(bool &r_one, uint32_t p_zero) { r_one = _decoder.decode_bit(p_zero); }
	void bits(uint32_t &r_value, int p_count) { r_value = _decoder.decode_bits(p_count); }
	bool person(const PersonCodec &p_codec, PersonState &r_now, const PersonState *p_base, const PersonState *p_before,
			int p_age, int p_older) {
		return p_codec.decode(_decoder, r_now, p_base, p_before, p_age, p_older);
	}

private:
	RangeDecoder &_decoder;
};

/// What both ends of a motion stream share.
struct MotionCoding {
	static constexpr uint8_t MESSAGE = 1; ///< First byte of a datagram.
	static constexpr int AGE_BITS = 5; ///< Of the baseline's age in datagrams.
	static constexpr int SPACING_BITS = 3; ///< Of how much older the second baseline is; 0: there is none.
	static constexpr uint32_t MAX_AGE = (1U << AGE_BITS) - 1;
	static constexpr uint32_t MAX_SPACING = (1U << SPACING_BITS) - 1;
	static constexpr float ROOT_UNIT = 0.00025f; ///< m
	static constexpr int64_t MAX_TIME_USEC = int64_t(1) << 60; ///< Times beyond are none.
	static constexpr int64_t MAX_LATE_USEC = 10000000; ///< Samples of one datagram are not further apart.
	static constexpr int64_t PERIOD_USEC = 16667; ///< Time between two datagrams where nothing else is known.
};

/// Codes a datagram behind its first byte through a port: MotionWriter or MotionReader.
template <class Port>
class MotionCoder {
public:
	MotionCoder(Port &r_port, const PersonCodec &p_codec) : _port(r_port), _codec(p_codec) {}

	/// Whether there are baselines, and which: how many datagrams older, and how much older still the second.
	void code_baseline(bool &r_has_base, uint32_t &r_number, uint32_t &r_age, uint32_t &r_spacing) {
		_port.bit(r_has_base, HAS_NONE);
		if (!r_has_base) {
			_port.bits(r_number, 32);
			r_age = 0;
			r_spacing = 0;
			return;
		}
		uint32_t low = r_number & 0xFF;
		_port.bits(low, 8);
		r_number = low;
		_port.bits(r_age, MotionCoding::AGE_BITS);
		_port.bits(r_spacing, MotionCoding::SPACING_BITS);
	}
	/// The rest. False if that is nothing that an encoder writes.
	bool code(MotionPacket &r_packet, const MotionPacket *p_base, const MotionPacket *p_before) {
		if (!_code_times(r_packet, p_base, p_before)) {
			return false;
		}
		bool others = p_base == nullptr || r_packet.people != p_base->people;
		if (p_base != nullptr) {
			_port.bit(others, SAME);
		}
		uint32_t people = r_packet.people;
		if (others) {
			_port.bits(people, int(MAX_WEARERS));
		}
		r_packet.people = others ? uint8_t(people) : p_base->people;
		for (std::size_t i = 0; i < MAX_WEARERS; i++) {
			if (r_packet.has(i) && !_code_person(i, r_packet, p_base, p_before)) {
				return false;
			}
		}
		return r_packet.people != 0;
	}

private:
	static constexpr uint32_t HAS_NONE = 1000; // Of 65536, like the others.
	static constexpr uint32_t SAME = 65000;
	static constexpr uint32_t UNKNOWN = 1000;
	static constexpr int LENGTH_BITS = 4;
	static constexpr uint32_t LONG = 15;

	static bool _is_time(int64_t p_usec) {
		return p_usec >= -MotionCoding::MAX_TIME_USEC && p_usec <= MotionCoding::MAX_TIME_USEC;
	}
	// A number as its length in bits and what follows the first one. Small ones are short.
	void _code_unsigned(uint64_t &r_value) {
		uint32_t length = 0;
		while (length < 64 && (r_value >> length) != 0) {
			length++;
		}
		uint32_t head = length < LONG ? length : LONG;
		_port.bits(head, LENGTH_BITS);
		length = head < LONG ? head : length;
		if (head == LONG) {
			_port.bits(length, 6);
		}
		uint64_t value = length > 0 ? uint64_t(1) << (length - 1) : 0;
		const uint64_t rest = r_value ^ value;
		for (int left = int(length) - 1; left > 0;) {
			const int count = left < 16 ? left : 16;
			left -= count;
			uint32_t part = uint32_t(rest >> left) & ((1U << count) - 1);
			_port.bits(part, count);
			value |= uint64_t(part) << left;
		}
		r_value = value;
	}
	void _code_signed(int64_t &r_value) {
		uint64_t folded = (uint64_t(r_value) << 1) ^ (r_value < 0 ? ~uint64_t(0) : 0);
		_code_unsigned(folded);
		r_value = int64_t((folded >> 1) ^ ((folded & 1) != 0 ? ~uint64_t(0) : 0));
	}
	// A number against what is expected; false if it is out of range.
	bool _code_against(int64_t &r_value, int64_t p_expected) {
		int64_t off = int64_t(uint64_t(r_value) - uint64_t(p_expected));
		_code_signed(off);
		r_value = int64_t(uint64_t(p_expected) + uint64_t(off));
		return _is_time(r_value);
	}

	bool _code_times(MotionPacket &r_packet, const MotionPacket *p_base, const MotionPacket *p_before) {
		int64_t expected = 0;
		if (p_base != nullptr) {
			const int64_t age = int64_t(r_packet.number - p_base->number);
			const int64_t passed = p_before != nullptr
					? (p_base->time_usec - p_before->time_usec) * age / int64_t(p_base->number - p_before->number)
					: MotionCoding::PERIOD_USEC * age;
			expected = p_base->time_usec + passed;
		}
		uint64_t held = uint64_t(r_packet.held);
		if (!_code_against(r_packet.time_usec, expected) || r_packet.time_usec < 0) {
			return false;
		}
		_code_unsigned(held);
		if (held > UINT32_MAX) {
			return false;
		}
		r_packet.held = int64_t(held);
		_port.bit(r_packet.has_sent, UNKNOWN);
		const bool is_base_known = p_base != nullptr && p_base->has_sent;
		if (r_packet.has_sent && !_code_against(r_packet.ahead, is_base_known ? p_base->ahead : 0)) {
			return false;
		}
		return !r_packet.has_sent || (_is_time(r_packet.ahead * 8) && r_packet.sent_usec() >= 0);
	}

	bool _code_person(
			std::size_t p_index, MotionPacket &r_packet, const MotionPacket *p_base, const MotionPacket *p_before) {
		MotionPerson &person = r_packet.persons[p_index];
		const bool has_base = p_base != nullptr && p_base->has(p_index);
		const bool has_before = has_base && p_before != nullptr && p_before->has(p_index);
		const uint32_t age = p_base != nullptr ? r_packet.number - p_base->number : 0;
		const uint32_t older = has_before ? r_packet.number - p_before->number : age;
		const uint32_t expected = has_base ? p_base->persons[p_index].id + age : 0;
		bool other = person.id != expected;
		_port.bit(other, has_base ? SAME : UNKNOWN);
		if (other) {
			_port.bits(person.id, 32);
		} else {
			person.id = expected;
		}
		if (!_code_against(person.late_usec, has_base ? p_base->persons[p_index].late_usec : 0) ||
				person.late_usec > MotionCoding::MAX_LATE_USEC || person.late_usec < -MotionCoding::MAX_LATE_USEC ||
				r_packet.time_usec + person.late_usec < 0) {
			return false;
		}
		return _port.person(_codec, person.state, has_base ? &p_base->persons[p_index].state : nullptr,
				has_before ? &p_before->persons[p_index].state : nullptr, int(age), int(older));
	}

	Port &_port;
	const PersonCodec &_codec;
};

} // namespace wire
