// SPDX-License-Identifier: MIT
#include "gait/path_filter.hpp"

namespace ragdoll {

void PathFilter::advance(const Vec3 &p_position, float p_noise, float p_span_s) {
	if (!_begun) {
		_begun = true;
		_position = p_position;
		_rate = {};
		_calm = {};
		return;
	}
	const Vec3 expected = ahead(p_span_s);
	const Vec3 off = p_position - expected;
	_calm.advance(off.dot(off) / 3.0f, LEVER * p_noise, p_span_s, MEMORY_S, CALMEST);
	_position = expected + off * _calm.get_gain();
	_rate = _rate + off * (_calm.get_rate_gain() / p_span_s);
}

void PathFilter::save(ArchiveWriter &p_archive) const {
	p_archive.put(_position);
	p_archive.put(_rate);
	p_archive.put(_calm);
	p_archive.put(_begun);
}

bool PathFilter::restore(ArchiveReader &p_archive) {
	return p_archive.get(_position) && p_archive.get(_rate) && p_archive.get(_calm) && p_archive.get(_begun);
}

} // namespace ragdoll
