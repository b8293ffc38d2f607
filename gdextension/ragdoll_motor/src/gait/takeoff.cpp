// SPDX-License-Identifier: MIT
#include "gait/takeoff.hpp"

namespace ragdoll {

bool Takeoff::advance(float p_height, float p_rise, float p_slide, float p_gravity, float p_delta_s) {
	if (!_is_watching) {
		_path = _last;
		_speed = p_rise;
		_first = p_rise;
	}
	_path += (_speed - 0.5f * p_gravity * p_delta_s) * p_delta_s;
	_speed -= p_gravity * p_delta_s;
	_gap = _path - p_height;
	_last = p_height;
	_is_watching = _gap > 0.0f && (_is_watching || p_rise > settings.speed);
	const bool leaves = _first > settings.jump || p_slide > settings.slide;
	return _is_watching && leaves && _gap > settings.clearance;
}

void Takeoff::save(ArchiveWriter &p_archive) const {
	p_archive.put(_is_watching);
	p_archive.put(_path);
	p_archive.put(_speed);
	p_archive.put(_gap);
	p_archive.put(_first);
	p_archive.put(_last);
}

bool Takeoff::restore(ArchiveReader &p_archive) {
	return p_archive.get(_is_watching) && p_archive.get(_path) && p_archive.get(_speed) && p_archive.get(_gap) &&
			p_archive.get(_first) && p_archive.get(_last);
}

} // namespace ragdoll
