// SPDX-License-Identifier: MIT
#pragma once

#include <block_mesh.hpp>

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/array.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/packed_vector2_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/packed_vector4_array.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/vector2.hpp>
#include <godot_cpp/variant/vector3.hpp>

namespace godot {

/// Collects the faces of what a level is built of. Documented in doc_classes/BlockMesh.xml.
class BlockMesh : public RefCounted {
	GDCLASS(BlockMesh, RefCounted)

public:
	enum FaceOfBox {
		FACE_LEFT = level::FACE_LEFT,
		FACE_RIGHT = level::FACE_RIGHT,
		FACE_BOTTOM = level::FACE_BOTTOM,
		FACE_TOP = level::FACE_TOP,
		FACE_BACK = level::FACE_BACK,
		FACE_FRONT = level::FACE_FRONT,
	};

	void set_layer_edges(const PackedFloat32Array &p_edges);
	void set_place(const Transform3D &p_place);
	Transform3D get_place() const;
	void set_uv_shift(const Vector2 &p_shift);
	void set_dust(double p_amount, double p_ground_y);
	void set_finest(double p_finest);
	void set_solids_only(bool p_solids_only);

	void face(const Vector3 &p_corner, const Vector3 &p_right, const Vector3 &p_up, const Vector2 &p_size,
			int64_t p_layer, int64_t p_tint, const PackedVector4Array &p_holes);
	void quad(const Vector3 &p_a, const Vector3 &p_b, const Vector3 &p_c, const Vector3 &p_d, int64_t p_layer,
			int64_t p_tint);
	void triangle(const Vector3 &p_a, const Vector3 &p_b, const Vector3 &p_c, int64_t p_layer, int64_t p_tint);
	void box(const Vector3 &p_from, const Vector3 &p_to, int64_t p_layer, int64_t p_tint, int64_t p_without,
			bool p_solid);
	void rod(const Vector3 &p_from, const Vector3 &p_to, double p_radius, double p_end_radius, int64_t p_layer,
			int64_t p_tint, int64_t p_sides, bool p_has_ends);
	void surface(const PackedVector3Array &p_points, const PackedVector3Array &p_normals,
			const PackedVector2Array &p_uvs, const PackedInt32Array &p_indices, int64_t p_layer, int64_t p_tint);
	void solid(const Vector3 &p_from, const Vector3 &p_to);

	int64_t get_vertex_count() const;
	int64_t get_triangle_count() const;
	PackedVector3Array get_points() const;
	int64_t get_solid_count() const;
	Transform3D get_solid_place(int64_t p_index) const;
	Vector3 get_solid_size(int64_t p_index) const;
	Array make_arrays(const PackedByteArray &p_light) const;

	const level::BlockMesh &core() const { return _core; }

protected:
	static void _bind_methods();

private:
	level::BlockMesh _core;
	Transform3D _place;
	bool _solids_only = false;
};

} // namespace godot

VARIANT_ENUM_CAST(BlockMesh::FaceOfBox);
