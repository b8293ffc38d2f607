// SPDX-License-Identifier: MIT
#include "block_mesh.hpp"

#include <convert.hpp>
#include <light_coding.hpp>
#include <light_tracer.hpp>

#include <godot_cpp/classes/mesh.hpp>
#include <godot_cpp/variant/packed_color_array.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace godot {

namespace {

/// Bytes of the light of a vertex: RGB of each set.
constexpr int64_t LIGHT_SIZE = 3 * level::LIGHT_SETS;

/// Light where none is baked: sky from above, some of it from below, and sand that throws back the sun.
std::array<uint8_t, LIGHT_SIZE> unbaked_light(const level::Vec3 &p_normal) {
	const float upward = p_normal.y * 0.5f + 0.5f;
	const uint8_t sky = level::encode_light(0.35f + 0.55f * upward);
	const uint8_t bounce = level::encode_light(0.05f + 0.15f * (1.0f - upward));
	std::array<uint8_t, LIGHT_SIZE> light{};
	std::fill(light.begin(), light.begin() + 3, sky);
	std::fill(light.begin() + 3, light.begin() + 12, bounce);
	return light;
}

level::Style style_of(int64_t p_layer, int64_t p_tint) {
	return { int(p_layer), int(p_tint) };
}

} // namespace

void BlockMesh::set_layer_edges(const PackedFloat32Array &p_edges) {
	_core.set_layer_edges(std::vector<float>(p_edges.ptr(), p_edges.ptr() + p_edges.size()));
}

void BlockMesh::set_place(const Transform3D &p_place) {
	ERR_FAIL_COND_MSG(!p_place.is_finite(), "A place of a block has numbers that are not finite.");
	_place = p_place;
	_core.set_place({ { to_core(p_place.basis.get_column(0)), to_core(p_place.basis.get_column(1)),
							  to_core(p_place.basis.get_column(2)) },
			to_core(p_place.origin) });
}

Transform3D BlockMesh::get_place() const {
	return _place;
}

void BlockMesh::set_uv_shift(const Vector2 &p_shift) {
	_core.set_uv_shift(p_shift.x, p_shift.y);
}

void BlockMesh::set_dust(double p_amount, double p_ground_y) {
	_core.set_dust(float(std::clamp(p_amount, 0.0, 1.0)), float(p_ground_y));
}

void BlockMesh::set_finest(double p_finest) {
	ERR_FAIL_COND_MSG(!(p_finest >= 0.1), "Faces are divided into parts of 0.1 m or more.");
	_core.set_finest(float(p_finest));
}

void BlockMesh::set_solids_only(bool p_solids_only) {
	_solids_only = p_solids_only;
}

void BlockMesh::face(const Vector3 &p_corner, const Vector3 &p_right, const Vector3 &p_up, const Vector2 &p_size,
		int64_t p_layer, int64_t p_tint, const PackedVector4Array &p_holes) {
	if (_solids_only) {
		return;
	}
	std::vector<level::Opening> holes;
	for (const Vector4 &hole : p_holes) {
		holes.push_back({ hole.x, hole.y, hole.z, hole.w });
	}
	_core.face(
			to_core(p_corner), to_core(p_right), to_core(p_up), p_size.x, p_size.y, style_of(p_layer, p_tint), holes);
}

void BlockMesh::quad(const Vector3 &p_a, const Vector3 &p_b, const Vector3 &p_c, const Vector3 &p_d, int64_t p_layer,
		int64_t p_tint) {
	if (!_solids_only) {
		_core.quad({ to_core(p_a), to_core(p_b), to_core(p_c), to_core(p_d) }, style_of(p_layer, p_tint));
	}
}

void BlockMesh::triangle(const Vector3 &p_a, const Vector3 &p_b, const Vector3 &p_c, int64_t p_layer, int64_t p_tint) {
	if (!_solids_only) {
		_core.triangle(to_core(p_a), to_core(p_b), to_core(p_c), style_of(p_layer, p_tint));
	}
}

void BlockMesh::box(
		const Vector3 &p_from, const Vector3 &p_to, int64_t p_layer, int64_t p_tint, int64_t p_without, bool p_solid) {
	if (!_solids_only) {
		_core.box(to_core(p_from), to_core(p_to), style_of(p_layer, p_tint), uint32_t(p_without));
	}
	if (p_solid) {
		solid(p_from, p_to);
	}
}

void BlockMesh::rod(const Vector3 &p_from, const Vector3 &p_to, double p_radius, double p_end_radius, int64_t p_layer,
		int64_t p_tint, int64_t p_sides, bool p_has_ends) {
	if (!_solids_only) {
		_core.rod(to_core(p_from), to_core(p_to), float(p_radius), float(p_end_radius), style_of(p_layer, p_tint),
				int(p_sides), p_has_ends);
	}
}

void BlockMesh::surface(const PackedVector3Array &p_points, const PackedVector3Array &p_normals,
		const PackedVector2Array &p_uvs, const PackedInt32Array &p_indices, int64_t p_layer, int64_t p_tint) {
	if (_solids_only) {
		return;
	}
	std::vector<level::Vec3> points;
	std::vector<level::Vec3> normals;
	std::vector<std::array<float, 2>> uvs;
	for (const Vector3 &point : p_points) {
		points.push_back(to_core(point));
	}
	for (const Vector3 &normal : p_normals) {
		normals.push_back(to_core(normal));
	}
	for (const Vector2 &uv : p_uvs) {
		uvs.push_back({ uv.x, uv.y });
	}
	_core.surface(points, normals, uvs, std::vector<int32_t>(p_indices.ptr(), p_indices.ptr() + p_indices.size()),
			style_of(p_layer, p_tint));
}

void BlockMesh::solid(const Vector3 &p_from, const Vector3 &p_to) {
	_core.solid(to_core(p_from), to_core(p_to));
}

int64_t BlockMesh::get_vertex_count() const {
	return int64_t(_core.points().size());
}

int64_t BlockMesh::get_triangle_count() const {
	return int64_t(_core.indices().size() / 3);
}

PackedVector3Array BlockMesh::get_points() const {
	PackedVector3Array points;
	points.resize(get_vertex_count());
	Vector3 *to = points.ptrw();
	for (const level::Vec3 &point : _core.points()) {
		*to++ = from_core(point);
	}
	return points;
}

int64_t BlockMesh::get_solid_count() const {
	return int64_t(_core.solids().size());
}

Transform3D BlockMesh::get_solid_place(int64_t p_index) const {
	ERR_FAIL_INDEX_V(p_index, get_solid_count(), Transform3D());
	const level::Place &place = _core.solids()[p_index].place;
	return Transform3D(Basis(from_core(place.basis[0]), from_core(place.basis[1]), from_core(place.basis[2])),
			from_core(place.origin));
}

Vector3 BlockMesh::get_solid_size(int64_t p_index) const {
	ERR_FAIL_INDEX_V(p_index, get_solid_count(), Vector3());
	return from_core(_core.solids()[p_index].size);
}

Array BlockMesh::make_arrays(const PackedByteArray &p_light) const {
	const int64_t count = get_vertex_count();
	const bool is_baked = p_light.size() == count * LIGHT_SIZE;
	ERR_FAIL_COND_V_MSG(!is_baked && !p_light.is_empty(), Array(), "The light is that of another mesh.");
	PackedVector3Array normals;
	PackedFloat32Array tangents;
	PackedVector2Array uvs;
	PackedVector2Array styles;
	PackedColorArray colours;
	normals.resize(count);
	tangents.resize(count * 4);
	uvs.resize(count);
	styles.resize(count);
	colours.resize(count);
	std::array<PackedByteArray, 4> customs;
	for (PackedByteArray &custom : customs) {
		custom.resize(count * 4);
	}
	for (int64_t index = 0; index < count; index++) {
		const level::Vec3 &normal = _core.normals()[index];
		const level::Vec3 &tangent = _core.tangents()[index];
		normals.ptrw()[index] = from_core(normal);
		float *to = tangents.ptrw() + index * 4;
		to[0] = tangent.x;
		to[1] = tangent.y;
		to[2] = tangent.z;
		to[3] = 1.0f;
		uvs.ptrw()[index] = Vector2(_core.uvs()[index][0], _core.uvs()[index][1]);
		styles.ptrw()[index] = Vector2(_core.styles()[index][0], _core.styles()[index][1]);
		const std::array<uint8_t, LIGHT_SIZE> unbaked = unbaked_light(normal);
		const uint8_t *light = is_baked ? p_light.ptr() + index * LIGHT_SIZE : unbaked.data();
		colours.ptrw()[index] = Color(
				float(light[0]) / 255.0f, float(light[1]) / 255.0f, float(light[2]) / 255.0f, _core.dust()[index]);
		for (int set = 0; set < 4; set++) {
			uint8_t *custom = customs[set].ptrw() + index * 4;
			std::copy(light + 3 * (set + 1), light + 3 * (set + 2), custom);
			// Four bytes travel as one float, which must be neither infinite nor NaN nor tiny.
			custom[3] = 63;
		}
	}
	PackedInt32Array indices;
	indices.resize(int64_t(_core.indices().size()));
	std::copy(_core.indices().begin(), _core.indices().end(), indices.ptrw());
	Array arrays;
	arrays.resize(Mesh::ARRAY_MAX);
	arrays[Mesh::ARRAY_VERTEX] = get_points();
	arrays[Mesh::ARRAY_NORMAL] = normals;
	arrays[Mesh::ARRAY_TANGENT] = tangents;
	arrays[Mesh::ARRAY_COLOR] = colours;
	arrays[Mesh::ARRAY_TEX_UV] = uvs;
	arrays[Mesh::ARRAY_TEX_UV2] = styles;
	for (int set = 0; set < 4; set++) {
		arrays[Mesh::ARRAY_CUSTOM0 + set] = customs[set];
	}
	arrays[Mesh::ARRAY_INDEX] = indices;
	return arrays;
}

void BlockMesh::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_layer_edges", "edges"), &BlockMesh::set_layer_edges);
	ClassDB::bind_method(D_METHOD("set_place", "place"), &BlockMesh::set_place);
	ClassDB::bind_method(D_METHOD("get_place"), &BlockMesh::get_place);
	ClassDB::bind_method(D_METHOD("set_uv_shift", "shift"), &BlockMesh::set_uv_shift);
	ClassDB::bind_method(D_METHOD("set_dust", "amount", "ground_y"), &BlockMesh::set_dust);
	ClassDB::bind_method(D_METHOD("set_finest", "finest"), &BlockMesh::set_finest);
	ClassDB::bind_method(D_METHOD("set_solids_only", "solids_only"), &BlockMesh::set_solids_only);
	ClassDB::bind_method(D_METHOD("face", "corner", "right", "up", "size", "layer", "tint", "holes"), &BlockMesh::face,
			DEFVAL(PackedVector4Array()));
	ClassDB::bind_method(D_METHOD("quad", "a", "b", "c", "d", "layer", "tint"), &BlockMesh::quad);
	ClassDB::bind_method(D_METHOD("triangle", "a", "b", "c", "layer", "tint"), &BlockMesh::triangle);
	ClassDB::bind_method(D_METHOD("box", "from", "to", "layer", "tint", "without", "solid"), &BlockMesh::box, DEFVAL(0),
			DEFVAL(false));
	ClassDB::bind_method(D_METHOD("rod", "from", "to", "radius", "end_radius", "layer", "tint", "sides", "has_ends"),
			&BlockMesh::rod, DEFVAL(8), DEFVAL(true));
	ClassDB::bind_method(
			D_METHOD("surface", "points", "normals", "uvs", "indices", "layer", "tint"), &BlockMesh::surface);
	ClassDB::bind_method(D_METHOD("solid", "from", "to"), &BlockMesh::solid);
	ClassDB::bind_method(D_METHOD("get_vertex_count"), &BlockMesh::get_vertex_count);
	ClassDB::bind_method(D_METHOD("get_triangle_count"), &BlockMesh::get_triangle_count);
	ClassDB::bind_method(D_METHOD("get_points"), &BlockMesh::get_points);
	ClassDB::bind_method(D_METHOD("get_solid_count"), &BlockMesh::get_solid_count);
	ClassDB::bind_method(D_METHOD("get_solid_place", "index"), &BlockMesh::get_solid_place);
	ClassDB::bind_method(D_METHOD("get_solid_size", "index"), &BlockMesh::get_solid_size);
	ClassDB::bind_method(D_METHOD("make_arrays", "light"), &BlockMesh::make_arrays, DEFVAL(PackedByteArray()));
	BIND_ENUM_CONSTANT(FACE_LEFT);
	BIND_ENUM_CONSTANT(FACE_RIGHT);
	BIND_ENUM_CONSTANT(FACE_BOTTOM);
	BIND_ENUM_CONSTANT(FACE_TOP);
	BIND_ENUM_CONSTANT(FACE_BACK);
	BIND_ENUM_CONSTANT(FACE_FRONT);
}

} // namespace godot
