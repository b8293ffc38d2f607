// SPDX-License-Identifier: MIT
#include "lowest_foot.hpp"

namespace ragdoll {

int LowestFoot::find_lowest(const std::vector<Vec3> &p_points) const {
	int lowest = -1;
	for (std::size_t i = 0; i < contacts.size(); i++) {
		if (contacts[i].sole && (lowest < 0 || p_points[i].y < p_points[std::size_t(lowest)].y)) {
			lowest = int(i);
		}
	}
	return lowest;
}

void LowestFoot::begin(const GaitInput &p_input) {
	const std::vector<Vec3> &points = *p_input.points;
	held = find_lowest(points);
	if (held < 0) {
		return; // No feet: the root stays.
	}
	const std::size_t j = std::size_t(held);
	anchors[j] = root + points[j];
	const float found = p_input.ground->height(anchors[j]);
	level = std::isfinite(found) ? found : anchors[j].y;
	anchors[j].y = level;
	root = anchors[j] - points[j];
	weights[j] = 1.0f;
}

void LowestFoot::advance(const GaitInput &p_input) {
	if (held < 0) {
		return;
	}
	const std::vector<Vec3> &points = *p_input.points;
	// p' = p - c_j: the held point stays.
	root = anchors[std::size_t(held)] - points[std::size_t(held)];
	const int lowest = find_lowest(points);
	if (lowest != held) {
		// p = p + c_j - c_k: the new one stays from where it is now.
		weights[std::size_t(held)] = 0.0f;
		held = lowest;
		const std::size_t k = std::size_t(held);
		anchors[k] = root + points[k];
		anchors[k].y = level;
		root = anchors[k] - points[k];
		weights[k] = 1.0f;
	}
}

void LowestFoot::save(ArchiveWriter &p_archive) const {
	Travel::save(p_archive);
	p_archive.put(held);
	p_archive.put(level);
}

bool LowestFoot::restore(ArchiveReader &p_archive) {
	const bool good = Travel::restore(p_archive) && p_archive.get(held) && p_archive.get(level);
	return good && held >= -1 && held < int(contacts.size());
}

} // namespace ragdoll
