// SPDX-License-Identifier: MIT
#include "block_mesh.hpp"

#include <algorithm>
#include <cmath>

namespace level {

namespace {

constexpr float PI = 3.14159265358979f;
constexpr Vec3 UP{ 0.0f, 1.0f, 0.0f };
/// A side of a box throws no shadow if it is narrower than this, m, and a smaller part than this of the
/// largest side.
constexpr float NARROW_M = 0.12f;
constexpr float NARROW_SHARE = 0.4f;

Vec3 unit(const Vec3 &p_vector) {
	const float length = p_vector.length();
	return length > 1e-12f ? p_vector * (1.0f / length) : UP;
}

bool holds(const std::vector<Opening> &p_holes, float p_x, float p_y) {
	return std::any_of(p_holes.begin(), p_holes.end(), [&](const Opening &p_hole) {
		return p_x > p_hole.x && p_x < p_hole.x + p_hole.width && p_y > p_hole.y && p_y < p_hole.y + p_hole.height;
	});
}

/// Where holes begin and end along a face, and its own ends.
std::vector<float> edges_of(float p_length, const std::vector<Opening> &p_holes, bool p_across, float p_beside) {
	std::vector<float> marks{ 0.0f, p_length };
	const auto mark = [&](float p_at) {
		if (p_at > 0.02f && p_at < p_length - 0.02f) {
			marks.push_back(p_at);
		}
	};
	for (const Opening &hole : p_holes) {
		const float from = p_across ? hole.x : hole.y;
		const float to = from + (p_across ? hole.width : hole.height);
		mark(from);
		mark(to);
		if (p_beside > 0.0f) {
			mark(from - p_beside);
			mark(to + p_beside);
		}
	}
	std::sort(marks.begin(), marks.end());
	const auto is_same = [](float p_a, float p_b) { return p_b - p_a < 0.001f; };
	marks.erase(std::unique(marks.begin(), marks.end(), is_same), marks.end());
	return marks;
}

float smooth_step(float p_low, float p_high, float p_value) {
	const float t = std::clamp((p_value - p_low) / (p_high - p_low), 0.0f, 1.0f);
	return t * t * (3.0f - 2.0f * t);
}

} // namespace

void BlockMesh::set_dust(float p_amount, float p_ground_y) {
	_dust_amount = p_amount;
	_ground_y = p_ground_y;
}

float BlockMesh::edge_of(int p_layer) const {
	return p_layer >= 0 && std::size_t(p_layer) < _edges.size() ? std::max(_edges[p_layer], 0.01f) : 1.0f;
}

/// Sand lies on what is flat, and is blown against the feet of walls.
float BlockMesh::dust_at(const Vec3 &p_point, const Vec3 &p_normal) const {
	const float height = p_point.y - _ground_y;
	if (p_normal.y > 0.7f) {
		return _dust_amount * (height > 0.5f ? 0.4f : 0.3f);
	}
	return _dust_amount * 0.75f * (1.0f - smooth_step(0.0f, 0.9f, height)) * (p_normal.y < -0.5f ? 0.0f : 1.0f);
}

int32_t BlockMesh::add(
		const Vec3 &p_point, const Vec3 &p_normal, const Vec3 &p_tangent, float p_u, float p_v, const Style &p_style) {
	_points.push_back(p_point);
	_normals.push_back(p_normal);
	_tangents.push_back(p_tangent);
	_uvs.push_back({ p_u + _uv_shift[0], p_v + _uv_shift[1] });
	_styles.push_back({ float(p_style.layer), float(p_style.tint) });
	_dust.push_back(dust_at(p_point, p_normal));
	return int32_t(_points.size()) - 1;
}

std::vector<float> BlockMesh::cuts(float p_length, const std::vector<Opening> &p_holes, bool p_across) const {
	// Light changes most beside an opening.
	const std::vector<float> marks = edges_of(p_length, p_holes, p_across, NEAR_OPENING_M);
	std::vector<float> result{ 0.0f };
	for (std::size_t index = 1; index < marks.size(); index++) {
		const float gap = marks[index] - marks[index - 1];
		const int parts = std::max(1, int(std::ceil(gap / _finest)));
		for (int part = 1; part <= parts; part++) {
			result.push_back(marks[index - 1] + gap * float(part) / float(parts));
		}
	}
	return result;
}

void BlockMesh::face(const Vec3 &p_corner, const Vec3 &p_right, const Vec3 &p_up, float p_width, float p_height,
		const Style &p_style, const std::vector<Opening> &p_holes) {
	if (!(p_width > 0.0f) || !(p_height > 0.0f)) {
		return;
	}
	const std::vector<float> xs = cuts(p_width, p_holes, true);
	const std::vector<float> ys = cuts(p_height, p_holes, false);
	if (_points.size() + xs.size() * ys.size() > MAX_VERTICES) {
		return;
	}
	const float edge = edge_of(p_style.layer);
	const Vec3 right = _place.turn(p_right);
	const Vec3 up = _place.turn(p_up);
	const Vec3 normal = right.cross(up);
	// Vertices that only holes touch are left out.
	std::vector<int32_t> numbers(xs.size() * ys.size(), -1);
	const auto number = [&](std::size_t p_column, std::size_t p_row) {
		int32_t &found = numbers[p_row * xs.size() + p_column];
		if (found < 0) {
			const Vec3 point = _place.point(p_corner + p_right * xs[p_column] + p_up * ys[p_row]);
			found = add(point, normal, right, point.dot(right) / edge, -point.dot(up) / edge, p_style);
		}
		return found;
	};
	for (std::size_t row = 0; row + 1 < ys.size(); row++) {
		for (std::size_t column = 0; column + 1 < xs.size(); column++) {
			if (holds(p_holes, (xs[column] + xs[column + 1]) * 0.5f, (ys[row] + ys[row + 1]) * 0.5f)) {
				continue;
			}
			const int32_t a = number(column, row);
			const int32_t b = number(column + 1, row);
			const int32_t c = number(column, row + 1);
			const int32_t d = number(column + 1, row + 1);
			// Diagonals in turn, so that light does not smear one way.
			if ((row + column) % 2 == 0) {
				_indices.insert(_indices.end(), { a, c, b, b, c, d });
			} else {
				_indices.insert(_indices.end(), { a, c, d, a, d, b });
			}
		}
	}
	add_shadow(p_corner, p_right, p_up, p_width, p_height, p_holes);
}

void BlockMesh::add_shadow(const Vec3 &p_a, const Vec3 &p_b, const Vec3 &p_c) {
	_shadow.insert(_shadow.end(), { p_a, p_b, p_c });
}

/// Strips from hole to hole, each as long as no hole ends it.
void BlockMesh::add_shadow(const Vec3 &p_corner, const Vec3 &p_right, const Vec3 &p_up, float p_width, float p_height,
		const std::vector<Opening> &p_holes) {
	const std::vector<float> xs = edges_of(p_width, p_holes, true, 0.0f);
	const std::vector<float> ys = edges_of(p_height, p_holes, false, 0.0f);
	for (std::size_t column = 0; column + 1 < xs.size(); column++) {
		const float middle = (xs[column] + xs[column + 1]) * 0.5f;
		const auto is_hole = [&](std::size_t p_row) {
			return holds(p_holes, middle, (ys[p_row] + ys[p_row + 1]) * 0.5f);
		};
		for (std::size_t row = 0; row + 1 < ys.size(); row++) {
			if (is_hole(row)) {
				continue;
			}
			const std::size_t first = row;
			while (row + 2 < ys.size() && !is_hole(row + 1)) {
				row++;
			}
			const auto corner = [&](float p_x, float p_y) {
				return _place.point(p_corner + p_right * p_x + p_up * p_y);
			};
			const Vec3 a = corner(xs[column], ys[first]);
			const Vec3 b = corner(xs[column + 1], ys[first]);
			const Vec3 c = corner(xs[column], ys[row + 1]);
			const Vec3 d = corner(xs[column + 1], ys[row + 1]);
			add_shadow(a, c, b);
			add_shadow(b, c, d);
		}
	}
}

/// The shadow of what has the indices from here on is that of its triangles.
void BlockMesh::copy_shadow(std::size_t p_first_index) {
	for (std::size_t index = p_first_index; index < _indices.size(); index++) {
		_shadow.push_back(_points[std::size_t(_indices[index])]);
	}
}

void BlockMesh::quad(const std::array<Vec3, 4> &p_corners, const Style &p_style) {
	const Vec3 across = p_corners[1] - p_corners[0];
	const Vec3 along = p_corners[3] - p_corners[0];
	const Vec3 normal = _place.turn(unit(along.cross(across)));
	const Vec3 right = _place.turn(unit(across));
	const Vec3 up = normal.cross(right);
	const float edge = edge_of(p_style.layer);
	const int columns = std::max(1, int(std::ceil(across.length() / _finest)));
	const int rows = std::max(1, int(std::ceil(along.length() / _finest)));
	const auto first = int32_t(_points.size());
	const std::size_t first_index = _indices.size();
	for (int row = 0; row <= rows; row++) {
		const float t = float(row) / float(rows);
		const Vec3 left = p_corners[0] + (p_corners[3] - p_corners[0]) * t;
		const Vec3 end = p_corners[1] + (p_corners[2] - p_corners[1]) * t;
		for (int column = 0; column <= columns; column++) {
			const Vec3 point = _place.point(left + (end - left) * (float(column) / float(columns)));
			add(point, normal, right, point.dot(right) / edge, -point.dot(up) / edge, p_style);
		}
	}
	const int32_t width = columns + 1;
	for (int32_t row = 0; row < rows; row++) {
		for (int32_t column = 0; column < columns; column++) {
			const int32_t a = first + row * width + column;
			_indices.insert(_indices.end(), { a, a + 1, a + width, a + 1, a + width + 1, a + width });
		}
	}
	const Vec3 diagonal = p_corners[2] - p_corners[0];
	if (std::fabs(diagonal.dot(along.cross(across))) < 0.01f * across.length() * along.length()) {
		add_shadow(_place.point(p_corners[0]), _place.point(p_corners[1]), _place.point(p_corners[3]));
		add_shadow(_place.point(p_corners[1]), _place.point(p_corners[2]), _place.point(p_corners[3]));
	} else {
		copy_shadow(first_index);
	}
}

void BlockMesh::triangle(const Vec3 &p_a, const Vec3 &p_b, const Vec3 &p_c, const Style &p_style) {
	const Vec3 normal = _place.turn(unit((p_c - p_a).cross(p_b - p_a)));
	const Vec3 right = _place.turn(unit(p_b - p_a));
	const Vec3 up = normal.cross(right);
	const float edge = edge_of(p_style.layer);
	const std::size_t first_index = _indices.size();
	for (const Vec3 &corner : { p_a, p_b, p_c }) {
		const Vec3 point = _place.point(corner);
		_indices.push_back(add(point, normal, right, point.dot(right) / edge, -point.dot(up) / edge, p_style));
	}
	copy_shadow(first_index);
}

/// Narrow sides of boards and ends of bars throw no shadow that is seen: the other sides do.
void BlockMesh::box(const Vec3 &p_from, const Vec3 &p_to, const Style &p_style, uint32_t p_without) {
	const Vec3 low{ std::min(p_from.x, p_to.x), std::min(p_from.y, p_to.y), std::min(p_from.z, p_to.z) };
	const Vec3 high{ std::max(p_from.x, p_to.x), std::max(p_from.y, p_to.y), std::max(p_from.z, p_to.z) };
	const Vec3 size = high - low;
	constexpr Vec3 X{ 1.0f, 0.0f, 0.0f };
	constexpr Vec3 Z{ 0.0f, 0.0f, 1.0f };
	const float largest = std::max({ size.x * size.y, size.y * size.z, size.z * size.x });
	const auto side = [&](FaceOfBox p_side, const Vec3 &p_corner, const Vec3 &p_right, const Vec3 &p_up, float p_width,
							  float p_height) {
		if ((p_without & p_side) == 0) {
			const std::size_t before = _shadow.size();
			face(p_corner, p_right, p_up, p_width, p_height, p_style);
			if (std::min(p_width, p_height) < NARROW_M && p_width * p_height < NARROW_SHARE * largest) {
				_shadow.resize(before);
			}
		}
	};
	side(FACE_FRONT, { low.x, low.y, high.z }, X, UP, size.x, size.y);
	side(FACE_BACK, { high.x, low.y, low.z }, X * -1.0f, UP, size.x, size.y);
	side(FACE_RIGHT, { high.x, low.y, high.z }, Z * -1.0f, UP, size.z, size.y);
	side(FACE_LEFT, { low.x, low.y, low.z }, Z, UP, size.z, size.y);
	side(FACE_TOP, { low.x, high.y, high.z }, X, Z * -1.0f, size.x, size.z);
	side(FACE_BOTTOM, { low.x, low.y, low.z }, X, Z, size.x, size.z);
}

void BlockMesh::rod(const Vec3 &p_from, const Vec3 &p_to, float p_radius, float p_end_radius, const Style &p_style,
		int p_sides, bool p_has_ends) {
	const float length = (p_to - p_from).length();
	const int sides = std::clamp(p_sides, 3, 64);
	if (!(length > 1e-6f)) {
		return;
	}
	const Vec3 way = (p_to - p_from) * (1.0f / length);
	const Vec3 side = unit(way.cross(std::fabs(way.y) < 0.9f ? UP : Vec3{ 1.0f, 0.0f, 0.0f }));
	const Vec3 other = way.cross(side);
	const float edge = edge_of(p_style.layer);
	const int rings = std::max(1, int(std::ceil(length / _finest)));
	const auto first = int32_t(_points.size());
	for (int ring = 0; ring <= rings; ring++) {
		const float t = float(ring) / float(rings);
		const float radius = p_radius + (p_end_radius - p_radius) * t;
		for (int number = 0; number <= sides; number++) {
			const float angle = 2.0f * PI * float(number) / float(sides);
			const Vec3 out = side * std::cos(angle) + other * std::sin(angle);
			const Vec3 normal = unit(out + way * ((p_radius - p_end_radius) / length));
			add(_place.point(p_from + way * (length * t) + out * radius), _place.turn(normal), _place.turn(way),
					length * t / edge, angle * p_radius / edge, p_style);
		}
	}
	const int32_t width = sides + 1;
	for (int32_t ring = 0; ring < rings; ring++) {
		for (int32_t number = 0; number < sides; number++) {
			const int32_t a = first + ring * width + number;
			_indices.insert(_indices.end(), { a, a + width, a + 1, a + 1, a + width, a + width + 1 });
		}
	}
	const std::size_t last_ring = std::size_t(first) + std::size_t(rings) * std::size_t(width);
	for (int32_t number = 0; number < sides; number++) {
		const std::size_t a = std::size_t(first) + std::size_t(number);
		const std::size_t c = last_ring + std::size_t(number);
		add_shadow(_points[a], _points[c], _points[a + 1]);
		add_shadow(_points[a + 1], _points[c], _points[c + 1]);
	}
	if (p_has_ends) {
		const std::size_t first_index = _indices.size();
		cap(p_from, way * -1.0f, side, p_radius, p_style, sides);
		cap(p_to, way, side, p_end_radius, p_style, sides);
		copy_shadow(first_index);
	}
}

void BlockMesh::cap(const Vec3 &p_middle, const Vec3 &p_way, const Vec3 &p_side, float p_radius, const Style &p_style,
		int p_sides) {
	if (!(p_radius > 1e-4f)) {
		return;
	}
	const Vec3 other = p_way.cross(p_side);
	const Vec3 normal = _place.turn(p_way);
	const Vec3 tangent = _place.turn(p_side);
	const float edge = edge_of(p_style.layer);
	const int32_t middle = add(_place.point(p_middle), normal, tangent, 0.0f, 0.0f, p_style);
	for (int number = 0; number <= p_sides; number++) {
		const float angle = 2.0f * PI * float(number) / float(p_sides);
		const Vec3 out = p_side * std::cos(angle) + other * std::sin(angle);
		add(_place.point(p_middle + out * p_radius), normal, tangent, std::cos(angle) * p_radius / edge,
				std::sin(angle) * p_radius / edge, p_style);
		if (number > 0) {
			_indices.insert(_indices.end(), { middle, middle + 1 + number, middle + number });
		}
	}
}

void BlockMesh::surface(const std::vector<Vec3> &p_points, const std::vector<Vec3> &p_normals,
		const std::vector<std::array<float, 2>> &p_uvs, const std::vector<int32_t> &p_indices, const Style &p_style) {
	const auto first = int32_t(_points.size());
	const auto count = int32_t(p_points.size());
	if (p_normals.size() != p_points.size() || p_uvs.size() != p_points.size() || p_indices.size() % 3 != 0 ||
			_points.size() + p_points.size() > MAX_VERTICES ||
			std::any_of(p_indices.begin(), p_indices.end(), [&](int32_t i) { return i < 0 || i >= count; })) {
		return;
	}
	const float edge = edge_of(p_style.layer);
	for (std::size_t index = 0; index < p_points.size(); index++) {
		const Vec3 normal = unit(_place.turn(p_normals[index]));
		const Vec3 tangent = unit(normal.cross(std::fabs(normal.y) < 0.9f ? UP : Vec3{ 1.0f, 0.0f, 0.0f }));
		add(_place.point(p_points[index]), normal, tangent, p_uvs[index][0] / edge, p_uvs[index][1] / edge, p_style);
	}
	const std::size_t first_index = _indices.size();
	for (const int32_t index : p_indices) {
		_indices.push_back(first + index);
	}
	copy_shadow(first_index);
}

void BlockMesh::solid(const Vec3 &p_from, const Vec3 &p_to) {
	const Vec3 size{ std::fabs(p_to.x - p_from.x), std::fabs(p_to.y - p_from.y), std::fabs(p_to.z - p_from.z) };
	Place place = _place;
	place.origin = _place.point((p_from + p_to) * 0.5f);
	_solids.push_back({ place, size });
}

} // namespace level
