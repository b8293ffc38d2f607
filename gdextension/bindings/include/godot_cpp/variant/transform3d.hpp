// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/variant/basis.hpp>

namespace godot {

/// A position and an orientation in space.
struct Transform3D {
	Basis basis;
	Vector3 origin;

	constexpr Transform3D() = default;
	constexpr Transform3D(const Basis &p_basis, const Vector3 &p_origin = Vector3()) :
			basis(p_basis), origin(p_origin) {}

	constexpr Vector3 xform(const Vector3 &p_point) const { return basis.xform(p_point) + origin; }
	/// The opposite, for transforms that only rotate and move.
	constexpr Vector3 xform_inv(const Vector3 &p_point) const { return basis.xform_inv(p_point - origin); }

	Transform3D operator*(const Transform3D &p_right) const {
		return Transform3D(basis * p_right.basis, xform(p_right.origin));
	}
	Transform3D &operator*=(const Transform3D &p_right) { return *this = *this * p_right; }
	constexpr bool operator==(const Transform3D &p_other) const {
		return basis == p_other.basis && origin == p_other.origin;
	}
	constexpr bool operator!=(const Transform3D &p_other) const { return !(*this == p_other); }
	bool is_equal_approx(const Transform3D &p_other) const {
		return basis.is_equal_approx(p_other.basis) && origin.is_equal_approx(p_other.origin);
	}
	bool is_finite() const { return basis.is_finite() && origin.is_finite(); }

	/// The inverse of a transform that only rotates and moves.
	Transform3D inverse() const {
		const Basis back = basis.transposed();
		return Transform3D(back, back.xform(-origin));
	}
	/// The inverse of any transform.
	Transform3D affine_inverse() const {
		const Basis back = basis.inverse();
		return Transform3D(back, back.xform(-origin));
	}
	Transform3D orthonormalized() const { return Transform3D(basis.orthonormalized(), origin); }
	constexpr Transform3D translated(const Vector3 &p_offset) const { return Transform3D(basis, origin + p_offset); }
	constexpr Transform3D translated_local(const Vector3 &p_offset) const {
		return Transform3D(basis, origin + basis.xform(p_offset));
	}
};

} // namespace godot
