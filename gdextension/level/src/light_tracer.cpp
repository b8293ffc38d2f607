// SPDX-License-Identifier: MIT
#include "light_tracer.hpp"
#include "directions.hpp"
#include "workers.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace level {

namespace {

/// Vertices are the same place within this, m and as a part of a normal.
constexpr float SAME_PLACE_M = 0.02f;
constexpr float SAME_NORMAL = 0.2f;
/// Rays begin so far from the surface, and so far from the edge of a face, m.
constexpr float LIFT_M = 0.03f;
constexpr float INSET_M = 0.06f;
/// A place is inside something if more of its rays than this meet surfaces from behind.
constexpr float MAX_BACKS = 0.45f;
constexpr uint32_t BACK = Hit::NOTHING - 1;
constexpr int FILL_ROUNDS = 12;
/// How much of its light a place takes from its neighbours.
constexpr float SMOOTHING = 0.4f;
/// Points of a triangle at which the sun is looked for: fewest, most, and for each m².
constexpr int MIN_POINTS = 3;
constexpr int MAX_POINTS = 24;
constexpr float POINTS_PER_M2 = 24.0f;

struct Key {
	std::array<int32_t, 6> numbers;
	bool operator==(const Key &p_other) const { return numbers == p_other.numbers; }
};

struct KeyHash {
	std::size_t operator()(const Key &p_key) const {
		std::size_t hash = 1469598103934665603ULL;
		for (const int32_t number : p_key.numbers) {
			hash = (hash ^ std::size_t(uint32_t(number))) * 1099511628211ULL;
		}
		return hash;
	}
};

/// One of several points that lie evenly in a triangle.
Vec3 point_in(const Triangle &p_triangle, int p_number, int p_count) {
	float u = (float(p_number) + 0.5f) / float(p_count);
	float v = std::fmod(float(p_number + 1) * 0.61803398875f, 1.0f);
	if (u + v > 1.0f) {
		u = 1.0f - u;
		v = 1.0f - v;
	}
	return p_triangle.a + (p_triangle.b - p_triangle.a) * u + (p_triangle.c - p_triangle.a) * v;
}

int32_t rounded(float p_value, float p_step) {
	return int32_t(std::floor(p_value / p_step + 0.5f));
}

void add_scaled(Light &r_sum, const Light &p_light, const Vec3 &p_colour) {
	for (int set = 0; set < LIGHT_SETS; set++) {
		r_sum[set] = r_sum[set] + p_light[set].scaled(p_colour);
	}
}

} // namespace

std::size_t LightTracer::add(const std::vector<Vec3> &p_points, const std::vector<Vec3> &p_normals,
		const std::vector<int32_t> &p_indices, const std::vector<Vec3> &p_albedo) {
	const auto first = uint32_t(_points.size());
	_points.insert(_points.end(), p_points.begin(), p_points.end());
	_normals.insert(_normals.end(), p_normals.begin(), p_normals.end());
	for (std::size_t index = 0; index + 2 < p_indices.size(); index += 3) {
		const std::array<uint32_t, 3> corners{ first + uint32_t(p_indices[index]),
			first + uint32_t(p_indices[index + 1]), first + uint32_t(p_indices[index + 2]) };
		_corners.push_back(corners);
		_triangles.push_back({ _points[corners[0]], _points[corners[1]], _points[corners[2]] });
		_albedo.push_back(p_albedo[index / 3]);
	}
	return first;
}

void LightTracer::find_places() {
	// Corners of faces lie in the plane of their neighbours: samples are moved towards the middle.
	std::vector<Vec3> middles(_points.size());
	std::vector<float> counts(_points.size(), 0.0f);
	for (const std::array<uint32_t, 3> &corners : _corners) {
		const Vec3 middle = (_points[corners[0]] + _points[corners[1]] + _points[corners[2]]) * (1.0f / 3.0f);
		for (const uint32_t corner : corners) {
			middles[corner] = middles[corner] + middle;
			counts[corner] += 1.0f;
		}
	}
	std::unordered_map<Key, uint32_t, KeyHash> known;
	_place_of.resize(_points.size());
	for (std::size_t index = 0; index < _points.size(); index++) {
		const Vec3 normal = _normals[index];
		Vec3 point = _points[index];
		if (counts[index] > 0.0f) {
			point = point + (middles[index] * (1.0f / counts[index]) - point).limited(INSET_M);
		}
		point = point + normal * LIFT_M;
		const Key key{ { rounded(point.x, SAME_PLACE_M), rounded(point.y, SAME_PLACE_M), rounded(point.z, SAME_PLACE_M),
				rounded(normal.x, SAME_NORMAL), rounded(normal.y, SAME_NORMAL), rounded(normal.z, SAME_NORMAL) } };
		const auto found = known.try_emplace(key, uint32_t(_places.size()));
		if (found.second) {
			_places.push_back({ point, normal });
		}
		_place_of[index] = found.first->second;
	}
}

Vec3 LightTracer::lamp_light(const Lamp &p_lamp, const Vec3 &p_from, const Vec3 *p_normal, Vec3 &r_way) const {
	const Vec3 to_lamp = p_lamp.position - p_from;
	const float distance = to_lamp.length();
	if (distance >= p_lamp.range || distance < 1e-4f) {
		return {};
	}
	r_way = to_lamp * (1.0f / distance);
	const float facing = p_normal != nullptr ? p_normal->dot(r_way) : 1.0f;
	if (facing <= 0.0f || -r_way.dot(p_lamp.way) < p_lamp.cone) {
		return {};
	}
	if (_scene.is_blocked(p_from, p_lamp.position)) {
		return {};
	}
	const float share = distance / p_lamp.range;
	const float fade = 1.0f - share * share * share * share;
	return p_lamp.colour * (facing * fade * fade / std::max(distance * distance, 0.04f));
}

void LightTracer::trace_direct(std::size_t p_first, std::size_t p_last) {
	for (std::size_t index = p_first; index < p_last; index++) {
		const Sample &place = _places[index];
		Light &direct = _direct[index];
		for (const Lamp &lamp : lamps) {
			Vec3 way;
			direct[LIGHT_LAMPS] = direct[LIGHT_LAMPS] + lamp_light(lamp, place.position, &place.normal, way);
		}
	}
}

void LightTracer::trace_patches(std::size_t p_first, std::size_t p_last) {
	for (std::size_t index = p_first; index < p_last; index++) {
		const Triangle &triangle = _triangles[index];
		const Vec3 across = triangle.normal();
		const float area = 0.5f * across.length();
		if (!(area > 0.0f)) {
			continue;
		}
		const Vec3 normal = across * (0.5f / area);
		const int points = std::clamp(int(area * POINTS_PER_M2), MIN_POINTS, MAX_POINTS);
		for (int sun = 0; sun < SUNS; sun++) {
			const float facing = normal.dot(suns[sun]);
			int lit = 0;
			for (int point = 0; point < points && facing > 0.0f; point++) {
				const Vec3 from = point_in(triangle, point, points) + normal * LIFT_M;
				lit += _scene.is_blocked(from, from + suns[sun] * farthest) ? 0 : 1;
			}
			_patches[index][sun] = std::max(facing, 0.0f) * float(lit) / float(points);
		}
	}
}

Vec3 LightTracer::sky_light(const Vec3 &p_way) const {
	return p_way.y >= 0.0f ? Vec3{ 1.0f, 1.0f, 1.0f } : far_ground;
}

/// Where rays end is found once; what comes from there is found for each bounce.
void LightTracer::trace_gather(std::size_t p_first, std::size_t p_last) {
	const std::vector<Vec3> ways = hemisphere(rays);
	for (std::size_t index = p_first; index < p_last; index++) {
		const Sample &place = _places[index];
		const Frame frame = frame_of(place.normal);
		int backs = 0;
		for (int ray = 0; ray < rays; ray++) {
			const Hit hit = _scene.closest(place.position, frame.turn(ways[ray]), farthest);
			_met[index * rays + ray] = hit.is_back ? BACK : hit.triangle;
			backs += hit.is_back ? 1 : 0;
		}
		_hidden[index] = float(backs) > MAX_BACKS * float(rays) ? 1 : 0;
	}
}

/// What triangles send out: what falls on their corners, times their colour.
void LightTracer::throw_back() {
	for (std::size_t triangle = 0; triangle < _triangles.size(); triangle++) {
		Light sum{};
		float counted = 0.0f;
		for (const uint32_t corner : _corners[triangle]) {
			const uint32_t place = _place_of[corner];
			if (_hidden[place] == 0) {
				add_scaled(sum, _light[place], { 1.0f, 1.0f, 1.0f });
				sum[LIGHT_LAMPS] = sum[LIGHT_LAMPS] + _direct[place][LIGHT_LAMPS];
				counted += 1.0f;
			}
		}
		Light falls{};
		if (counted > 0.0f) {
			add_scaled(falls, sum, Vec3{ 1.0f, 1.0f, 1.0f } * (1.0f / counted));
		}
		for (int sun = 0; sun < SUNS; sun++) {
			falls[LIGHT_MORNING + sun] =
					falls[LIGHT_MORNING + sun] + Vec3{ 1.0f, 1.0f, 1.0f } * _patches[triangle][sun];
		}
		_sent[triangle] = {};
		add_scaled(_sent[triangle], falls, _albedo[triangle]);
	}
}

void LightTracer::bake() {
	_progress = 0.0f;
	_scene.build(_triangles);
	_grid_ways = sphere(GRID_RAYS);
	find_places();
	_direct.assign(_places.size(), {});
	_light.assign(_places.size(), {});
	_sent.assign(_triangles.size(), {});
	_hidden.assign(_places.size(), 0);
	_patches.assign(_triangles.size(), {});
	_met.assign(_places.size() * std::size_t(rays), Hit::NOTHING);
	const Workers workers(threads, _progress);
	workers.share_out(_places.size(), 0.02f, 0.05f,
			[&](std::size_t p_first, std::size_t p_last) { trace_direct(p_first, p_last); });
	workers.share_out(_triangles.size(), 0.05f, 0.15f,
			[&](std::size_t p_first, std::size_t p_last) { trace_patches(p_first, p_last); });
	workers.share_out(_places.size(), 0.15f, 0.85f,
			[&](std::size_t p_first, std::size_t p_last) { trace_gather(p_first, p_last); });
	const std::vector<Vec3> ways = hemisphere(rays);
	for (int bounce = 0; bounce <= bounces; bounce++) {
		throw_back();
		const float done = 0.85f + 0.13f * float(bounce) / float(bounces + 1);
		workers.share_out(_places.size(), done, done + 0.01f, [&](std::size_t p_first, std::size_t p_last) {
			for (std::size_t index = p_first; index < p_last; index++) {
				const Frame frame = frame_of(_places[index].normal);
				Light sum{};
				for (int ray = 0; ray < rays; ray++) {
					const uint32_t met = _met[index * rays + ray];
					if (met == Hit::NOTHING) {
						sum[LIGHT_SKY] = sum[LIGHT_SKY] + sky_light(frame.turn(ways[ray]));
					} else if (met != BACK) {
						add_scaled(sum, _sent[met], { 1.0f, 1.0f, 1.0f });
					}
				}
				for (int set = 0; set < LIGHT_SETS; set++) {
					_light[index][set] = sum[set] * (1.0f / float(rays));
				}
			}
		});
	}
	// Lamps are not drawn each frame: what comes straight from them belongs to it.
	for (std::size_t index = 0; index < _places.size(); index++) {
		_light[index][LIGHT_LAMPS] = _light[index][LIGHT_LAMPS] + _direct[index][LIGHT_LAMPS];
	}
	fill_hidden();
	smooth();
	_met = {};
	_progress = 1.0f;
}

/// A corner inside a wall is black, and would darken the face that it belongs to: it takes the light
/// of its neighbours.
void LightTracer::fill_hidden() {
	for (int round = 0; round < FILL_ROUNDS; round++) {
		std::vector<Light> sums(_places.size());
		std::vector<float> counts(_places.size(), 0.0f);
		for (const std::array<uint32_t, 3> &corners : _corners) {
			for (int corner = 0; corner < 3; corner++) {
				const uint32_t here = _place_of[corners[corner]];
				if (_hidden[here] == 0) {
					continue;
				}
				for (int step = 1; step < 3; step++) {
					const uint32_t there = _place_of[corners[(corner + step) % 3]];
					if (_hidden[there] == 0) {
						add_scaled(sums[here], _light[there], { 1.0f, 1.0f, 1.0f });
						counts[here] += 1.0f;
					}
				}
			}
		}
		bool changed = false;
		for (std::size_t index = 0; index < _places.size(); index++) {
			if (counts[index] > 0.0f) {
				_light[index] = {};
				add_scaled(_light[index], sums[index], Vec3{ 1.0f, 1.0f, 1.0f } * (1.0f / counts[index]));
				_hidden[index] = 0;
				changed = true;
			}
		}
		if (!changed) {
			return;
		}
	}
}

/// Few rays give grain, which neighbours on the same plane even out.
void LightTracer::smooth() {
	std::vector<Light> sums(_places.size());
	std::vector<float> counts(_places.size(), 0.0f);
	for (const std::array<uint32_t, 3> &corners : _corners) {
		for (int corner = 0; corner < 3; corner++) {
			const uint32_t here = _place_of[corners[corner]];
			const uint32_t there = _place_of[corners[(corner + 1) % 3]];
			if (_hidden[here] != 0 || _hidden[there] != 0) {
				continue;
			}
			add_scaled(sums[here], _light[there], { 1.0f, 1.0f, 1.0f });
			add_scaled(sums[there], _light[here], { 1.0f, 1.0f, 1.0f });
			counts[here] += 1.0f;
			counts[there] += 1.0f;
		}
	}
	for (std::size_t index = 0; index < _places.size(); index++) {
		if (counts[index] > 0.0f) {
			Light mixed{};
			add_scaled(mixed, _light[index], Vec3{ 1.0f, 1.0f, 1.0f } * (1.0f - SMOOTHING));
			add_scaled(mixed, sums[index], Vec3{ 1.0f, 1.0f, 1.0f } * (SMOOTHING / counts[index]));
			_light[index] = mixed;
		}
	}
}

bool LightTracer::gather_at(const Vec3 &p_point, Light &r_above, Light &r_below) const {
	const std::vector<Vec3> &ways = _grid_ways;
	r_above = {};
	r_below = {};
	int backs = 0;
	float weights = 0.0f;
	for (const Vec3 &way : ways) {
		const Hit hit = _scene.closest(p_point, way, farthest);
		Light &sum = way.y >= 0.0f ? r_above : r_below;
		const float weight = std::fabs(way.y) + 0.25f;
		weights += weight * 0.5f;
		if (hit.is_back) {
			backs++;
		} else if (hit.triangle == Hit::NOTHING) {
			sum[LIGHT_SKY] = sum[LIGHT_SKY] + sky_light(way) * weight;
		} else {
			add_scaled(sum, _sent[hit.triangle], Vec3{ 1.0f, 1.0f, 1.0f } * weight);
		}
	}
	for (int set = 0; set < LIGHT_SETS; set++) {
		r_above[set] = r_above[set] * (1.0f / weights);
		r_below[set] = r_below[set] * (1.0f / weights);
	}
	for (const Lamp &lamp : lamps) {
		Vec3 way;
		const Vec3 light = lamp_light(lamp, p_point, nullptr, way);
		const float upward = way.y * 0.5f + 0.5f;
		r_above[LIGHT_LAMPS] = r_above[LIGHT_LAMPS] + light * (0.5f * upward);
		r_below[LIGHT_LAMPS] = r_below[LIGHT_LAMPS] + light * (0.5f * (1.0f - upward));
	}
	return float(backs) <= MAX_BACKS * float(ways.size());
}

} // namespace level
