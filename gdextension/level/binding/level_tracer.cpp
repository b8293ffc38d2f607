// SPDX-License-Identifier: MIT
#include "level_tracer.hpp"

#include "byte_array.hpp"

#include <convert.hpp>
#include <light_coding.hpp>
#include <workers.hpp>

#include <algorithm>
#include <cmath>

namespace godot {

namespace {

constexpr double PI = 3.14159265358979;
constexpr int64_t MAX_CELLS = 8192;
constexpr int64_t MAX_POINTS = 4'000'000;

level::Vec3 colour_of(const Color &p_colour) {
	return { p_colour.r, p_colour.g, p_colour.b };
}

uint8_t *write_light(const level::Light &p_light, uint8_t *r_to) {
	for (const level::Vec3 &set : p_light) {
		*r_to++ = level::encode_light(set.x);
		*r_to++ = level::encode_light(set.y);
		*r_to++ = level::encode_light(set.z);
	}
	return r_to;
}

} // namespace

void LevelTracer::set_palette(const PackedColorArray &p_layers, const PackedColorArray &p_tints) {
	_layers.clear();
	_tints.clear();
	for (const Color &colour : p_layers) {
		_layers.push_back(colour_of(colour));
	}
	for (const Color &colour : p_tints) {
		_tints.push_back(colour_of(colour));
	}
}

void LevelTracer::set_suns(const Vector3 &p_morning, const Vector3 &p_noon, const Vector3 &p_evening) {
	_light.suns = { to_core(p_morning.normalized()), to_core(p_noon.normalized()), to_core(p_evening.normalized()) };
}

void LevelTracer::set_effort(int64_t p_rays, int64_t p_bounces, int64_t p_threads) {
	_light.rays = int(std::clamp<int64_t>(p_rays, 4, 1024));
	_light.bounces = int(std::clamp<int64_t>(p_bounces, 0, 8));
	_light.threads = int(std::clamp<int64_t>(p_threads, 1, 64));
}

void LevelTracer::add_lamp(
		const Vector3 &p_position, const Color &p_colour, double p_range, const Vector3 &p_way, double p_angle) {
	ERR_FAIL_COND_MSG(!p_position.is_finite() || !(p_range > 0.0), "A lamp needs a finite place and a range.");
	level::Lamp lamp{ to_core(p_position), colour_of(p_colour), float(p_range), to_core(p_way.normalized()), -1.0f };
	if (p_angle < PI) {
		lamp.cone = float(std::cos(p_angle));
	}
	_light.lamps.push_back(lamp);
}

level::Vec3 LevelTracer::_albedo(int p_layer, int p_tint) const {
	const level::Vec3 grey{ 0.5f, 0.5f, 0.5f };
	const bool has_layer = p_layer >= 0 && std::size_t(p_layer) < _layers.size();
	const bool has_tint = p_tint >= 0 && std::size_t(p_tint) < _tints.size();
	const level::Vec3 layer = has_layer ? _layers[p_layer] : grey;
	return has_tint ? layer.scaled(_tints[p_tint]) : layer;
}

int64_t LevelTracer::add_part(const Ref<BlockMesh> &p_mesh) {
	ERR_FAIL_COND_V_MSG(p_mesh.is_null(), -1, "A part without a mesh.");
	const level::BlockMesh &mesh = p_mesh->core();
	std::vector<level::Vec3> albedo;
	for (std::size_t index = 0; index < mesh.indices().size(); index += 3) {
		const std::array<float, 2> &style = mesh.styles()[mesh.indices()[index]];
		albedo.push_back(_albedo(int(style[0]), int(style[1])));
	}
	const auto number = int64_t(_parts.size());
	_parts.push_back({ _light.add(mesh.points(), mesh.normals(), mesh.indices(), albedo), mesh.points().size() });
	_part_of.resize(_light.triangles().size(), int32_t(number));
	return number;
}

void LevelTracer::add_surface(const PackedVector3Array &p_points, const PackedVector3Array &p_normals,
		const PackedInt32Array &p_indices, const Color &p_colour) {
	ERR_FAIL_COND_MSG(p_normals.size() != p_points.size(), "A surface needs a normal for each point.");
	std::vector<level::Vec3> points;
	std::vector<level::Vec3> normals;
	for (const Vector3 &point : p_points) {
		points.push_back(to_core(point));
	}
	for (const Vector3 &normal : p_normals) {
		normals.push_back(to_core(normal));
	}
	for (const int32_t index : p_indices) {
		ERR_FAIL_INDEX_MSG(index, p_points.size(), "A surface has an index beyond its points.");
	}
	_light.add(points, normals, std::vector<int32_t>(p_indices.ptr(), p_indices.ptr() + p_indices.size()),
			std::vector<level::Vec3>(std::size_t(p_indices.size() / 3), colour_of(p_colour)));
	_part_of.resize(_light.triangles().size(), -1);
}

void LevelTracer::bake() {
	_light.bake();
}

double LevelTracer::get_progress() const {
	return _visibility ? _visibility->progress() : _light.progress();
}

PackedByteArray LevelTracer::get_light(int64_t p_part) const {
	ERR_FAIL_INDEX_V_MSG(p_part, int64_t(_parts.size()), PackedByteArray(), "There is no such part.");
	ERR_FAIL_COND_V_MSG(_light.vertex_count() == 0, PackedByteArray(), "Nothing is baked yet.");
	const Range &range = _parts[p_part];
	PackedByteArray bytes;
	bytes.resize(int64_t(range.count) * 3 * level::LIGHT_SETS);
	uint8_t *to = bytes.ptrw();
	for (std::size_t index = range.first; index < range.first + range.count; index++) {
		to = write_light(_light.light(index), to);
	}
	return bytes;
}

PackedByteArray LevelTracer::make_grid(
		const Vector3 &p_origin, const Vector3 &p_spacing, const Vector3i &p_counts) const {
	const int64_t count = int64_t(p_counts.x) * p_counts.y * p_counts.z;
	ERR_FAIL_COND_V_MSG(p_counts.x < 1 || p_counts.y < 1 || p_counts.z < 1 || count > MAX_POINTS, PackedByteArray(),
			"The grid of light has no points, or too many.");
	constexpr int64_t POINT_SIZE = 6 * level::LIGHT_SETS + 1;
	PackedByteArray bytes;
	bytes.resize(count * POINT_SIZE);
	uint8_t *to = bytes.ptrw();
	std::atomic<float> progress{ 0.0f };
	const level::Workers workers(_light.threads, progress);
	workers.share_out(std::size_t(count), 0.0f, 1.0f, [&](std::size_t p_first, std::size_t p_last) {
		for (std::size_t index = p_first; index < p_last; index++) {
			const std::size_t row = index / std::size_t(p_counts.x);
			const std::size_t slice = row / std::size_t(p_counts.y);
			const auto x = float(index % std::size_t(p_counts.x));
			const auto y = float(row % std::size_t(p_counts.y));
			const auto z = float(slice);
			level::Light above;
			level::Light below;
			const bool is_open = _light.gather_at(to_core(p_origin + p_spacing * Vector3(x, y, z)), above, below);
			uint8_t *at = to + index * POINT_SIZE;
			*at++ = is_open ? 1 : 0;
			write_light(below, write_light(above, at));
		}
	});
	return bytes;
}

bool LevelTracer::is_blocked(const Vector3 &p_from, const Vector3 &p_to) const {
	return _light.scene().is_blocked(to_core(p_from), to_core(p_to));
}

bool LevelTracer::survey(const Vector3 &p_origin, double p_size, const Vector3i &p_counts) {
	const int64_t count = int64_t(p_counts.x) * p_counts.y * p_counts.z;
	ERR_FAIL_COND_V_MSG(p_counts.x < 1 || p_counts.y < 1 || p_counts.z < 1 || count > MAX_CELLS || !(p_size > 0.0),
			false, "The grid of cells has none, or too many.");
	const level::CellGrid grid{ to_core(p_origin), float(p_size), { p_counts.x, p_counts.y, p_counts.z } };
	_visibility =
			std::make_unique<level::Visibility>(_light.scene(), _light.triangles(), _part_of, int(_parts.size()), grid);
	_visibility->threads = _light.threads;
	_visibility->survey();
	return true;
}

int64_t LevelTracer::get_divisions() const {
	return _visibility ? _visibility->divisions : 1;
}

PackedByteArray LevelTracer::get_seen_parts() const {
	return _visibility ? to_bytes(_visibility->parts()) : PackedByteArray();
}

PackedByteArray LevelTracer::get_seen_cells() const {
	return _visibility ? to_bytes(_visibility->cells()) : PackedByteArray();
}

void LevelTracer::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_palette", "layers", "tints"), &LevelTracer::set_palette);
	ClassDB::bind_method(D_METHOD("set_suns", "morning", "noon", "evening"), &LevelTracer::set_suns);
	ClassDB::bind_method(D_METHOD("set_effort", "rays", "bounces", "threads"), &LevelTracer::set_effort);
	ClassDB::bind_method(D_METHOD("add_lamp", "position", "colour", "range", "way", "angle"), &LevelTracer::add_lamp,
			DEFVAL(Vector3(0, -1, 0)), DEFVAL(PI));
	ClassDB::bind_method(D_METHOD("add_part", "mesh"), &LevelTracer::add_part);
	ClassDB::bind_method(D_METHOD("add_surface", "points", "normals", "indices", "colour"), &LevelTracer::add_surface);
	ClassDB::bind_method(D_METHOD("bake"), &LevelTracer::bake);
	ClassDB::bind_method(D_METHOD("get_progress"), &LevelTracer::get_progress);
	ClassDB::bind_method(D_METHOD("get_light", "part"), &LevelTracer::get_light);
	ClassDB::bind_method(D_METHOD("make_grid", "origin", "spacing", "counts"), &LevelTracer::make_grid);
	ClassDB::bind_method(D_METHOD("is_blocked", "from", "to"), &LevelTracer::is_blocked);
	ClassDB::bind_method(D_METHOD("survey", "origin", "size", "counts"), &LevelTracer::survey);
	ClassDB::bind_method(D_METHOD("get_divisions"), &LevelTracer::get_divisions);
	ClassDB::bind_method(D_METHOD("get_seen_parts"), &LevelTracer::get_seen_parts);
	ClassDB::bind_method(D_METHOD("get_seen_cells"), &LevelTracer::get_seen_cells);
}

} // namespace godot
