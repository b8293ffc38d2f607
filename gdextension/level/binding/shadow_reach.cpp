// SPDX-License-Identifier: MIT
#include "shadow_reach.hpp"

#include <convert.hpp>

#include <algorithm>

namespace godot {

namespace {

constexpr int64_t MAX_CASTERS = 65536;

} // namespace

void ShadowReach::add_part(const Ref<BlockMesh> &p_mesh, int64_t p_caster) {
	ERR_FAIL_COND_MSG(p_mesh.is_null(), "A part without a mesh.");
	ERR_FAIL_COND_MSG(p_caster >= MAX_CASTERS, "The number of what throws the shadow is too high.");
	_core.add_part(p_mesh->core().points(), p_mesh->core().indices(), int(std::max<int64_t>(p_caster, -1)));
}

void ShadowReach::set_light(const Vector3 &p_way) {
	ERR_FAIL_COND_MSG(!p_way.is_finite(), "The way to the light is not finite.");
	_core.set_light(to_core(p_way));
}

PackedByteArray ShadowReach::look(const PackedByteArray &p_seen, const PackedVector4Array &p_bounds) const {
	std::vector<level::ShadowReach::Bound> bounds;
	for (const Vector4 &bound : p_bounds) {
		bounds.push_back({ { float(bound.x), float(bound.y), float(bound.z) }, float(bound.w) });
	}
	const std::vector<uint8_t> needed =
			_core.look(std::vector<uint8_t>(p_seen.ptr(), p_seen.ptr() + p_seen.size()), bounds);
	PackedByteArray bytes;
	bytes.resize(int64_t(needed.size()));
	std::copy(needed.begin(), needed.end(), bytes.ptrw());
	return bytes;
}

void ShadowReach::_bind_methods() {
	ClassDB::bind_method(D_METHOD("add_part", "mesh", "caster"), &ShadowReach::add_part);
	ClassDB::bind_method(D_METHOD("set_light", "way"), &ShadowReach::set_light);
	ClassDB::bind_method(D_METHOD("look", "seen", "bounds"), &ShadowReach::look);
}

} // namespace godot
