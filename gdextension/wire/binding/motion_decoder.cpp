// SPDX-License-Identifier: MIT
#include "motion_decoder.hpp"

#include "pose_arrays.hpp"
#include <convert.hpp>

#include <algorithm>

namespace godot {

bool MotionDecoder::configure(const PackedInt32Array &p_parents, double p_max_error_deg) {
	kinematics::Skeleton skeleton;
	_core.reset();
	_is_read = false;
	_posed = -1;
	if (!read_parents(p_parents, skeleton) || !is_pose_error(p_max_error_deg)) {
		return false;
	}
	_limb_count = skeleton.limb_count;
	_core = std::make_unique<wire::MotionDecoder>(skeleton, p_max_error_deg);
	return true;
}

MotionDecoder::Outcome MotionDecoder::decode(const PackedByteArray &p_bytes) {
	ERR_FAIL_COND_V_MSG(_core == nullptr, BROKEN, "MotionDecoder: call configure() first.");
	const Outcome outcome = Outcome(int(_core->decode(p_bytes.ptr(), std::size_t(p_bytes.size()))));
	_is_read = _is_read || outcome == OK;
	_posed = -1;
	return outcome;
}

bool MotionDecoder::_has(int64_t p_person) const {
	return _is_read && p_person >= 0 && p_person < int64_t(wire::MAX_WEARERS) &&
			_core->packet().has(std::size_t(p_person));
}

const kinematics::PersonPose &MotionDecoder::_pose_of(int64_t p_person) const {
	if (_posed != p_person) {
		_core->restore(std::size_t(p_person), _pose);
		_posed = p_person;
	}
	return _pose;
}

int64_t MotionDecoder::get_time_usec(int64_t p_person) const {
	if (!_has(p_person)) {
		return 0;
	}
	return _core->packet().time_usec + _core->packet().persons[std::size_t(p_person)].late_usec;
}

int64_t MotionDecoder::get_held_usec(int64_t p_person) const {
	if (!_has(p_person)) {
		return 0;
	}
	const int64_t held = _core->packet().held * wire::MotionPacket::UNIT_USEC;
	return std::max<int64_t>(held - _core->packet().persons[std::size_t(p_person)].late_usec, 0);
}

PackedInt32Array MotionDecoder::get_people() const {
	PackedInt32Array people;
	for (int64_t i = 0; i < int64_t(wire::MAX_WEARERS); i++) {
		if (_has(i)) {
			people.push_back(int32_t(i));
		}
	}
	return people;
}

int64_t MotionDecoder::get_sample(int64_t p_person) const {
	return _has(p_person) ? int64_t(_core->packet().persons[std::size_t(p_person)].id) : -1;
}

Vector3 MotionDecoder::get_root(int64_t p_person) const {
	return _has(p_person) ? from_core(_pose_of(p_person).root) : Vector3();
}

PackedFloat32Array MotionDecoder::get_orientations(int64_t p_person) const {
	PackedFloat32Array floats;
	if (!_has(p_person)) {
		return floats;
	}
	const kinematics::PersonPose &pose = _pose_of(p_person);
	floats.resize(int64_t(_limb_count) * 4);
	float *into = floats.ptrw();
	for (std::size_t i = 0; i < std::size_t(_limb_count); i++) {
		const kinematics::Quat &turn = pose.orientations[i];
		for (const float number : { turn.x, turn.y, turn.z, turn.w }) {
			*into++ = number;
		}
	}
	return floats;
}

PackedByteArray MotionDecoder::get_ack() const {
	PackedByteArray bytes;
	uint8_t ack[wire::MotionDecoder::ACK_BYTES];
	if (_core != nullptr && _core->write_ack(ack)) {
		for (const uint8_t byte : ack) {
			bytes.push_back(byte);
		}
	}
	return bytes;
}

void MotionDecoder::_bind_methods() {
	ClassDB::bind_method(D_METHOD("configure", "parents", "max_error_deg"), &MotionDecoder::configure);
	ClassDB::bind_method(D_METHOD("decode", "bytes"), &MotionDecoder::decode);
	ClassDB::bind_method(D_METHOD("get_used"), &MotionDecoder::get_used);
	ClassDB::bind_method(D_METHOD("get_time_usec", "person"), &MotionDecoder::get_time_usec);
	ClassDB::bind_method(D_METHOD("get_held_usec", "person"), &MotionDecoder::get_held_usec);
	ClassDB::bind_method(D_METHOD("get_sent_usec"), &MotionDecoder::get_sent_usec);
	ClassDB::bind_method(D_METHOD("get_people"), &MotionDecoder::get_people);
	ClassDB::bind_method(D_METHOD("get_sample", "person"), &MotionDecoder::get_sample);
	ClassDB::bind_method(D_METHOD("get_root", "person"), &MotionDecoder::get_root);
	ClassDB::bind_method(D_METHOD("get_orientations", "person"), &MotionDecoder::get_orientations);
	ClassDB::bind_method(D_METHOD("get_ack"), &MotionDecoder::get_ack);
	BIND_ENUM_CONSTANT(OK);
	BIND_ENUM_CONSTANT(OLD);
	BIND_ENUM_CONSTANT(UNKNOWN_BASE);
	BIND_ENUM_CONSTANT(BROKEN);
}

} // namespace godot
