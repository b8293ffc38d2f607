// SPDX-License-Identifier: MIT
#include "comparison/lowest_contact.hpp"

#include <algorithm>

namespace ragdoll {

void LowestContact::hold(const GaitInput &p_input) {
	const std::vector<Vec3> &points = *p_input.points;
	const float support = find_heights(p_input, points, _root, _heights);
	if (support <= NOWHERE) {
		std::fill(_weights.begin(), _weights.end(), 0.0f);
		return; // No ground anywhere: it stays where it is.
	}
	_root.y = support;
	const int count =
			int(std::count_if(_heights.begin(), _heights.end(), [&](float p_of) { return p_of > support - TOGETHER; }));
	for (std::size_t i = 0; i < _contacts.size(); i++) {
		const bool stands = _heights[i] > support - TOGETHER;
		if (stands && _weights[i] == 0.0f) {
			_anchors[i] = _root + points[i];
		}
		if (_heights[i] >= support) {
			_floor = _root.y + points[i].y - _contacts[i].radius;
		}
		_weights[i] = stands ? 1.0f / float(count) : 0.0f;
	}
}

void LowestContact::begin(const GaitInput &p_input) {
	std::fill(_weights.begin(), _weights.end(), 0.0f);
	hold(p_input);
}

void LowestContact::advance(const GaitInput &p_input) {
	const std::vector<Vec3> &points = *p_input.points;
	Vec3 away;
	for (std::size_t i = 0; i < _contacts.size(); i++) {
		_anchors[i] = _anchors[i] + get_carry(i, _anchors[i], p_input.delta_s);
		away = away + (_anchors[i] - points[i] - _root) * _weights[i];
	}
	_root.x += away.x;
	_root.z += away.z;
	hold(p_input);
}

} // namespace ragdoll
