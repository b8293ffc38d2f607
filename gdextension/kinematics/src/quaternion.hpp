// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

/// Rotations and positions that all modules share: right-handed frames, metres, radians, seconds.
namespace kinematics {

/// A vector of three floats.
struct Vec3 {
	float x = 0.0f;
	float y = 0.0f;
	float z = 0.0f;

	Vec3 operator+(const Vec3 &p_other) const { return { x + p_other.x, y + p_other.y, z + p_other.z }; }
	Vec3 operator-(const Vec3 &p_other) const { return { x - p_other.x, y - p_other.y, z - p_other.z }; }
	Vec3 operator*(float p_factor) const { return { x * p_factor, y * p_factor, z * p_factor }; }
	float dot(const Vec3 &p_other) const { return x * p_other.x + y * p_other.y + z * p_other.z; }
	Vec3 cross(const Vec3 &p_other) const {
		return { y * p_other.z - z * p_other.y, z * p_other.x - x * p_other.z, x * p_other.y - y * p_other.x };
	}
	/// Component by component.
	Vec3 scaled(const Vec3 &p_other) const { return { x * p_other.x, y * p_other.y, z * p_other.z }; }
	float length() const { return std::sqrt(dot(*this)); }
	/// The same direction, not longer than p_most.
	Vec3 limited(float p_most) const {
		const float now = length();
		return now > p_most ? *this * (p_most / now) : *this;
	}
	bool is_finite() const { return std::isfinite(x) && std::isfinite(y) && std::isfinite(z); }
};

/// A rotation as a unit quaternion, x y z w. `a * b` applies b first, then a.
struct Quat {
	float x = 0.0f;
	float y = 0.0f;
	float z = 0.0f;
	float w = 1.0f;

	Quat operator*(const Quat &p_other) const {
		return {
			w * p_other.x + x * p_other.w + y * p_other.z - z * p_other.y,
			w * p_other.y + y * p_other.w + z * p_other.x - x * p_other.z,
			w * p_other.z + z * p_other.w + x * p_other.y - y * p_other.x,
			w * p_other.w - x * p_other.x - y * p_other.y - z * p_other.z,
		};
	}
	/// The inverse of a unit quaternion.
	Quat inverse() const { return { -x, -y, -z, w }; }
	Quat operator-() const { return { -x, -y, -z, -w }; }
	float dot(const Quat &p_other) const { return x * p_other.x + y * p_other.y + z * p_other.z + w * p_other.w; }
	bool is_finite() const { return std::isfinite(x) && std::isfinite(y) && std::isfinite(z) && std::isfinite(w); }
	Quat normalized() const {
		const float scale = 1.0f / std::sqrt(dot(*this));
		return { x * scale, y * scale, z * scale, w * scale };
	}
	/// The vector, rotated (thesis section 6.3, eq. 3: v' = q v q*).
	Vec3 rotate(const Vec3 &p_vector) const {
		const Vec3 axis{ x, y, z };
		const Vec3 twice = axis.cross(p_vector) * 2.0f;
		return p_vector + twice * w + axis.cross(twice);
	}
};

/// The rotation vector (axis times angle, rad) of a unit quaternion, by the short way round.
inline Vec3 log(const Quat &p_rotation) {
	const float sign = p_rotation.w < 0.0f ? -1.0f : 1.0f;
	const Vec3 vector{ p_rotation.x * sign, p_rotation.y * sign, p_rotation.z * sign };
	const float sine = vector.length();
	if (sine < 1e-7f) {
		return vector * 2.0f;
	}
	return vector * (2.0f * std::atan2(sine, p_rotation.w * sign) / sine);
}

/// The unit quaternion of a rotation vector (axis times angle, rad): the inverse of log().
inline Quat exp(const Vec3 &p_vector) {
	const float half = 0.5f * p_vector.length();
	// sin(h) / h without a division by zero.
	const float ratio = half < 1e-4f ? 1.0f - half * half / 6.0f : std::sin(half) / half;
	const Vec3 vector = p_vector * (0.5f * ratio);
	return { vector.x, vector.y, vector.z, std::cos(half) };
}

/// The angle between two orientations (rad, 0 to pi), whichever of q and -q either is.
inline float angle_between(const Quat &p_from, const Quat &p_to) {
	return log(p_from.inverse() * p_to).length();
}

/// The orientation a fraction of the short way from one to another. Fractions above 1 extrapolate.
inline Quat slerp(const Quat &p_from, const Quat &p_to, float p_fraction) {
	return p_from * exp(log(p_from.inverse() * p_to) * p_fraction);
}

/// The rotation that takes the world's axes to these, which are of length 1 and at right angles
/// (Shepperd 1978).
inline Quat from_axes(const Vec3 &p_x, const Vec3 &p_y, const Vec3 &p_z) {
	const float squares[4] = { 1.0f + p_x.x - p_y.y - p_z.z, 1.0f - p_x.x + p_y.y - p_z.z, 1.0f - p_x.x - p_y.y + p_z.z,
		1.0f + p_x.x + p_y.y + p_z.z }; // Four times each square.
	int largest = 0;
	for (int i = 1; i < 4; i++) {
		largest = squares[i] > squares[largest] ? i : largest;
	}
	const float twice = std::sqrt(squares[largest]);
	const float part = 0.5f / twice;
	switch (largest) {
		case 0:
			return { 0.5f * twice, (p_x.y + p_y.x) * part, (p_x.z + p_z.x) * part, (p_y.z - p_z.y) * part };
		case 1:
			return { (p_x.y + p_y.x) * part, 0.5f * twice, (p_y.z + p_z.y) * part, (p_z.x - p_x.z) * part };
		case 2:
			return { (p_x.z + p_z.x) * part, (p_y.z + p_z.y) * part, 0.5f * twice, (p_x.y - p_y.x) * part };
		default:
			return { (p_y.z - p_z.y) * part, (p_z.x - p_x.z) * part, (p_x.y - p_y.x) * part, 0.5f * twice };
	}
}

} // namespace kinematics
