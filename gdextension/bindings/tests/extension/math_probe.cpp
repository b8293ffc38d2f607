// SPDX-License-Identifier: MIT
#include "math_probe.hpp"

using namespace godot;

namespace probe {

Dictionary MathProbe::vectors(const Vector3 &p_left, const Vector3 &p_right) const {
	Dictionary results;
	results["+"] = p_left + p_right;
	results["-"] = p_left - p_right;
	results["*"] = p_left * p_right;
	results["/"] = p_left / p_right;
	results["scaled"] = p_left * 0.3f;
	results["negated"] = -p_left;
	results["dot"] = p_left.dot(p_right);
	results["cross"] = p_left.cross(p_right);
	results["length"] = p_left.length();
	results["length_squared"] = p_left.length_squared();
	results["normalized"] = p_left.normalized();
	results["zero normalized"] = Vector3().normalized();
	results["angle_to"] = p_left.angle_to(p_right);
	results["distance_to"] = p_left.distance_to(p_right);
	results["lerp"] = p_left.lerp(p_right, 0.25f);
	results["limit_length"] = p_left.limit_length(0.5f);
	results["is_finite"] = p_left.is_finite();
	return results;
}

Dictionary MathProbe::quaternions(
		const Quaternion &p_left, const Quaternion &p_right, double p_weight, const Vector3 &p_vector) const {
	Dictionary results;
	results["*"] = p_left * p_right;
	results["inverse"] = p_left.inverse();
	results["normalized"] = (p_left * 3.0f).normalized();
	results["dot"] = p_left.dot(p_right);
	results["length_squared"] = p_left.length_squared();
	results["slerp"] = p_left.slerp(p_right, float(p_weight));
	results["xform"] = p_left.xform(p_vector);
	results["angle_to"] = p_left.angle_to(p_right);
	results["get_angle"] = p_left.get_angle();
	results["get_axis"] = p_left.get_axis();
	results["log"] = p_left.log();
	results["exp"] = p_left.log().exp();
	results["basis"] = Basis(p_left);
	results["axis angle"] = Quaternion(p_vector.normalized(), float(p_weight));
	results["is_finite"] = p_left.is_finite();
	return results;
}

Dictionary MathProbe::bases(const Basis &p_left, const Basis &p_right, const Vector3 &p_vector) const {
	Dictionary results;
	results["*"] = p_left * p_right;
	results["transposed"] = p_left.transposed();
	results["inverse"] = p_left.inverse();
	results["determinant"] = p_left.determinant();
	results["orthonormalized"] = p_left.orthonormalized();
	results["get_scale"] = p_left.get_scale();
	results["get_rotation_quaternion"] = p_left.get_rotation_quaternion();
	results["xform"] = p_left.xform(p_vector);
	results["xform_inv"] = p_left.xform_inv(p_vector);
	results["column"] = p_left.get_column(1);
	return results;
}

Dictionary MathProbe::transforms(const Transform3D &p_left, const Transform3D &p_right, const Vector3 &p_vector) const {
	Dictionary results;
	results["*"] = p_left * p_right;
	results["inverse"] = p_left.orthonormalized().inverse();
	results["affine_inverse"] = p_left.affine_inverse();
	results["xform"] = p_left.xform(p_vector);
	results["translated_local"] = p_left.translated_local(p_vector);
	results["is_finite"] = p_left.is_finite();
	return results;
}

void MathProbe::_bind_methods() {
	ClassDB::bind_method(D_METHOD("vectors", "left", "right"), &MathProbe::vectors);
	ClassDB::bind_method(D_METHOD("quaternions", "left", "right", "weight", "vector"), &MathProbe::quaternions);
	ClassDB::bind_method(D_METHOD("bases", "left", "right", "vector"), &MathProbe::bases);
	ClassDB::bind_method(D_METHOD("transforms", "left", "right", "vector"), &MathProbe::transforms);
}

} // namespace probe
