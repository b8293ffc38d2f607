// SPDX-License-Identifier: MIT
#include "visibility.hpp"
#include "visibility_dice.hpp"

#include <algorithm>

namespace level {

/// Looks again for what only neighbours have seen.
void Visibility::confirm(std::size_t p_first, std::size_t p_last) {
	const std::size_t count = _small.cell_count();
	for (std::size_t cell = p_first; cell < p_last; cell++) {
		Dice dice(cell + 4'000'037);
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

void Visibility::confirm_part(std::size_t p_cell, int p_part, Dice &r_dice) {
	const std::vector<Vec3> &eyes_here = _eyes[p_cell];
	const std::vector<std::size_t> &clusters = _clusters_of[p_part];
	const auto choose = [&r_dice](std::size_t p_count) { return std::size_t(r_dice.next() * float(p_count)); };
	for (int tried = 0; tried < confirming && !clusters.empty(); tried++) {
		// The higher of two, as it is what is high that is seen over others.
		const Vec3 &one = eyes_here[choose(eyes_here.size())];
		const Vec3 &two = eyes_here[choose(eyes_here.size())];
		const Vec3 &eye = one.y > two.y ? one : two;
		Vec3 normal;
		Vec3 target = point_on(_clusters[clusters[choose(clusters.size())]].triangles, r_dice, normal);
		const Vec3 second = point_on(_clusters[clusters[choose(clusters.size())]].triangles, r_dice, normal);
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

} // namespace level
