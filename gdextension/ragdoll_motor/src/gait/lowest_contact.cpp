// SPDX-License-Identifier: MIT
#include "lowest_contact.hpp"

#include <algorithm>

namespace ragdoll {

void LowestContact::hold(const GaitInput &p_input) {
	const std::vector<Vec3> &points = *p_input.points;
	const float support = find_heights(p_input, points, root, heights);
	if (support <= NOWHERE) {
		std::fill(weights.begin(), weights.end(), 0.0f);
		return; // No ground anywhere: it stays where it is.
	}
	root.y = support;
	const int count =
			int(std::count_if(heights.begin(), heights.end(), [&](float p_of) { return p_of > support - TOGETHER; }));
	for (std::size_t i = 0; i < contacts.size(); i++) {
		const bool stands = heights[i] > support - TOGETHER;
		if (stands && weights[i] == 0.0f) {
			anchors[i] = root + points[i];
		}
		if (heights[i] >= support) {
			floor = root.y + points[i].y - contacts[i].radius;
		}
		weights[i] = stands ? 1.0f / float(count) : 0.0f;
	}
}

void LowestContact::begin(const GaitInput &p_input) {
	std::fill(weights.begin(), weights.end(), 0.0f);
	hold(p_input);
}

void LowestContact::advance(const GaitInput &p_input) {
	const std::vector<Vec3> &points = *p_input.points;
	Vec3 away;
	for (std::size_t i = 0; i < contacts.size(); i++) {
		away = away + (anchors[i] - points[i] - root) * weights[i];
	}
	root.x += away.x;
	root.z += away.z;
	hold(p_input);
}

} // namespace ragdoll
