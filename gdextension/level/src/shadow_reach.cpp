// SPDX-License-Identifier: MIT
#include "shadow_reach.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace level {

namespace {

/// Most squares along an edge of the light's picture into which cubes are sorted.
constexpr int MOST_SQUARES = 128;

/// Squares of the light's picture, and which cubes are in each.
class Squares {
public:
	Squares(float p_low_x, float p_low_y, float p_high_x, float p_high_y, float p_edge) :
			_low_x(p_low_x),
			_low_y(p_low_y),
			_edge(std::max({ p_edge, (p_high_x - p_low_x) / MOST_SQUARES, (p_high_y - p_low_y) / MOST_SQUARES })),
			_columns(int((p_high_x - p_low_x) / _edge) + 1),
			_rows(int((p_high_y - p_low_y) / _edge) + 1),
			_numbers(std::size_t(_columns) * _rows) {}

	/// Calls with the list of each square that a rectangle touches.
	template <typename Call>
	void visit(const std::array<float, 3> &p_low, const std::array<float, 3> &p_high, const Call &p_call) {
		const int last_x = column(p_high[0]);
		const int last_y = row(p_high[1]);
		for (int y = row(p_low[1]); y <= last_y; y++) {
			for (int x = column(p_low[0]); x <= last_x; x++) {
				p_call(_numbers[std::size_t(y) * _columns + x]);
			}
		}
	}

private:
	int column(float p_x) const { return std::clamp(int((p_x - _low_x) / _edge), 0, _columns - 1); }
	int row(float p_y) const { return std::clamp(int((p_y - _low_y) / _edge), 0, _rows - 1); }

	float _low_x;
	float _low_y;
	float _edge;
	int _columns;
	int _rows;
	std::vector<std::vector<std::size_t>> _numbers;
};

} // namespace

void ShadowReach::add_part(const std::vector<Vec3> &p_points, const std::vector<int32_t> &p_indices, int p_caster) {
	std::map<std::array<int, 3>, Cube> cubes;
	for (std::size_t index = 0; index + 2 < p_indices.size(); index += 3) {
		const std::array<Vec3, 3> corners{ p_points[p_indices[index]], p_points[p_indices[index + 1]],
			p_points[p_indices[index + 2]] };
		const Vec3 middle = (corners[0] + corners[1] + corners[2]) * (1.0f / (3.0f * cube_m));
		Cube &cube = cubes[{ int(std::floor(middle.x)), int(std::floor(middle.y)), int(std::floor(middle.z)) }];
		for (const Vec3 &corner : corners) {
			cube.low = { std::min(cube.low.x, corner.x), std::min(cube.low.y, corner.y),
				std::min(cube.low.z, corner.z) };
			cube.high = { std::max(cube.high.x, corner.x), std::max(cube.high.y, corner.y),
				std::max(cube.high.z, corner.z) };
		}
	}
	for (auto &[key, cube] : cubes) {
		cube.part = _parts;
		cube.caster = p_caster;
		_cubes.push_back(cube);
	}
	_parts++;
	_casters = std::max(_casters, p_caster + 1);
	_shading.clear();
}

ShadowReach::Outline ShadowReach::outline_of(const Cube &p_cube, const std::array<Vec3, 3> &p_axes) {
	const Vec3 middle = (p_cube.low + p_cube.high) * 0.5f;
	const Vec3 half = (p_cube.high - p_cube.low) * 0.5f;
	Outline outline{};
	for (std::size_t axis = 0; axis < 3; axis++) {
		const Vec3 &way = p_axes[axis];
		const float at = middle.dot(way);
		const float reach = half.dot({ std::fabs(way.x), std::fabs(way.y), std::fabs(way.z) });
		outline.low[axis] = at - reach;
		outline.high[axis] = at + reach;
	}
	return outline;
}

ShadowReach::Cube ShadowReach::with_room(const Cube &p_cube) const {
	Cube cube = p_cube;
	cube.low = cube.low - Vec3{ beside_m, beside_m, beside_m };
	cube.high = cube.high + Vec3{ beside_m, above_m, beside_m };
	return cube;
}

void ShadowReach::set_light(const Vec3 &p_way) {
	const float length = p_way.length();
	_words = (std::size_t(_casters) + 63) / 64;
	_shading.assign(_cubes.size() * _words, 0);
	if (_cubes.empty() || !(length > 0.0f)) {
		_shading.clear();
		return;
	}
	const Vec3 way = p_way * (1.0f / length);
	const Vec3 beside = std::fabs(way.y) < 0.9f ? Vec3{ 0.0f, 1.0f, 0.0f } : Vec3{ 1.0f, 0.0f, 0.0f };
	const Vec3 across = beside.cross(way) * (1.0f / beside.cross(way).length());
	const std::array<Vec3, 3> axes{ across, way.cross(across), way };
	std::vector<Outline> throwing;
	std::array<float, 2> low{ 1e30f, 1e30f };
	std::array<float, 2> high{ -1e30f, -1e30f };
	for (const Cube &cube : _cubes) {
		throwing.push_back(outline_of(cube, axes));
		for (std::size_t axis = 0; axis < 2; axis++) {
			low[axis] = std::min(low[axis], throwing.back().low[axis]);
			high[axis] = std::max(high[axis], throwing.back().high[axis]);
		}
	}
	Squares squares(low[0], low[1], high[0], high[1], cube_m);
	for (std::size_t number = 0; number < _cubes.size(); number++) {
		if (_cubes[number].caster >= 0) {
			squares.visit(throwing[number].low, throwing[number].high,
					[number](std::vector<std::size_t> &r_square) { r_square.push_back(number); });
		}
	}
	for (std::size_t number = 0; number < _cubes.size(); number++) {
		const Outline lit = outline_of(with_room(_cubes[number]), axes);
		uint64_t *bits = &_shading[number * _words];
		squares.visit(lit.low, lit.high, [&](const std::vector<std::size_t> &p_square) {
			for (const std::size_t other : p_square) {
				const Outline &by = throwing[other];
				if (by.high[2] >= lit.low[2] && by.low[0] <= lit.high[0] && by.high[0] >= lit.low[0] &&
						by.low[1] <= lit.high[1] && by.high[1] >= lit.low[1]) {
					const auto caster = std::size_t(_cubes[other].caster);
					bits[caster / 64] |= uint64_t(1) << (caster % 64);
				}
			}
		});
	}
}

bool ShadowReach::is_inside(const Cube &p_cube, const std::vector<Bound> &p_bounds) {
	for (const Bound &bound : p_bounds) {
		// The corner that is farthest inside.
		const Vec3 corner{ bound.normal.x > 0.0f ? p_cube.low.x : p_cube.high.x,
			bound.normal.y > 0.0f ? p_cube.low.y : p_cube.high.y, bound.normal.z > 0.0f ? p_cube.low.z : p_cube.high.z };
		if (bound.normal.dot(corner) > bound.distance) {
			return false;
		}
	}
	return true;
}

std::vector<uint8_t> ShadowReach::look(
		const std::vector<uint8_t> &p_seen, const std::vector<Bound> &p_bounds) const {
	std::vector<uint8_t> needed(std::size_t(_casters), _shading.empty() ? 1 : 0);
	std::vector<uint64_t> sum(_words, 0);
	for (std::size_t number = 0; number < _cubes.size() && !_shading.empty(); number++) {
		const Cube &cube = _cubes[number];
		if (std::size_t(cube.part) >= p_seen.size() || p_seen[cube.part] == 0 ||
				!is_inside(with_room(cube), p_bounds)) {
			continue;
		}
		for (std::size_t word = 0; word < _words; word++) {
			sum[word] |= _shading[number * _words + word];
		}
	}
	for (std::size_t caster = 0; caster < needed.size() && !_shading.empty(); caster++) {
		needed[caster] = uint8_t(sum[caster / 64] >> (caster % 64) & 1);
	}
	return needed;
}

} // namespace level
