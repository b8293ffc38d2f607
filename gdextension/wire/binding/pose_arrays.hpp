// SPDX-License-Identifier: MIT
#pragma once

#include <skeleton.hpp>

#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

#include <limits>

namespace godot {

/// Numbers of a limb in an array of transforms: its position, then its quaternion.
constexpr int64_t TRANSFORM_SIZE = 7;

/// Whether a script's number can be that of a person or body.
inline bool is_id(int64_t p_id) {
	return p_id >= 0 && p_id <= std::numeric_limits<uint16_t>::max();
}

/// A skeleton from a script's arrays; false if they make none.
inline bool read_skeleton(const PackedInt32Array &p_parents, const PackedVector3Array &p_in_parent,
		const PackedVector3Array &p_in_limb, kinematics::Skeleton &r_skeleton) {
	const int64_t count = p_parents.size();
	if (count > kinematics::MAX_LIMBS || p_in_parent.size() != count || p_in_limb.size() != count) {
		return false;
	}
	r_skeleton.limb_count = int(count);
	for (int64_t i = 0; i < count; i++) {
		const Vector3 outer = p_in_parent[i];
		const Vector3 inner = p_in_limb[i];
		r_skeleton.parents[std::size_t(i)] = p_parents[i];
		r_skeleton.joints_in_parent[std::size_t(i)] = { outer.x, outer.y, outer.z };
		r_skeleton.joints_in_limb[std::size_t(i)] = { inner.x, inner.y, inner.z };
	}
	return r_skeleton.is_sound();
}

/// A skeleton whose joints do not matter; false if these are no parents.
inline bool read_parents(const PackedInt32Array &p_parents, kinematics::Skeleton &r_skeleton) {
	PackedVector3Array joints;
	joints.resize(p_parents.size());
	return read_skeleton(p_parents, joints, joints, r_skeleton);
}

/// Whether poses can be coded with an error of so many degrees.
inline bool is_pose_error(double p_degrees) {
	return p_degrees >= 0.02 && p_degrees <= 5.0;
}

/// Orientations from four floats (x, y, z, w) a limb; false if there are too few.
inline bool read_orientations(const PackedFloat32Array &p_floats, int p_count, kinematics::PersonPose &r_pose) {
	if (p_floats.size() != int64_t(p_count) * 4) {
		return false;
	}
	const float *floats = p_floats.ptr();
	for (std::size_t i = 0; i < std::size_t(p_count); i++) {
		r_pose.orientations[i] = { floats[i * 4], floats[i * 4 + 1], floats[i * 4 + 2], floats[i * 4 + 3] };
	}
	return true;
}

/// TRANSFORM_SIZE floats a limb.
inline PackedFloat32Array write_transforms(const kinematics::PersonPose &p_pose,
		const std::array<kinematics::Vec3, kinematics::MAX_LIMBS> &p_positions, int p_count) {
	PackedFloat32Array result;
	result.resize(p_count * TRANSFORM_SIZE);
	float *into = result.ptrw();
	for (std::size_t i = 0; i < std::size_t(p_count); i++) {
		const kinematics::Vec3 &position = p_positions[i];
		const kinematics::Quat &turn = p_pose.orientations[i];
		for (const float number : { position.x, position.y, position.z, turn.x, turn.y, turn.z, turn.w }) {
			*into++ = number;
		}
	}
	return result;
}

} // namespace godot
