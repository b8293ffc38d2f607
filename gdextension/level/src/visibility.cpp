// SPDX-License-Identifier: MIT
#include "visibility.hpp"
#include "directions.hpp"
#include "workers.hpp"

#include <algorithm>
#include <cmath>

namespace level {

namespace {

/// Rays that tell whether a point is inside something.
constexpr std::array<Vec3, 4> PROBES{ Vec3{ 0.11f, 1.0f, 0.07f }, Vec3{ 1.0f, 0.13f, 0.05f },
	Vec3{ -0.6f, 0.21f, 0.7f }, Vec3{ -0.3f, 0.17f, -0.9f } };

/// How far the ends of rays that follow another are from its own, in turn, m, and their beginnings.
constexpr std::array<float, 3> ASIDE_M{ 0.3f, 0.8f, 2.0f };
constexpr float NUDGE_M = 0.1f;
/// What a ray meets of a part within cubes of this edge is the same find, m.
constexpr float KNOWN_M = 4.0f;
/// Where a floor is no further below, somebody may stand, m.
constexpr float STANDING_M = 2.2f;

} // namespace

Visibility::Visibility(const RayScene &p_scene, const std::vector<Triangle> &p_triangles,
		const std::vector<int32_t> &p_part_of, int p_parts, const CellGrid &p_grid) :
		_scene(p_scene), _triangles(p_triangles), _part_of(p_part_of), _parts(p_parts), _grid(p_grid) {}

bool Visibility::is_inside(const Vec3 &p_point) const {
	int backs = 0;
	for (const Vec3 &way : PROBES) {
		backs += _scene.closest(p_point, way, farthest).is_back ? 1 : 0;
	}
	return backs >= 3;
}

bool Visibility::has_floor(const Vec3 &p_point) const {
	return _scene.closest(p_point, { 0.0f, -1.0f, 0.0f }, STANDING_M).triangle != Hit::NOTHING;
}

void Visibility::choose_eyes(std::size_t p_first, std::size_t p_last) {
	for (std::size_t cell = p_first; cell < p_last; cell++) {
		VisibilityDice dice(cell + 1);
		const std::array<int, 3> index = _small.index_of(cell);
		const Vec3 corner = _small.origin + Vec3{ float(index[0]), float(index[1]), float(index[2]) } * _small.size;
		bool is_aloft = true;
		for (int tried = 0; tried < 2 * eyes && int(_eyes[cell].size()) < (is_aloft ? eyes_aloft : eyes); tried++) {
			const Vec3 point = corner + Vec3{ dice.next(), dice.next(), dice.next() } * _small.size;
			if (!is_inside(point)) {
				_eyes[cell].push_back(point);
				is_aloft = is_aloft && !has_floor(point);
			}
		}
	}
}

std::size_t Visibility::large_of(std::size_t p_small) const {
	const std::array<int, 3> index = _small.index_of(p_small);
	return _grid.number_of({ index[0] / divisions, index[1] / divisions, index[2] / divisions });
}

void Visibility::gather_points() {
	_points.assign(_grid.cell_count(), {});
	for (std::size_t small = 0; small < _small.cell_count(); small++) {
		std::vector<Vec3> &here = _points[large_of(small)];
		here.insert(here.end(), _eyes[small].begin(), _eyes[small].end());
	}
	for (std::size_t cell = 0; cell < _points.size(); cell++) {
		_open[cell] = _points[cell].empty() ? 0 : 1;
	}
}

/// Notes the cells that a ray crosses.
void Visibility::note_crossed(std::size_t p_cell, const Vec3 &p_from, const Vec3 &p_to) {
	const Vec3 way = p_to - p_from;
	const int steps = int(way.length() / (0.5f * _grid.size)) + 1;
	std::atomic<uint8_t> *row = &_cell_marks[p_cell * _grid.cell_count()];
	for (int step = 0; step <= steps; step++) {
		const Vec3 at = (p_from + way * (float(step) / float(steps)) - _grid.origin) * (1.0f / _grid.size);
		const std::array<int, 3> index{ int(std::floor(at.x)), int(std::floor(at.y)), int(std::floor(at.z)) };
		if (!_grid.has(index)) {
			return;
		}
		std::atomic<uint8_t> &mark = row[_grid.number_of(index)];
		if (mark.load(std::memory_order_relaxed) == 0) {
			mark.store(1, std::memory_order_relaxed);
		}
	}
}

/// Notes that a part is seen from every small cell between two points.
void Visibility::note_part(int p_part, const Vec3 &p_from, const Vec3 &p_to) {
	const Vec3 way = p_to - p_from;
	const int steps = int(way.length() / (0.4f * _small.size)) + 1;
	for (int step = 0; step <= steps; step++) {
		const Vec3 at = (p_from + way * (float(step) / float(steps)) - _small.origin) * (1.0f / _small.size);
		const std::array<int, 3> index{ int(std::floor(at.x)), int(std::floor(at.y)), int(std::floor(at.z)) };
		if (_small.has(index)) {
			std::atomic<uint8_t> &mark = _part_marks[p_part * _small.cell_count() + _small.number_of(index)];
			if (mark.load(std::memory_order_relaxed) == 0) {
				mark.store(1, std::memory_order_relaxed);
			}
		}
	}
}

/// Traces a ray from an eye and notes the part that it meets; one that meets what none from this cell has met
/// is kept, to be followed.
void Visibility::look_along(const Vec3 &p_eye, const Vec3 &p_way, Finds &r_finds) {
	const Hit hit = _scene.closest(p_eye, p_way, farthest);
	r_finds.length = hit.triangle != Hit::NOTHING ? hit.distance : farthest;
	if (hit.triangle == Hit::NOTHING || _part_of[hit.triangle] < 0) {
		return;
	}
	const int part = _part_of[hit.triangle];
	const Vec3 point = p_eye + p_way * (hit.distance - 0.02f);
	note_part(part, p_eye, point);
	const Vec3 cube = point * (1.0f / KNOWN_M);
	// 16 bits for each: worlds are smaller than 2^15 cubes.
	const auto part_of_key = [](int p_number) { return uint64_t(uint16_t(p_number)); };
	const uint64_t key = part_of_key(part) << 48 | part_of_key(int(std::floor(cube.x))) << 32 |
			part_of_key(int(std::floor(cube.y))) << 16 | part_of_key(int(std::floor(cube.z)));
	if (r_finds.known.insert(key).second) {
		r_finds.sights.push_back({ p_eye, point });
	}
}

/// Sends rays close to those that have found something new, and to those of them that do: so the edges of
/// what is seen are searched (after Wonka et al., "Guided Visibility Sampling", 2006).
void Visibility::follow(Finds &r_finds, VisibilityDice &r_dice) {
	for (int left = most_followers; left > 0 && !r_finds.sights.empty();) {
		const Sight sight = r_finds.sights.back();
		r_finds.sights.pop_back();
		for (int number = 0; number < followers; number++, left--) {
			const float aside = ASIDE_M[std::size_t(number) % ASIDE_M.size()];
			// Still in the same air, or nearly so.
			const Vec3 from = sight.from + r_dice.aside() * NUDGE_M;
			const Vec3 way = sight.to + r_dice.aside() * aside - from;
			const float length = way.length();
			if (length > 0.01f) {
				look_along(from, way * (1.0f / length), r_finds);
			}
		}
	}
}

/// Looks from the small cells to all sides.
void Visibility::look(std::size_t p_first, std::size_t p_last) {
	const std::vector<Vec3> ways = sphere(shower);
	for (std::size_t cell = p_first; cell < p_last; cell++) {
		VisibilityDice dice(cell + 1'000'003);
		const std::size_t large = large_of(cell);
		Finds finds;
		for (const Vec3 &eye : _eyes[cell]) {
			const float turn = 6.2831853f * dice.next();
			const float cosine = std::cos(turn);
			const float sine = std::sin(turn);
			for (const Vec3 &each : ways) {
				// More of them level, as that is where things are.
				const float y = each.y * std::fabs(each.y);
				const float flat = std::sqrt((1.0f - y * y) / std::max(1.0f - each.y * each.y, 1e-6f));
				const Vec3 way{ (each.x * cosine - each.z * sine) * flat, y, (each.x * sine + each.z * cosine) * flat };
				look_along(eye, way, finds);
				note_crossed(large, eye, eye + way * finds.length);
			}
		}
		follow(finds, dice);
	}
}

/// Looks from parts to all sides.
void Visibility::look_out(std::size_t p_first, std::size_t p_last) {
	for (std::size_t number = p_first; number < p_last; number++) {
		VisibilityDice dice(number + 3'000'017);
		const PartSurfaces::Cluster &cluster = _surfaces.clusters()[number];
		// Small parts are missed most easily.
		const int rays = std::max(cluster_rays, part_rays / int(_surfaces.clusters_of(cluster.part).size()));
		for (int ray = 0; ray < rays; ray++) {
			Vec3 normal;
			const Vec3 point = _surfaces.choose_point(cluster, dice, normal);
			const float y = 2.0f * dice.next() - 1.0f;
			// More of them level, as that is where eyes are.
			const float height = y * std::fabs(y);
			const float turn = 6.2831853f * dice.next();
			const float flat = std::sqrt(1.0f - height * height);
			Vec3 way{ std::cos(turn) * flat, height, std::sin(turn) * flat };
			if (way.dot(normal) < 0.0f) {
				way = way * -1.0f;
			}
			const Vec3 from = point + way * 0.005f;
			const Hit hit = _scene.closest(from, way, farthest);
			const float length = hit.triangle != Hit::NOTHING ? hit.distance : farthest;
			note_part(cluster.part, from, from + way * length);
		}
	}
}

/// Looks again for what only neighbours have seen.
void Visibility::confirm(std::size_t p_first, std::size_t p_last) {
	const std::size_t count = _small.cell_count();
	for (std::size_t cell = p_first; cell < p_last; cell++) {
		VisibilityDice dice(cell + 4'000'037);
		const std::array<int, 3> index = _small.index_of(cell);
		for (int part = 0; part < _parts && !_eyes[cell].empty(); part++) {
			const uint8_t *known = &_known[part * count];
			bool is_near = false;
			for (int side = 0; side < 6 && known[cell] == 0 && !is_near; side++) {
				std::array<int, 3> other = index;
				other[side / 2] += side % 2 == 0 ? -1 : 1;
				is_near = _small.has(other) && known[_small.number_of(other)] != 0;
			}
			if (is_near) {
				confirm_part(cell, part, dice);
			}
		}
	}
}

void Visibility::confirm_part(std::size_t p_cell, int p_part, VisibilityDice &r_dice) {
	const std::vector<Vec3> &eyes_here = _eyes[p_cell];
	const std::vector<std::size_t> &clusters = _surfaces.clusters_of(p_part);
	const auto choose = [&r_dice](std::size_t p_count) { return std::size_t(r_dice.next() * float(p_count)); };
	for (int tried = 0; tried < confirming && !clusters.empty(); tried++) {
		// The higher of two, as it is what is high that is seen over others.
		const Vec3 &one = eyes_here[choose(eyes_here.size())];
		const Vec3 &two = eyes_here[choose(eyes_here.size())];
		const Vec3 &eye = one.y > two.y ? one : two;
		const auto choose_target = [&] {
			Vec3 normal;
			return _surfaces.choose_point(_surfaces.clusters()[clusters[choose(clusters.size())]], r_dice, normal);
		};
		Vec3 target = choose_target();
		const Vec3 second = choose_target();
		target = second.y > target.y ? second : target;
		const Vec3 way = target - eye;
		const float length = way.length();
		if (!(length > 0.01f)) {
			continue;
		}
		const Hit hit = _scene.closest(eye, way * (1.0f / length), std::min(farthest, length + 0.05f));
		if (hit.triangle != Hit::NOTHING && _part_of[hit.triangle] == p_part) {
			note_part(p_part, eye, target);
			return;
		}
	}
}

/// Makes up for what the rays have missed: a small cell sees what those see that it has a side in common
/// with and that it looks into.
void Visibility::widen(std::size_t p_first, std::size_t p_last) {
	for (std::size_t cell = p_first; cell < p_last; cell++) {
		uint8_t *row = &_part_seen[cell * _parts];
		for (int part = 0; part < _parts; part++) {
			row[part] = _part_marks[part * _small.cell_count() + cell];
		}
		const std::array<int, 3> index = _small.index_of(cell);
		for (int side = 0; side < 4; side++) {
			std::array<int, 3> other = index;
			// Not up and down: from above the eyes' height one looks over much.
			other[side < 2 ? 0 : 2] += side % 2 == 0 ? -1 : 1;
			if (!_small.has(other) || !looks_into(cell, _small.number_of(other))) {
				continue;
			}
			const std::size_t neighbour = _small.number_of(other);
			for (int part = 0; part < _parts; part++) {
				row[part] |= _part_marks[part * _small.cell_count() + neighbour];
			}
		}
	}
}

bool Visibility::looks_into(std::size_t p_cell, std::size_t p_other) const {
	for (const Vec3 &eye : _eyes[p_cell]) {
		for (const Vec3 &target : _eyes[p_other]) {
			if (!_scene.is_blocked(eye, target)) {
				return true;
			}
		}
	}
	return false;
}

void Visibility::look_at_cells(std::size_t p_first, std::size_t p_last) {
	const std::size_t count = _grid.cell_count();
	for (std::size_t from = p_first; from < p_last; from++) {
		VisibilityDice dice(from + 2'000'003);
		for (std::size_t to = from + 1; to < count; to++) {
			std::atomic<uint8_t> &seen = _cell_marks[from * count + to];
			const std::vector<Vec3> &here = _points[from];
			const std::vector<Vec3> &there = _points[to];
			for (int tried = 0; tried < cell_tries && seen.load(std::memory_order_relaxed) == 0; tried++) {
				if (here.empty() || there.empty()) {
					break;
				}
				const Vec3 &eye = here[std::size_t(dice.next() * float(here.size()))];
				const Vec3 &target = there[std::size_t(dice.next() * float(there.size()))];
				seen.store(_scene.is_blocked(eye, target) ? 0 : 1, std::memory_order_relaxed);
			}
		}
	}
}

/// Sums up what was found; sight between cells is mutual.
void Visibility::finish() {
	const std::size_t count = _grid.cell_count();
	_cell_seen.assign(count * count, 0);
	for (std::size_t from = 0; from < count; from++) {
		_cell_seen[from * count + from] = 1;
		for (std::size_t to = from + 1; to < count; to++) {
			const uint8_t seen = _cell_marks[from * count + to] | _cell_marks[to * count + from];
			_cell_seen[from * count + to] = seen;
			_cell_seen[to * count + from] = seen;
		}
	}
}

void Visibility::survey() {
	const std::size_t count = _grid.cell_count();
	_small = _grid;
	_small.size = _grid.size / float(divisions);
	for (int &along : _small.counts) {
		along *= divisions;
	}
	const std::size_t small_count = _small.cell_count();
	_part_marks = Marks(small_count * _parts);
	_part_seen.assign(small_count * _parts, 0);
	_cell_marks = Marks(count * count);
	_open.assign(count, 0);
	_eyes.assign(small_count, {});
	_surfaces = PartSurfaces(_triangles, _part_of, _parts, cluster_m);
	const Workers workers(threads, _progress);
	const auto share = [&](std::size_t p_count, float p_from, float p_to,
							   void (Visibility::*p_work)(std::size_t, std::size_t)) {
		workers.share_out(p_count, p_from, p_to,
				[&](std::size_t p_first, std::size_t p_last) { (this->*p_work)(p_first, p_last); });
	};
	share(small_count, 0.0f, 0.05f, &Visibility::choose_eyes);
	gather_points();
	share(small_count, 0.05f, 0.6f, &Visibility::look);
	share(_surfaces.clusters().size(), 0.6f, 0.75f, &Visibility::look_out);
	for (int round = 0; round < rounds; round++) {
		_known.resize(_part_marks.size());
		std::transform(_part_marks.begin(), _part_marks.end(), _known.begin(),
				[](const std::atomic<uint8_t> &p_mark) { return p_mark.load(std::memory_order_relaxed); });
		share(small_count, 0.75f, 0.85f, &Visibility::confirm);
	}
	share(small_count, 0.85f, 0.9f, &Visibility::widen);
	share(count, 0.9f, 0.98f, &Visibility::look_at_cells);
	finish();
	_progress = 1.0f;
}

} // namespace level
