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
	bool number(const NumberModel &p_model, int64_t &p_number) {
		return NumberWriter(_encoder).number(p_model, p_number);
	}
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
	bool number(const NumberModel &p_model, int64_t &r_number) {
		return NumberReader(_decoder).number(p_model, r_number);
	}
	bool person(const PersonCodec &p_codec, PersonState &r_now, const PersonState *p_base, const PersonState *p_before,
			int p_age, int p_older) {
		return p_codec.decode(_decoder, r_now, p_base, p_before, p_age, p_older);
	}

private:
	RangeDecoder &_decoder;
};

/// What both ends of a motion stream share.
struct MotionCoding {
	static constexpr uint8_t MESSAGE = 1; ///< First byte of a datagram without a baseline.
	static constexpr uint8_t BASED = 0x80; ///< Of one with a baseline, or the low 7 bits of its number.
	static constexpr int NUMBER_BITS = 8; ///< Of the number that one with a baseline tells.
	static constexpr int FIRST_BITS = 7; ///< Of these in the first byte.
	static constexpr int AGE_BITS = 5; ///< Of the baseline's age in datagrams.
	static constexpr int SPACING_BITS = 3; ///< Of how much older the second baseline is; 0: there is none.
	static constexpr uint32_t MAX_AGE = (1U << AGE_BITS) - 1;
	static constexpr uint32_t MAX_SPACING = (1U << SPACING_BITS) - 1;
	static constexpr float ROOT_UNIT = 0.00025f; ///< m
	static constexpr int64_t MAX_TIME_USEC = int64_t(1) << 60; ///< Times beyond are none.
	static constexpr int64_t MAX_LATE_USEC = 10000000; ///< Samples of one datagram are not further apart.
};

/// Codes a datagram behind its first byte through a port: MotionWriter or MotionReader. A writer leaves in
/// the packet what the reader gets: times are rounded.
template <class Port>
class MotionCoder {
public:
	MotionCoder(Port &r_port, const PersonCodec &p_codec) : _port(r_port), _codec(p_codec) {}

	/// The number of a datagram without a baseline.
	void code_number(uint32_t &r_number) { _port.bits(r_number, 32); }
	/// The highest of the bits of its number that one with a baseline tells, and its baselines: how many
	/// datagrams older, and how much older still the second.
	void code_baseline(uint32_t &r_high, uint32_t &r_age, uint32_t &r_spacing) {
		_port.bits(r_high, MotionCoding::NUMBER_BITS - MotionCoding::FIRST_BITS);
		bool old = r_age > 2;
		_port.bit(old, YOUNG);
		uint32_t rest = r_age - 1;
		_port.bits(old ? r_age : rest, old ? MotionCoding::AGE_BITS : 1);
		r_age = old ? r_age : rest + 1;
		bool apart = r_spacing != 1;
		_port.bit(apart, NEXT);
		if (apart) {
			_port.bits(r_spacing, MotionCoding::SPACING_BITS);
		} else {
			r_spacing = 1;
		}
	}
	/// The rest. False if that is nothing that an encoder writes.
	bool code(MotionPacket &r_packet, const MotionPacket *p_base, const MotionPacket *p_before) {
		if (!(p_base != nullptr ? _code_times(r_packet, *p_base) : _code_first_times(r_packet))) {
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
	static constexpr uint32_t YOUNG = 50000; // Chances of a 0, of 65536.
	static constexpr uint32_t NEXT = 55000;
	static constexpr uint32_t SAME = 65000;
	static constexpr uint32_t UNKNOWN = 1000;
	static constexpr int64_t MAX_FAR = MotionCoding::MAX_TIME_USEC / 16;
	static constexpr int LENGTH_BITS = 4;
	static constexpr uint32_t LONG = 15;
	static constexpr MotionSteps LATE_STEPS{ 3 };

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
	// False if it is beyond what times are.
	bool _code_signed(int64_t &r_value) {
		uint64_t folded = (uint64_t(r_value) << 1) ^ (r_value < 0 ? ~uint64_t(0) : 0);
		_code_unsigned(folded);
		r_value = int64_t((folded >> 1) ^ ((folded & 1) != 0 ? ~uint64_t(0) : 0));
		return _is_time(r_value);
	}
	// So many steps away from what was expected.
	bool _code_steps(int64_t &r_steps, const MotionSteps &p_known) {
		bool far = r_steps > MotionSteps::MAX_STEPS || r_steps < -MotionSteps::MAX_STEPS;
		_port.bit(far, SAME);
		if (far) {
			return _code_signed(r_steps) && r_steps <= MAX_FAR && r_steps >= -MAX_FAR;
		}
		return _port.number(p_known.model(), r_steps) && r_steps <= MotionSteps::MAX_STEPS &&
				r_steps >= -MotionSteps::MAX_STEPS;
	}
	// Steps of p_size that bring p_expected near a value; none where it is off by one size at most.
	static int64_t _steps_to(int64_t p_value, int64_t p_expected, int64_t p_size) {
		const int64_t off = p_value - p_expected;
		return off <= p_size && off >= -p_size ? 0 : rounded_quotient(off, p_size);
	}

	bool _code_first_times(MotionPacket &r_packet) {
		uint64_t held = uint64_t(r_packet.held);
		if (!_code_signed(r_packet.time_usec) || r_packet.time_usec < 0) {
			return false;
		}
		_code_unsigned(held);
		if (held > UINT32_MAX) {
			return false;
		}
		r_packet.held = int64_t(held);
		_port.bit(r_packet.has_sent, UNKNOWN);
		if (r_packet.has_sent && !_code_signed(r_packet.ahead)) {
			return false;
		}
		r_packet.beat.time_usec = r_packet.time_usec;
		return _is_sound(r_packet);
	}
	bool _code_times(MotionPacket &r_packet, const MotionPacket &p_base) {
		const int64_t later = int64_t(r_packet.number - p_base.number);
		const int64_t due = p_base.beat.due_usec(later);
		const int64_t wanted = r_packet.time_usec;
		int64_t steps = _steps_to(wanted, due, MotionPacket::UNIT_USEC);
		if (!_code_steps(steps, p_base.beat.steps) || !_is_time(due + steps * MotionPacket::UNIT_USEC)) {
			return false;
		}
		r_packet.time_usec = due + steps * MotionPacket::UNIT_USEC;
		r_packet.beat = p_base.beat.after(later, r_packet.time_usec, steps);
		_rounded_off_usec = wanted - r_packet.time_usec;
		steps = rounded_quotient(r_packet.held - p_base.held, MotionPacket::HELD_STEP);
		steps += p_base.held + steps * MotionPacket::HELD_STEP < 0 ? 1 : 0;
		if (!_code_steps(steps, p_base.held_steps)) {
			return false;
		}
		r_packet.held = p_base.held + steps * MotionPacket::HELD_STEP;
		r_packet.held_steps = p_base.held_steps.after(steps);
		_port.bit(r_packet.has_sent, p_base.has_sent ? UNKNOWN : SAME);
		const int64_t known = p_base.has_sent ? p_base.ahead : 0;
		steps = _steps_to(r_packet.ahead, known, 1);
		if (r_packet.has_sent && !_code_steps(steps, p_base.ahead_steps)) {
			return false;
		}
		r_packet.ahead = r_packet.has_sent ? known + steps : 0;
		r_packet.ahead_steps = r_packet.has_sent ? p_base.ahead_steps.after(steps) : p_base.ahead_steps;
		return _is_sound(r_packet);
	}
	static bool _is_sound(const MotionPacket &p_packet) {
		return p_packet.time_usec >= 0 && _is_time(p_packet.time_usec) && p_packet.held >= 0 &&
				p_packet.held <= UINT32_MAX &&
				(!p_packet.has_sent || (_is_time(p_packet.ahead * 8) && p_packet.sent_usec() >= 0));
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
		const int64_t usual = has_base ? p_base->persons[p_index].late_usec : 0;
		int64_t steps = _steps_to(person.late_usec + _rounded_off_usec, usual, MotionPacket::UNIT_USEC);
		if (!_code_steps(steps, LATE_STEPS) || !_is_time(steps * MotionPacket::UNIT_USEC)) {
			return false;
		}
		person.late_usec = usual + steps * MotionPacket::UNIT_USEC;
		if (person.late_usec > MotionCoding::MAX_LATE_USEC || person.late_usec < -MotionCoding::MAX_LATE_USEC ||
				r_packet.time_usec + person.late_usec < 0) {
			return false;
		}
		return _port.person(_codec, person.state, has_base ? &p_base->persons[p_index].state : nullptr,
				has_before ? &p_before->persons[p_index].state : nullptr, int(age), int(older));
	}

	Port &_port;
	const PersonCodec &_codec;
	int64_t _rounded_off_usec = 0; // A writer's: how much earlier the packet's time became.
};

} // namespace wire
