// SPDX-License-Identifier: MIT
#pragma once

#include <quaternion.hpp>

#include <godot_cpp/variant/basis.hpp>
#include <godot_cpp/variant/quaternion.hpp>
#include <godot_cpp/variant/vector3.hpp>

namespace godot {

// Between the engine's number types and the core's: the frames are the same.

inline kinematics::Vec3 to_core(const Vector3 &p_vector) {
	return { p_vector.x, p_vector.y, p_vector.z };
}

inline Vector3 from_core(const kinematics::Vec3 &p_vector) {
	return Vector3(p_vector.x, p_vector.y, p_vector.z);
}

inline kinematics::Quat to_core(const Quaternion &p_rotation) {
	return { p_rotation.x, p_rotation.y, p_rotation.z, p_rotation.w };
}

inline Quaternion from_core(const kinematics::Quat &p_rotation) {
	return Quaternion(p_rotation.x, p_rotation.y, p_rotation.z, p_rotation.w);
}

/// The rotation of a basis whose axes are of length 1 and at right angles.
inline kinematics::Quat to_core(const Basis &p_basis) {
	return kinematics::from_axes(
			to_core(p_basis.get_column(0)), to_core(p_basis.get_column(1)), to_core(p_basis.get_column(2)));
}

} // namespace godot
