// SPDX-License-Identifier: MIT
#include "balance/loose_ground.hpp"

#include <algorithm>

namespace ragdoll {

void LooseGround::advance(const LooseGroundSettings &p_settings, bool p_is_loose, float p_lower, float p_delta_s) {
	_since_s = p_is_loose ? 0.0f : _since_s + p_delta_s;
	const float low = p_is_loose ? std::clamp(p_settings.sag_slack - p_lower, -p_settings.sag_most, 0.0f) : 0.0f;
	_sag = std::min(low, _sag + p_settings.sag_back * p_delta_s);
}

Vec3 LooseGround::find_give(const LooseGroundSettings &p_settings, const Vec3 &p_is, const Vec3 &p_meant) const {
	const float longest = p_is.length() + p_settings.push;
	const float meant = p_meant.length();
	return _since_s < p_settings.memory_s && meant > longest ? p_meant * (longest / meant - 1.0f) : Vec3();
}

void LooseGround::save(ArchiveWriter &p_archive) const {
	p_archive.put(_sag);
	p_archive.put(_since_s);
}

bool LooseGround::restore(ArchiveReader &p_archive) {
	return p_archive.get(_sag) && p_archive.get(_since_s);
}

} // namespace ragdoll
