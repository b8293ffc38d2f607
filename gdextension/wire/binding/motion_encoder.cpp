// SPDX-License-Identifier: MIT
#include "motion_encoder.hpp"

#include "pose_arrays.hpp"
#include <convert.hpp>
#include <replication/datagram.hpp>

#include <algorithm>
#include <array>

namespace godot {

bool MotionEncoder::configure(const PackedInt32Array &p_parents, double p_max_error_deg, int64_t p_first) {
	kinematics::Skeleton skeleton;
	_core.reset();
	if (!read_parents(p_parents, skeleton) || !is_pose_error(p_max_error_deg)) {
		return false;
	}
	_limb_count = skeleton.limb_count;
	_core = std::make_unique<wire::MotionEncoder>(skeleton, p_max_error_deg, uint32_t(p_first));
	return true;
}

void MotionEncoder::begin(int64_t p_time_usec, int64_t p_held_usec, int64_t p_sent_usec) {
	ERR_FAIL_COND_MSG(_core == nullptr, "MotionEncoder: call configure() first.");
	_core->begin(p_time_usec, p_held_usec, p_sent_usec);
}

bool MotionEncoder::put(int64_t p_person, int64_t p_sample, int64_t p_time_usec, const Vector3 &p_root,
		const PackedFloat32Array &p_orientations) {
	ERR_FAIL_COND_V_MSG(_core == nullptr, false, "MotionEncoder: call configure() first.");
	kinematics::PersonPose pose;
	pose.root = to_core(p_root);
	return p_person >= 0 && p_person < int64_t(wire::MAX_WEARERS) &&
			read_orientations(p_orientations, _limb_count, pose) &&
			_core->put(std::size_t(p_person), uint32_t(p_sample), p_time_usec, pose);
}

PackedByteArray MotionEncoder::finish() {
	PackedByteArray result;
	ERR_FAIL_COND_V_MSG(_core == nullptr, result, "MotionEncoder: call configure() first.");
	std::array<uint8_t, wire::MAX_BYTES> bytes{};
	const std::size_t size = _core->finish(bytes.data(), bytes.size());
	result.resize(int64_t(size));
	std::copy_n(bytes.begin(), size, result.ptrw());
	return result;
}

bool MotionEncoder::take_ack(const PackedByteArray &p_bytes) {
	return _core != nullptr && _core->take_ack(p_bytes.ptr(), std::size_t(p_bytes.size()));
}

void MotionEncoder::_bind_methods() {
	ClassDB::bind_method(D_METHOD("configure", "parents", "max_error_deg", "first"), &MotionEncoder::configure);
	ClassDB::bind_method(D_METHOD("begin", "time_usec", "held_usec", "sent_usec"), &MotionEncoder::begin);
	ClassDB::bind_method(D_METHOD("put", "person", "sample", "time_usec", "root", "orientations"), &MotionEncoder::put);
	ClassDB::bind_method(D_METHOD("finish"), &MotionEncoder::finish);
	ClassDB::bind_method(D_METHOD("take_ack", "bytes"), &MotionEncoder::take_ack);
}

} // namespace godot
