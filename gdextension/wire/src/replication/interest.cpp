// SPDX-License-Identifier: MIT
#include "replication/interest.hpp"

#include <algorithm>
#include <cmath>

namespace wire {

bool Interest::set_cells(const Vec3 &p_origin, float p_size, const std::array<int, 3> &p_counts,
		const uint8_t *p_visible, std::size_t p_table_size) {
	_visible.clear();
	_counts = {};
	int64_t cells = 1;
	for (const int count : p_counts) {
		cells = count >= 1 && count <= MAX_CELLS ? std::min<int64_t>(cells * count, MAX_CELLS + 1) : 0;
	}
	if (cells < 1 || cells > MAX_CELLS || !(p_size > 0.0f) || !std::isfinite(p_size) || !p_origin.is_finite() ||
			p_table_size != std::size_t(cells * cells)) {
		return false;
	}
	_origin = p_origin;
	_size = p_size;
	_counts = p_counts;
	_visible.resize(p_table_size);
	for (std::size_t pair = 0; pair < p_table_size; pair++) {
		_visible[pair] = p_visible[pair] != 0;
	}
	return true;
}

int Interest::cell(const Vec3 &p_position) const {
	const std::array<float, 3> position{ p_position.x - _origin.x, p_position.z - _origin.z, p_position.y - _origin.y };
	const std::array<int, 3> along{ _counts[0], _counts[2], _counts[1] };
	int number = 0;
	for (std::size_t i = 0; i < 3; i++) {
		const float step = std::floor(position[i] / _size);
		// Written so that NaN fails too.
		if (!(step >= 0.0f && step < float(along[i]))) {
			return -1;
		}
		number = number * along[i] + int(step);
	}
	return number;
}

float Interest::weight(const Vec3 &p_from, const Vec3 &p_to) const {
	const float distance = (p_to - p_from).length();
	const float near = HALF_DISTANCE_M / (HALF_DISTANCE_M + distance);
	const float weight = std::isfinite(near) ? std::max(near, FAR) : FAR;
	if (_visible.empty()) {
		return weight;
	}
	const int from = cell(p_from);
	const int to = cell(p_to);
	const int count = _counts[0] * _counts[1] * _counts[2];
	const bool hidden = from >= 0 && to >= 0 && !_visible[std::size_t(from) * std::size_t(count) + std::size_t(to)];
	return hidden ? HIDDEN : weight;
}

} // namespace wire
