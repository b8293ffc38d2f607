// SPDX-License-Identifier: MIT
#include "motion/motion_encoder.hpp"

#include "motion/motion_coding.hpp"
#include "motion/motion_decoder.hpp"
#include "replication/datagram.hpp"

#include <algorithm>

namespace wire {

namespace {

constexpr int64_t MAX_HELD_USEC = 3600000000;
constexpr int64_t MIN_SENT_USEC = 1000;
// Room for what is rounded.
constexpr int64_t MAX_LATE_USEC = MotionCoding::MAX_LATE_USEC - 1000;

} // namespace

MotionEncoder::MotionEncoder(const Skeleton &p_skeleton, double p_max_error_deg, uint32_t p_first) :
		_skeleton(p_skeleton),
		_lattice(PersonLattice::resolution_for(p_max_error_deg)),
		_codec(p_skeleton, _lattice.resolution()),
		_number(p_first) {}

void MotionEncoder::begin(int64_t p_time_usec, int64_t p_held_usec, int64_t p_sent_usec) {
	constexpr int64_t MAX = MotionCoding::MAX_TIME_USEC / 16;
	_packet.people = 0;
	_packet.time_usec = std::clamp<int64_t>(p_time_usec, 0, MAX);
	const int64_t held = std::clamp<int64_t>(p_held_usec, 0, MAX_HELD_USEC);
	_packet.held = held / MotionPacket::UNIT_USEC;
	const int64_t sent = std::clamp<int64_t>(p_sent_usec, 0, MAX);
	// What is that near to 0 may become negative when it is rounded.
	_packet.has_sent = sent >= MIN_SENT_USEC;
	_packet.ahead = _packet.has_sent ? (sent - _packet.time_usec - held) / MotionPacket::UNIT_USEC : 0;
}

bool MotionEncoder::put(std::size_t p_person, uint32_t p_sample, int64_t p_time_usec, const PersonPose &p_pose) {
	if (p_person >= MAX_WEARERS) {
		return false;
	}
	PersonPose pose = p_pose;
	// The lattice is one of millimetres.
	pose.root = pose.root * (0.001f / MotionCoding::ROOT_UNIT);
	MotionPerson &person = _packet.persons[p_person];
	const PersonState *previous = _has_previous[p_person] ? &_previous[p_person] : nullptr;
	if (!_lattice.quantise(pose, _skeleton, previous, person.state)) {
		return false;
	}
	person.id = p_sample;
	const int64_t time = std::clamp<int64_t>(p_time_usec, 0, MotionCoding::MAX_TIME_USEC / 16);
	person.late_usec = std::clamp(time - _packet.time_usec, -MAX_LATE_USEC, MAX_LATE_USEC);
	_previous[p_person] = person.state;
	_has_previous[p_person] = true;
	_packet.people = uint8_t(_packet.people | (1U << p_person));
	return true;
}

// The newest acknowledged datagram that is from p_from to p_to numbers older than the one that is written.
const MotionPacket *MotionEncoder::_baseline(uint32_t p_from, uint32_t p_to) const {
	for (uint32_t age = p_from; age <= p_to; age++) {
		const MotionPacket *packet = _history.find(_number - age);
		if (packet != nullptr) {
			return packet;
		}
	}
	return nullptr;
}

std::size_t MotionEncoder::finish(uint8_t *r_bytes, std::size_t p_capacity) {
	if (_packet.people == 0 || p_capacity == 0) {
		return 0;
	}
	_packet.number = _number;
	_packet.is_known = false;
	const MotionPacket *base = _baseline(1, MotionCoding::MAX_AGE);
	uint32_t age = base != nullptr ? _number - base->number : 0;
	const MotionPacket *before = base != nullptr ? _baseline(age + 1, age + MotionCoding::MAX_SPACING) : nullptr;
	uint32_t spacing = before != nullptr ? base->number - before->number : 0;
	r_bytes[0] = base != nullptr ? uint8_t(MotionCoding::BASED | (_number & 0x7F)) : MotionCoding::MESSAGE;
	RangeEncoder encoder(r_bytes + 1, p_capacity - 1);
	MotionWriter writer(encoder);
	MotionCoder<MotionWriter> coder(writer, _codec);
	if (base != nullptr) {
		uint32_t high = (_number >> MotionCoding::FIRST_BITS) & 1;
		coder.code_baseline(high, age, spacing);
	} else {
		coder.code_number(_packet.number);
		_packet.beat = MotionBeat();
		_packet.held_steps = MotionSteps();
		_packet.ahead_steps = MotionSteps();
	}
	const bool is_sound = coder.code(_packet, base, before);
	const std::size_t size = encoder.finish();
	if (!is_sound || size == 0) {
		return 0;
	}
	_history.slot(_number) = _packet;
	_number++;
	return size + 1;
}

bool MotionEncoder::take_ack(const uint8_t *p_bytes, std::size_t p_size) {
	if (p_size != MotionDecoder::ACK_BYTES) {
		return false;
	}
	const uint32_t back = (_number - p_bytes[0]) & 0xFF;
	if (back == 0 || back > MotionHistory::KEPT) {
		return true; // Too old to be of use, or of an encoder before this one.
	}
	const uint32_t bits = uint32_t(p_bytes[1]) << 1 | 1;
	for (uint32_t i = 0; i <= MotionDecoder::ACK_BITS; i++) {
		MotionPacket &packet = _history.slot(_number - back - i);
		if (((bits >> i) & 1U) != 0 && packet.number == _number - back - i && packet.people != 0) {
			packet.is_known = true;
		}
	}
	return true;
}

} // namespace wire
