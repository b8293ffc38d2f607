// SPDX-License-Identifier: MIT
#include "path_filter.hpp"

namespace ragdoll {

void PathFilter::advance(const Vec3 &p_place, float p_noise, float p_span_s) {
	if (!begun) {
		begun = true;
		place = p_place;
		rate = {};
		calm = {};
		return;
	}
	const Vec3 expected = ahead(p_span_s);
	const Vec3 off = p_place - expected;
	calm.advance(off.dot(off) / 3.0f, LEVER * p_noise, p_span_s, MEMORY_S, CALMEST);
	place = expected + off * calm.get_gain();
	rate = rate + off * (calm.get_rate_gain() / p_span_s);
}

void PathFilter::save(ArchiveWriter &p_archive) const {
	p_archive.put(place);
	p_archive.put(rate);
	p_archive.put(calm);
	p_archive.put(begun);
}

bool PathFilter::restore(ArchiveReader &p_archive) {
	return p_archive.get(place) && p_archive.get(rate) && p_archive.get(calm) && p_archive.get(begun);
}

} // namespace ragdoll
