// SPDX-License-Identifier: MIT
#include "pose_codec.hpp"

#include <array>

namespace godot {

namespace {

using Rotations = std::array<kinematics::Quat, PoseCodec::MAX_LIMBS>;

bool is_coding(PoseCodec::Coding p_coding, int p_bits) {
	return int(p_coding) >= 0 && int(p_coding) <= int(PoseCodec::SMALLEST_3) && p_bits >= wire::MIN_BITS &&
			p_bits <= wire::MAX_BITS;
}

} // namespace

PackedByteArray PoseCodec::encode(const PackedFloat32Array &p_orientations, Coding p_coding, int p_bits) {
	PackedByteArray bytes;
	const int64_t limbs = p_orientations.size() / 4;
	if (!is_coding(p_coding, p_bits) || p_orientations.size() % 4 != 0 || limbs < 1 || limbs > MAX_LIMBS) {
		return bytes;
	}
	Rotations rotations;
	const float *values = p_orientations.ptr();
	for (std::size_t i = 0; i < std::size_t(limbs); i++) {
		rotations[i] = { values[4 * i], values[4 * i + 1], values[4 * i + 2], values[4 * i + 3] };
	}
	const wire::PoseCoding coding = wire::PoseCoding(int(p_coding));
	bytes.resize(int64_t(wire::coded_size(coding, p_bits, std::size_t(limbs))));
	if (!wire::encode_pose(coding, p_bits, rotations.data(), std::size_t(limbs), bytes.ptrw())) {
		return PackedByteArray();
	}
	return bytes;
}

PackedFloat32Array PoseCodec::decode(const PackedByteArray &p_bytes, Coding p_coding, int p_bits) {
	PackedFloat32Array orientations;
	if (!is_coding(p_coding, p_bits) || p_bytes.is_empty() || p_bytes.size() > 16 * MAX_LIMBS) {
		return orientations;
	}
	const wire::PoseCoding coding = wire::PoseCoding(int(p_coding));
	const std::size_t limbs = wire::coded_limbs(coding, p_bits, std::size_t(p_bytes.size()));
	Rotations rotations;
	if (limbs < 1 || limbs > rotations.size() ||
			!wire::decode_pose(coding, p_bits, p_bytes.ptr(), std::size_t(p_bytes.size()), rotations.data())) {
		return orientations;
	}
	orientations.resize(int64_t(4 * limbs));
	float *values = orientations.ptrw();
	for (std::size_t i = 0; i < limbs; i++) {
		values[4 * i] = rotations[i].x;
		values[4 * i + 1] = rotations[i].y;
		values[4 * i + 2] = rotations[i].z;
		values[4 * i + 3] = rotations[i].w;
	}
	return orientations;
}

void PoseCodec::_bind_methods() {
	ClassDB::bind_static_method(
			"PoseCodec", D_METHOD("encode", "orientations", "coding", "bits"), &PoseCodec::encode, DEFVAL(15));
	ClassDB::bind_static_method(
			"PoseCodec", D_METHOD("decode", "bytes", "coding", "bits"), &PoseCodec::decode, DEFVAL(15));
	BIND_ENUM_CONSTANT(FLOATS);
	BIND_ENUM_CONSTANT(THESIS_12);
	BIND_ENUM_CONSTANT(THESIS_4);
	BIND_ENUM_CONSTANT(SMALLEST_3);
}

} // namespace godot
