// SPDX-License-Identifier: MIT
#include "comparison/lowest_foot.hpp"

namespace ragdoll {

int LowestFoot::find_lowest(const std::vector<Vec3> &p_points) const {
	int lowest = -1;
	for (std::size_t i = 0; i < _contacts.size(); i++) {
		if (_contacts[i].sole && (lowest < 0 || p_points[i].y < p_points[std::size_t(lowest)].y)) {
			lowest = int(i);
		}
	}
	return lowest;
}

void LowestFoot::begin(const GaitInput &p_input) {
	const std::vector<Vec3> &points = *p_input.points;
	_held = find_lowest(points);
	if (_held < 0) {
		return; // No feet: the root stays.
	}
	const std::size_t j = std::size_t(_held);
	_anchors[j] = _root + points[j];
	const float found = p_input.ground->height(_anchors[j]);
	_level = std::isfinite(found) ? found : _anchors[j].y;
	_anchors[j].y = _level;
	_root = _anchors[j] - points[j];
	_weights[j] = 1.0f;
}

void LowestFoot::advance(const GaitInput &p_input) {
	if (_held < 0) {
		return;
	}
	const std::vector<Vec3> &points = *p_input.points;
	// p' = p - c_j: the held point stays.
	_root = _anchors[std::size_t(_held)] - points[std::size_t(_held)];
	const int lowest = find_lowest(points);
	if (lowest != _held) {
		// p = p + c_j - c_k: the new one stays from where it is now.
		_weights[std::size_t(_held)] = 0.0f;
		_held = lowest;
		const std::size_t k = std::size_t(_held);
		_anchors[k] = _root + points[k];
		_anchors[k].y = _level;
		_root = _anchors[k] - points[k];
		_weights[k] = 1.0f;
	}
}

void LowestFoot::save(ArchiveWriter &p_archive) const {
	Travel::save(p_archive);
	p_archive.put(_held);
	p_archive.put(_level);
}

bool LowestFoot::restore(ArchiveReader &p_archive) {
	const bool good = Travel::restore(p_archive) && p_archive.get(_held) && p_archive.get(_level);
	return good && _held >= -1 && _held < int(_contacts.size());
}

} // namespace ragdoll
