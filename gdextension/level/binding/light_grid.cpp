// SPDX-License-Identifier: MIT
#include "light_grid.hpp"

#include <convert.hpp>

namespace godot {

namespace {

bool to_strengths(const PackedVector3Array &p_strengths, level::Light &r_strengths) {
	ERR_FAIL_COND_V_MSG(p_strengths.size() != level::LIGHT_SETS, false, "There are five sources of light.");
	for (int64_t set = 0; set < p_strengths.size(); set++) {
		r_strengths[set] = to_core(p_strengths[set]);
	}
	return true;
}

} // namespace

bool LightGrid::set_points(const PackedByteArray &p_bytes, const Vector3i &p_counts) {
	return _core.set_points(p_bytes.ptr(), std::size_t(p_bytes.size()), { p_counts.x, p_counts.y, p_counts.z });
}

PackedByteArray LightGrid::combine(const PackedVector3Array &p_strengths) const {
	PackedByteArray texels;
	level::Light strengths{};
	if (to_strengths(p_strengths, strengths)) {
		texels.resize(int64_t(_core.size()) * 4);
		_core.combine(strengths, texels.ptrw());
	}
	return texels;
}

Vector3 LightGrid::mean_at(const Vector3 &p_place, const PackedVector3Array &p_strengths) const {
	level::Light strengths{};
	return to_strengths(p_strengths, strengths) ? from_core(_core.mean_at(to_core(p_place), strengths)) : Vector3();
}

void LightGrid::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_points", "bytes", "counts"), &LightGrid::set_points);
	ClassDB::bind_method(D_METHOD("combine", "strengths"), &LightGrid::combine);
	ClassDB::bind_method(D_METHOD("mean_at", "place", "strengths"), &LightGrid::mean_at);
}

} // namespace godot
