// SPDX-License-Identifier: MIT
#include "motion/motion_decoder.hpp"

#include "motion/motion_coding.hpp"
#include "replication/datagram.hpp"

namespace wire {

MotionDecoder::MotionDecoder(const Skeleton &p_skeleton, double p_max_error_deg) :
		_skeleton(p_skeleton),
		_lattice(PersonLattice::resolution_for(p_max_error_deg)),
		_codec(p_skeleton, _lattice.resolution()) {}

// Which datagram it is, from the number that it tells: whole, or the low byte.
MotionDecoder::Outcome MotionDecoder::_place(bool p_has_base, uint32_t &r_number) const {
	if (p_has_base) {
		if (!_has_newest) {
			return Outcome::UNKNOWN_BASE;
		}
		r_number = _newest + uint32_t(int32_t(int8_t(uint8_t(r_number - _newest))));
	}
	const int32_t ahead = int32_t(r_number - _newest);
	constexpr int32_t KEPT = int32_t(MotionHistory::KEPT);
	if (!_has_newest || (!p_has_base && (ahead >= KEPT || ahead <= -KEPT))) {
		return Outcome::OK; // An encoder begins.
	}
	if (ahead <= -KEPT || _history.find(r_number) != nullptr) {
		return Outcome::OLD;
	}
	return Outcome::OK;
}

MotionDecoder::Outcome MotionDecoder::decode(const uint8_t *p_bytes, std::size_t p_size) {
	const bool has_base = p_size > 0 && (p_bytes[0] & MotionCoding::BASED) != 0;
	if (p_size < 2 || p_size > MAX_BYTES || (!has_base && p_bytes[0] != MotionCoding::MESSAGE)) {
		return Outcome::BROKEN;
	}
	RangeDecoder decoder(p_bytes + 1, p_size - 1);
	MotionReader reader(decoder);
	MotionCoder<MotionReader> coder(reader, _codec);
	uint32_t number = 0;
	uint32_t age = 0;
	uint32_t spacing = 0;
	if (has_base) {
		coder.code_baseline(number, age, spacing);
		number = (number << MotionCoding::FIRST_BITS) | (p_bytes[0] & ~uint32_t(MotionCoding::BASED));
	} else {
		coder.code_number(number);
	}
	if (decoder.is_bad() || (has_base && age == 0)) {
		return Outcome::BROKEN;
	}
	const Outcome outcome = _place(has_base, number);
	if (outcome != Outcome::OK) {
		return outcome;
	}
	const MotionPacket *base = has_base ? _history.find(number - age) : nullptr;
	const MotionPacket *before = spacing > 0 ? _history.find(number - age - spacing) : nullptr;
	if ((has_base && base == nullptr) || (spacing > 0 && before == nullptr)) {
		return Outcome::UNKNOWN_BASE;
	}
	_reading = MotionPacket();
	_reading.number = number;
	if (!coder.code(_reading, base, before) || decoder.is_bad()) {
		return Outcome::BROKEN;
	}
	_used = decoder.used() + 1;
	_keep();
	return Outcome::OK;
}

// Keeps what was read as a baseline.
void MotionDecoder::_keep() {
	constexpr int32_t KEPT = int32_t(MotionHistory::KEPT);
	const int32_t ahead = int32_t(_reading.number - _newest);
	const bool begins = !_has_newest || ahead >= KEPT || ahead <= -KEPT;
	if (begins) {
		_history.clear();
	}
	if (begins || ahead > 0) {
		_newest = _reading.number;
	}
	_has_newest = true;
	_reading.is_known = true;
	_packet = _reading;
	_history.slot(_packet.number) = _packet;
}

void MotionDecoder::restore(std::size_t p_person, PersonPose &r_pose) const {
	_lattice.restore(_packet.persons[p_person].state, _skeleton, r_pose);
	r_pose.root = r_pose.root * (MotionCoding::ROOT_UNIT / 0.001f);
}

bool MotionDecoder::write_ack(uint8_t *r_bytes) const {
	if (!_has_newest) {
		return false;
	}
	uint32_t bits = 0;
	for (uint32_t i = 1; i <= ACK_BITS; i++) {
		bits |= _history.find(_newest - i) != nullptr ? 1U << (i - 1) : 0;
	}
	r_bytes[0] = uint8_t(_newest);
	r_bytes[1] = uint8_t(bits);
	return true;
}

} // namespace wire
