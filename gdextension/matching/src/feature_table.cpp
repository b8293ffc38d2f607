// SPDX-License-Identifier: MIT
#include "feature_table.hpp"

#include <algorithm>
#include <cmath>

namespace matching {

namespace {

/// Floats that the processor takes at once.
constexpr std::size_t LANES = 8;

/// A part of a row: how many features, what it counts, and the least by which it is taken to vary.
struct Part {
	std::size_t first;
	std::size_t count;
	float weight;
	float least;
};
constexpr std::array<Part, 5> PARTS{ {
		{ PLACES, 6, 1.0f, 0.15f },
		{ DIRECTIONS, 6, 1.0f, 0.3f },
		{ ANKLES, 6, 0.75f, 0.03f },
		{ ANKLE_VELOCITIES, 6, 0.75f, 0.2f },
		{ HIPS_VELOCITY, 3, 0.75f, 0.05f },
} };

float sum(const std::array<float, LANES> &p_lanes) {
	return ((p_lanes[0] + p_lanes[4]) + (p_lanes[1] + p_lanes[5])) +
			((p_lanes[2] + p_lanes[6]) + (p_lanes[3] + p_lanes[7]));
}

} // namespace

void FeatureTable::assign(const std::vector<Features> &p_rows) {
	_rows = p_rows;
	_boxes.clear();
	_scales.fill(0.0f);
	const float count = float(std::max<std::size_t>(p_rows.size(), 1));
	for (const Part &part : PARTS) {
		double deviation = 0.0;
		for (std::size_t i = part.first; i < part.first + part.count; i++) {
			double mean = 0.0;
			double square = 0.0;
			for (const Features &row : p_rows) {
				mean += double(row[i]);
				square += double(row[i]) * double(row[i]);
			}
			mean /= double(count);
			deviation += std::sqrt(std::max(square / double(count) - mean * mean, 0.0)) / double(part.count);
		}
		for (std::size_t i = part.first; i < part.first + part.count; i++) {
			_scales[i] = part.weight / std::max(float(deviation), part.least);
		}
	}
	for (Features &row : _rows) {
		scale(row);
	}
	for (std::size_t i = 0; i < _rows.size(); i++) {
		if (i % BLOCK == 0) {
			_boxes.push_back({ _rows[i], _rows[i] });
		}
		for (std::size_t k = 0; k < ROW; k++) {
			_boxes.back().least[k] = std::min(_boxes.back().least[k], _rows[i][k]);
			_boxes.back().most[k] = std::max(_boxes.back().most[k], _rows[i][k]);
		}
	}
}

void FeatureTable::scale(Features &r_row) const {
	for (std::size_t i = 0; i < ROW; i++) {
		r_row[i] *= _scales[i];
	}
}

float FeatureTable::cost(int p_row, const Features &p_of) const {
	const Features &row = _rows[std::size_t(p_row)];
	std::array<float, LANES> lanes{};
	for (std::size_t i = 0; i < ROW; i += LANES) {
		for (std::size_t k = 0; k < LANES; k++) {
			const float apart = row[i + k] - p_of[i + k];
			lanes[k] += apart * apart;
		}
	}
	return sum(lanes);
}

float FeatureTable::_box_cost(const Box &p_box, const Features &p_row, float p_most) const {
	float cost = 0.0f;
	for (std::size_t i = 0; i < ROW && cost < p_most; i += 2 * LANES) {
		std::array<float, LANES> lanes{};
		for (std::size_t j = i; j < i + 2 * LANES; j += LANES) {
			for (std::size_t k = 0; k < LANES; k++) {
				const float below = p_box.least[j + k] - p_row[j + k];
				const float above = p_row[j + k] - p_box.most[j + k];
				const float outside = (below > 0.0f ? below : 0.0f) + (above > 0.0f ? above : 0.0f);
				lanes[k] += outside * outside;
			}
		}
		cost += sum(lanes);
	}
	return cost;
}

FeatureTable::Found FeatureTable::nearest(const Features &p_row, int p_first, int p_end, float p_most) const {
	Found found;
	found.cost = p_most;
	int row = std::max(p_first, 0);
	const int end = std::min(p_end, size());
	while (row < end) {
		const int block = row / BLOCK;
		const int block_end = std::min((block + 1) * BLOCK, end);
		if (_box_cost(_boxes[std::size_t(block)], p_row, found.cost) < found.cost) {
			for (; row < block_end; row++) {
				const float now = cost(row, p_row);
				if (now < found.cost) {
					found = { row, now };
				}
			}
		}
		row = block_end;
	}
	return found;
}

} // namespace matching
