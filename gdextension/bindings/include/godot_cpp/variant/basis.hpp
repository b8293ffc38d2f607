// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/variant/quaternion.hpp>

namespace godot {

/// Rotation, scale and shear: a matrix by its rows. Its columns are where the axes go.
struct Basis {
	Vector3 rows[3] = { Vector3(1, 0, 0), Vector3(0, 1, 0), Vector3(0, 0, 1) };

	constexpr Basis() = default;
	constexpr Basis(real_t p_xx, real_t p_xy, real_t p_xz, real_t p_yx, real_t p_yy, real_t p_yz, real_t p_zx,
			real_t p_zy, real_t p_zz) :
			rows{ Vector3(p_xx, p_xy, p_xz), Vector3(p_yx, p_yy, p_yz), Vector3(p_zx, p_zy, p_zz) } {}
	/// From columns.
	constexpr Basis(const Vector3 &p_x_axis, const Vector3 &p_y_axis, const Vector3 &p_z_axis) :
			Basis(p_x_axis.x, p_y_axis.x, p_z_axis.x, p_x_axis.y, p_y_axis.y, p_z_axis.y, p_x_axis.z, p_y_axis.z,
					p_z_axis.z) {}
	/// The rotation of a quaternion, whatever its length.
	Basis(const Quaternion &p_rotation);

	static constexpr Basis from_scale(const Vector3 &p_scale) {
		return Basis(p_scale.x, 0, 0, 0, p_scale.y, 0, 0, 0, p_scale.z);
	}

	/// A row.
	Vector3 &operator[](int p_row) { return rows[p_row]; }
	constexpr const Vector3 &operator[](int p_row) const { return rows[p_row]; }
	constexpr Vector3 get_column(int p_axis) const {
		return p_axis == 0	  ? Vector3(rows[0].x, rows[1].x, rows[2].x)
				: p_axis == 1 ? Vector3(rows[0].y, rows[1].y, rows[2].y)
							  : Vector3(rows[0].z, rows[1].z, rows[2].z);
	}
	void set_column(int p_axis, const Vector3 &p_value) {
		rows[0][p_axis] = p_value.x;
		rows[1][p_axis] = p_value.y;
		rows[2][p_axis] = p_value.z;
	}

	constexpr Vector3 xform(const Vector3 &p_vector) const {
		return Vector3(rows[0].dot(p_vector), rows[1].dot(p_vector), rows[2].dot(p_vector));
	}
	/// By the transposed matrix: the inverse of a rotation.
	constexpr Vector3 xform_inv(const Vector3 &p_vector) const { return transposed().xform(p_vector); }
	constexpr Basis transposed() const { return Basis(rows[0], rows[1], rows[2]); }

	Basis operator*(const Basis &p_right) const {
		const Basis columns = p_right.transposed();
		return Basis(rows[0].dot(columns[0]), rows[0].dot(columns[1]), rows[0].dot(columns[2]), rows[1].dot(columns[0]),
				rows[1].dot(columns[1]), rows[1].dot(columns[2]), rows[2].dot(columns[0]), rows[2].dot(columns[1]),
				rows[2].dot(columns[2]));
	}
	Basis &operator*=(const Basis &p_right) { return *this = *this * p_right; }
	constexpr bool operator==(const Basis &p_other) const {
		return rows[0] == p_other.rows[0] && rows[1] == p_other.rows[1] && rows[2] == p_other.rows[2];
	}
	constexpr bool operator!=(const Basis &p_other) const { return !(*this == p_other); }
	bool is_equal_approx(const Basis &p_other) const {
		return rows[0].is_equal_approx(p_other.rows[0]) && rows[1].is_equal_approx(p_other.rows[1]) &&
				rows[2].is_equal_approx(p_other.rows[2]);
	}
	bool is_finite() const { return rows[0].is_finite() && rows[1].is_finite() && rows[2].is_finite(); }

	constexpr real_t determinant() const { return rows[0].dot(rows[1].cross(rows[2])); }
	/// The inverse; the basis itself where there is none.
	Basis inverse() const;
	/// Axes of length one at right angles, the first keeping its direction.
	Basis orthonormalized() const;
	/// How long the axes are; negative for a mirroring basis.
	Vector3 get_scale() const;
	/// The rotation of a basis that only rotates.
	Quaternion get_quaternion() const;
	/// The rotation of any basis.
	Quaternion get_rotation_quaternion() const;
};

} // namespace godot
