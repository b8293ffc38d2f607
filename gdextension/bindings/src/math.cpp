// SPDX-License-Identifier: MIT
// The longer functions of the number types: the same formulas as the engine's, in the same order,
// so that C++ and GDScript agree to the last bits.

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/basis.hpp>

#include <algorithm>

namespace godot {

Quaternion::Quaternion(const Vector3 &p_axis, real_t p_angle) {
	const real_t length = p_axis.length();
	if (length == 0) {
		*this = Quaternion(0, 0, 0, 0);
		return;
	}
	const real_t scale = std::sin(p_angle * real_t(0.5)) / length;
	*this = Quaternion(p_axis.x * scale, p_axis.y * scale, p_axis.z * scale, std::cos(p_angle * real_t(0.5)));
}

Quaternion::Quaternion(const Basis &p_basis) : Quaternion(p_basis.get_quaternion()) {}

real_t Quaternion::angle_to(const Quaternion &p_to) const {
	const real_t product = dot(p_to);
	// Rounding takes the cosine of equal rotations a little beyond one.
	return std::acos(std::clamp(product * product * 2 - 1, real_t(-1), real_t(1)));
}

real_t Quaternion::get_angle() const {
	return 2 * std::acos(std::clamp(w, real_t(-1), real_t(1)));
}

Vector3 Quaternion::get_axis() const {
	if (std::abs(w) > 1 - CMP_EPSILON) {
		return Vector3(x, y, z);
	}
	const real_t scale = 1 / std::sqrt(1 - w * w);
	return Vector3(x * scale, y * scale, z * scale);
}

Quaternion Quaternion::log() const {
	const Vector3 turn = get_axis() * get_angle();
	return Quaternion(turn.x, turn.y, turn.z, 0);
}

Quaternion Quaternion::exp() const {
	const Vector3 turn(x, y, z);
	const real_t angle = turn.length();
	const Vector3 axis = turn.normalized();
	if (angle < CMP_EPSILON || !axis.is_normalized()) {
		return Quaternion();
	}
	return Quaternion(axis, angle);
}

Quaternion Quaternion::slerp(const Quaternion &p_to, real_t p_weight) const {
	real_t cosine = dot(p_to);
	Quaternion to = p_to;
	if (cosine < 0) {
		cosine = -cosine;
		to = -p_to;
	}
	real_t keep = 1 - p_weight;
	real_t take = p_weight;
	// Rotations close to each other need no sines (and have none to divide by).
	if (1 - cosine > CMP_EPSILON) {
		const real_t angle = std::acos(cosine);
		const real_t sine = std::sin(angle);
		keep = std::sin((1 - p_weight) * angle) / sine;
		take = std::sin(p_weight * angle) / sine;
	}
	return Quaternion(keep * x + take * to.x, keep * y + take * to.y, keep * z + take * to.z, keep * w + take * to.w);
}

Basis::Basis(const Quaternion &p_rotation) {
	const real_t scale = 2 / p_rotation.length_squared();
	const real_t xs = p_rotation.x * scale;
	const real_t ys = p_rotation.y * scale;
	const real_t zs = p_rotation.z * scale;
	const real_t wx = p_rotation.w * xs;
	const real_t wy = p_rotation.w * ys;
	const real_t wz = p_rotation.w * zs;
	const real_t xx = p_rotation.x * xs;
	const real_t xy = p_rotation.x * ys;
	const real_t xz = p_rotation.x * zs;
	const real_t yy = p_rotation.y * ys;
	const real_t yz = p_rotation.y * zs;
	const real_t zz = p_rotation.z * zs;
	rows[0] = Vector3(1 - (yy + zz), xy - wz, xz + wy);
	rows[1] = Vector3(xy + wz, 1 - (xx + zz), yz - wx);
	rows[2] = Vector3(xz - wy, yz + wx, 1 - (xx + yy));
}

Basis Basis::inverse() const {
	const Vector3 cofactors = rows[1].cross(rows[2]);
	const real_t product = rows[0].dot(cofactors);
	ERR_FAIL_COND_V_MSG(product == 0, *this, "A basis with determinant zero has no inverse.");
	const real_t scale = 1 / product;
	return Basis(cofactors * scale, rows[2].cross(rows[0]) * scale, rows[0].cross(rows[1]) * scale);
}

Basis Basis::orthonormalized() const {
	Vector3 x_axis = get_column(0).normalized();
	Vector3 y_axis = get_column(1);
	Vector3 z_axis = get_column(2);
	y_axis = (y_axis - x_axis * x_axis.dot(y_axis)).normalized();
	z_axis = (z_axis - x_axis * x_axis.dot(z_axis) - y_axis * y_axis.dot(z_axis)).normalized();
	return Basis(x_axis, y_axis, z_axis);
}

Vector3 Basis::get_scale() const {
	const real_t sign = determinant() < 0 ? -1 : 1;
	return Vector3(get_column(0).length(), get_column(1).length(), get_column(2).length()) * sign;
}

Quaternion Basis::get_quaternion() const {
	const real_t trace = rows[0].x + rows[1].y + rows[2].z;
	real_t parts[4];
	if (trace > 0) {
		const real_t root = std::sqrt(trace + 1);
		const real_t scale = real_t(0.5) / root;
		parts[0] = (rows[2].y - rows[1].z) * scale;
		parts[1] = (rows[0].z - rows[2].x) * scale;
		parts[2] = (rows[1].x - rows[0].y) * scale;
		parts[3] = root * real_t(0.5);
	} else {
		// The largest part first: the others are divided by it.
		const int i = rows[0].x < rows[1].y ? (rows[1].y < rows[2].z ? 2 : 1) : (rows[0].x < rows[2].z ? 2 : 0);
		const int j = (i + 1) % 3;
		const int k = (i + 2) % 3;
		const real_t root = std::sqrt(rows[i][i] - rows[j][j] - rows[k][k] + 1);
		const real_t scale = real_t(0.5) / root;
		parts[i] = root * real_t(0.5);
		parts[j] = (rows[j][i] + rows[i][j]) * scale;
		parts[k] = (rows[k][i] + rows[i][k]) * scale;
		parts[3] = (rows[k][j] - rows[j][k]) * scale;
	}
	return Quaternion(parts[0], parts[1], parts[2], parts[3]);
}

Quaternion Basis::get_rotation_quaternion() const {
	Basis rotation = orthonormalized();
	if (rotation.determinant() < 0) {
		// A mirrored basis rotates as its opposite does.
		rotation = Basis(-rotation.get_column(0), -rotation.get_column(1), -rotation.get_column(2));
	}
	return rotation.get_quaternion();
}

} // namespace godot
