// SPDX-License-Identifier: MIT
#include "shadow_reach.hpp"

#include "byte_array.hpp"

#include <convert.hpp>

#include <algorithm>

namespace godot {

namespace {

std::vector<level::ShadowReach::Bound> to_bounds(const PackedVector4Array &p_bounds) {
	std::vector<level::ShadowReach::Bound> bounds;
	for (const Vector4 &bound : p_bounds) {
		bounds.push_back({ { float(bound.x), float(bound.y), float(bound.z) }, float(bound.w) });
	}
	return bounds;
}

} // namespace

void ShadowReach::add_part(const Ref<BlockMesh> &p_mesh, bool p_is_within) {
	ERR_FAIL_COND_MSG(p_mesh.is_null(), "A part without a mesh.");
	const level::BlockMesh &mesh = p_mesh->core();
	_core.add_part(mesh.points(), mesh.indices(), mesh.shadow(), p_is_within);
}

void ShadowReach::gather() {
	_core.gather();
}

int64_t ShadowReach::get_caster_count() const {
	return _core.caster_count();
}

PackedVector3Array ShadowReach::get_caster(int64_t p_number) const {
	PackedVector3Array corners;
	ERR_FAIL_INDEX_V_MSG(p_number, _core.caster_count(), corners, "There is no such mesh of shadows.");
	const std::vector<level::Vec3> &core = _core.caster(int(p_number));
	corners.resize(int64_t(core.size()));
	Vector3 *to = corners.ptrw();
	for (const level::Vec3 &corner : core) {
		*to++ = from_core(corner);
	}
	return corners;
}

void ShadowReach::set_light(const Vector3 &p_way) {
	ERR_FAIL_COND_MSG(!p_way.is_finite(), "The way to the light is not finite.");
	_core.set_light(to_core(p_way));
}

PackedByteArray ShadowReach::look(const PackedByteArray &p_seen, const PackedVector4Array &p_bounds) const {
	return to_bytes(_core.look(std::vector<uint8_t>(p_seen.ptr(), p_seen.ptr() + p_seen.size()), to_bounds(p_bounds)));
}

PackedByteArray ShadowReach::find_inside(
		const PackedVector3Array &p_corners, const PackedVector4Array &p_bounds) const {
	ERR_FAIL_COND_V_MSG(p_corners.size() % 2 != 0, PackedByteArray(), "A box has two corners.");
	std::vector<std::array<level::Vec3, 2>> boxes;
	for (int64_t index = 0; index < p_corners.size(); index += 2) {
		boxes.push_back({ to_core(p_corners[index]), to_core(p_corners[index + 1]) });
	}
	return to_bytes(level::ShadowReach::inside(boxes, to_bounds(p_bounds)));
}

void ShadowReach::_bind_methods() {
	ClassDB::bind_method(D_METHOD("add_part", "mesh", "is_within"), &ShadowReach::add_part, DEFVAL(false));
	ClassDB::bind_method(D_METHOD("gather"), &ShadowReach::gather);
	ClassDB::bind_method(D_METHOD("get_caster_count"), &ShadowReach::get_caster_count);
	ClassDB::bind_method(D_METHOD("get_caster", "number"), &ShadowReach::get_caster);
	ClassDB::bind_method(D_METHOD("set_light", "way"), &ShadowReach::set_light);
	ClassDB::bind_method(D_METHOD("look", "seen", "bounds"), &ShadowReach::look);
	ClassDB::bind_method(D_METHOD("find_inside", "corners", "bounds"), &ShadowReach::find_inside);
}

} // namespace godot
