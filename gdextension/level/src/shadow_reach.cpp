// SPDX-License-Identifier: MIT
#include "shadow_reach.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace level {

namespace {

/// Most squares along an edge of the light's picture into which cubes are sorted.
constexpr int MAX_SQUARES = 128;
/// How often a triangle is halved at most.
constexpr int DEEPEST = 12;

/// Squares of the light's picture, and which cubes are in each.
class Squares {
public:
	Squares(float p_low_x, float p_low_y, float p_high_x, float p_high_y, float p_edge) :
			_low_x(p_low_x),
			_low_y(p_low_y),
			_edge(std::max({ p_edge, (p_high_x - p_low_x) / MAX_SQUARES, (p_high_y - p_low_y) / MAX_SQUARES })),
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

void ShadowReach::Cube::include(const Vec3 &p_point) {
	low = { std::min(low.x, p_point.x), std::min(low.y, p_point.y), std::min(low.z, p_point.z) };
	high = { std::max(high.x, p_point.x), std::max(high.y, p_point.y), std::max(high.z, p_point.z) };
}

ShadowReach::Key ShadowReach::key_of(const Triangle &p_triangle) const {
	const Vec3 middle = (p_triangle[0] + p_triangle[1] + p_triangle[2]) * (1.0f / (3.0f * cube_m));
	return { int(std::floor(middle.x)), int(std::floor(middle.y)), int(std::floor(middle.z)) };
}

void ShadowReach::add_part(const std::vector<Vec3> &p_points, const std::vector<int32_t> &p_indices,
		const std::vector<Vec3> &p_shadow, bool p_is_within) {
	std::map<Key, Cube> cubes;
	for (std::size_t index = 0; index + 2 < p_indices.size(); index += 3) {
		const Triangle triangle{ p_points[p_indices[index]], p_points[p_indices[index + 1]],
			p_points[p_indices[index + 2]] };
		Cube &cube = cubes[key_of(triangle)];
		for (const Vec3 &corner : triangle) {
			cube.include(corner);
		}
	}
	for (auto &[key, cube] : cubes) {
		cube.number = _parts;
		cube.is_within = p_is_within;
		_cubes.push_back(cube);
	}
	_parts++;
	for (std::size_t index = 0; index + 2 < p_shadow.size(); index += 3) {
		const Triangle triangle{ p_shadow[index], p_shadow[index + 1], p_shadow[index + 2] };
		const Vec3 middle = (triangle[0] + triangle[1] + triangle[2]) * (1.0f / (3.0f * square_m));
		Square &square = _squares[{ int(std::floor(middle.x)), int(std::floor(middle.z)), int(p_is_within) }];
		square.is_within = p_is_within;
		square.corners.insert(square.corners.end(), triangle.begin(), triangle.end());
		add_throwing(square, triangle, 0);
	}
}

/// Large triangles are divided: they would make large cubes.
void ShadowReach::add_throwing(Square &r_square, const Triangle &p_triangle, int p_depth) const {
	std::size_t longest = 0;
	for (std::size_t side = 1; side < 3; side++) {
		const auto length = [&](std::size_t p_side) {
			return (p_triangle[(p_side + 1) % 3] - p_triangle[p_side]).length();
		};
		longest = length(side) > length(longest) ? side : longest;
	}
	const Vec3 &from = p_triangle[longest];
	const Vec3 &to = p_triangle[(longest + 1) % 3];
	const Vec3 &other = p_triangle[(longest + 2) % 3];
	if ((to - from).length() > cube_m && p_depth < DEEPEST) {
		const Vec3 middle = (from + to) * 0.5f;
		add_throwing(r_square, { from, middle, other }, p_depth + 1);
		add_throwing(r_square, { middle, to, other }, p_depth + 1);
		return;
	}
	Cube &cube = r_square.cubes[key_of(p_triangle)];
	for (const Vec3 &corner : p_triangle) {
		cube.include(corner);
	}
}

void ShadowReach::gather() {
	for (auto square = _squares.begin(); square != _squares.end();) {
		auto nearest = _squares.end();
		int least = 0;
		for (auto other = _squares.begin(); other != _squares.end() && square->second.corners.size() < 3 * few;
				other++) {
			const int x = other->first[0] - square->first[0];
			const int z = other->first[1] - square->first[1];
			const int apart = x * x + z * z;
			if (other->second.is_within == square->second.is_within && other->second.corners.size() >= 3 * few &&
					(nearest == _squares.end() || apart < least)) {
				nearest = other;
				least = apart;
			}
		}
		if (nearest == _squares.end()) {
			square++;
			continue;
		}
		Square &into = nearest->second;
		into.corners.insert(into.corners.end(), square->second.corners.begin(), square->second.corners.end());
		for (const auto &[key, cube] : square->second.cubes) {
			Cube &joined = into.cubes[key];
			joined.include(cube.low);
			joined.include(cube.high);
		}
		square = _squares.erase(square);
	}
	for (auto &[place, square] : _squares) {
		_casters.push_back(std::move(square));
	}
	_squares.clear();
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
	_words = (_casters.size() + 63) / 64;
	_shading.assign(_cubes.size() * _words, 0);
	if (_cubes.empty() || !(length > 0.0f)) {
		_shading.clear();
		return;
	}
	const Vec3 way = p_way * (1.0f / length);
	const Vec3 beside = std::fabs(way.y) < 0.9f ? Vec3{ 0.0f, 1.0f, 0.0f } : Vec3{ 1.0f, 0.0f, 0.0f };
	const Vec3 across = beside.cross(way) * (1.0f / beside.cross(way).length());
	const std::array<Vec3, 3> axes{ across, way.cross(across), way };
	std::vector<std::pair<Outline, std::size_t>> throwing;
	std::array<float, 2> low{ 1e30f, 1e30f };
	std::array<float, 2> high{ -1e30f, -1e30f };
	for (std::size_t caster = 0; caster < _casters.size(); caster++) {
		for (const auto &[key, cube] : _casters[caster].cubes) {
			throwing.emplace_back(outline_of(cube, axes), caster);
			for (std::size_t axis = 0; axis < 2; axis++) {
				low[axis] = std::min(low[axis], throwing.back().first.low[axis]);
				high[axis] = std::max(high[axis], throwing.back().first.high[axis]);
			}
		}
	}
	if (throwing.empty()) {
		return;
	}
	Squares squares(low[0], low[1], high[0], high[1], cube_m);
	for (std::size_t number = 0; number < throwing.size(); number++) {
		squares.visit(throwing[number].first.low, throwing[number].first.high,
				[number](std::vector<std::size_t> &r_square) { r_square.push_back(number); });
	}
	for (std::size_t number = 0; number < _cubes.size(); number++) {
		const Outline lit = outline_of(with_room(_cubes[number]), axes);
		uint64_t *bits = &_shading[number * _words];
		squares.visit(lit.low, lit.high, [&](const std::vector<std::size_t> &p_square) {
			for (const std::size_t other : p_square) {
				if (_casters[throwing[other].second].is_within && !_cubes[number].is_within) {
					continue;
				}
				const Outline &by = throwing[other].first;
				if (by.high[2] >= lit.low[2] && by.low[0] <= lit.high[0] && by.high[0] >= lit.low[0] &&
						by.low[1] <= lit.high[1] && by.high[1] >= lit.low[1]) {
					const std::size_t caster = throwing[other].second;
					bits[caster / 64] |= uint64_t(1) << (caster % 64);
				}
			}
		});
	}
}

bool ShadowReach::is_inside(const Vec3 &p_low, const Vec3 &p_high, const std::vector<Bound> &p_bounds) {
	for (const Bound &bound : p_bounds) {
		// The corner that is farthest inside.
		const Vec3 corner{ bound.normal.x > 0.0f ? p_low.x : p_high.x, bound.normal.y > 0.0f ? p_low.y : p_high.y,
			bound.normal.z > 0.0f ? p_low.z : p_high.z };
		if (bound.normal.dot(corner) > bound.distance) {
			return false;
		}
	}
	return true;
}

std::vector<uint8_t> ShadowReach::inside(
		const std::vector<std::array<Vec3, 2>> &p_boxes, const std::vector<Bound> &p_bounds) {
	std::vector<uint8_t> found;
	found.reserve(p_boxes.size());
	for (const std::array<Vec3, 2> &box : p_boxes) {
		found.push_back(is_inside(box[0], box[1], p_bounds) ? 1 : 0);
	}
	return found;
}

std::vector<uint8_t> ShadowReach::look(const std::vector<uint8_t> &p_seen, const std::vector<Bound> &p_bounds) const {
	std::vector<uint8_t> needed(_casters.size(), _shading.empty() ? 1 : 0);
	std::vector<uint64_t> sum(_words, 0);
	for (std::size_t number = 0; number < _cubes.size() && !_shading.empty(); number++) {
		const Cube &cube = _cubes[number];
		if (std::size_t(cube.number) >= p_seen.size() || p_seen[cube.number] == 0) {
			continue;
		}
		const Cube roomy = with_room(cube);
		if (!is_inside(roomy.low, roomy.high, p_bounds)) {
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
