// SPDX-License-Identifier: MIT
#include "light_grid.hpp"
#include "light_coding.hpp"

#include <algorithm>
#include <cmath>

namespace level {

namespace {

/// Points inside walls take the light of the air beside them, so often at most.
constexpr int WALL_FILL_ROUNDS = 3;

} // namespace

bool LightGrid::set_points(const uint8_t *p_bytes, std::size_t p_size, const std::array<int, 3> &p_counts) {
	std::size_t points = 1;
	for (const int count : p_counts) {
		if (count < 1 || count > 4096) {
			return false;
		}
		points *= std::size_t(count);
	}
	if (p_size != points * POINT_SIZE) {
		return false;
	}
	_counts = p_counts;
	_bytes.assign(p_bytes, p_bytes + p_size);
	fill_solid();
	return true;
}

/// Between points the light is mixed: what is inside a wall must not darken the room beside it.
void LightGrid::fill_solid() {
	const std::array<std::size_t, 3> steps{ 1, std::size_t(_counts[0]), std::size_t(_counts[0]) * _counts[1] };
	for (int round = 0; round < WALL_FILL_ROUNDS; round++) {
		const std::vector<uint8_t> before = _bytes;
		for (std::size_t point = 0; point < size(); point++) {
			if (before[point * POINT_SIZE] != 0) {
				continue;
			}
			std::array<int, POINT_SIZE> sums{};
			int found = 0;
			for (int axis = 0; axis < 3; axis++) {
				const int at = int(point / steps[axis] % _counts[axis]);
				for (int way = -1; way <= 1; way += 2) {
					if (at + way < 0 || at + way >= _counts[axis]) {
						continue;
					}
					const uint8_t *other = before.data() + (point + std::size_t(way) * steps[axis]) * POINT_SIZE;
					if (other[0] == 0) {
						continue;
					}
					found++;
					for (std::size_t index = 1; index < POINT_SIZE; index++) {
						sums[index] += other[index];
					}
				}
			}
			if (found > 0) {
				_bytes[point * POINT_SIZE] = 1;
				for (std::size_t index = 1; index < POINT_SIZE; index++) {
					_bytes[point * POINT_SIZE + index] = uint8_t(sums[index] / found);
				}
			}
		}
	}
}

void LightGrid::sum_up(std::size_t p_point, const Light &p_strengths, Vec3 &r_above, Vec3 &r_below) const {
	const uint8_t *above = _bytes.data() + p_point * POINT_SIZE + 1;
	const uint8_t *below = above + 3 * LIGHT_SETS;
	for (int set = 0; set < LIGHT_SETS; set++, above += 3, below += 3) {
		r_above = r_above +
				Vec3{ decode_light(above[0]), decode_light(above[1]), decode_light(above[2]) }.scaled(p_strengths[set]);
		r_below = r_below +
				Vec3{ decode_light(below[0]), decode_light(below[1]), decode_light(below[2]) }.scaled(p_strengths[set]);
	}
}

void LightGrid::combine(const Light &p_strengths, uint8_t *r_texels) const {
	for (std::size_t point = 0; point < size(); point++) {
		Vec3 above;
		Vec3 below;
		sum_up(point, p_strengths, above, below);
		const Vec3 mean = (above + below) * 0.5f;
		const float all = above.x + above.y + above.z + below.x + below.y + below.z;
		const float share = all > 1e-6f ? (above.x + above.y + above.z) / all : 0.5f;
		*r_texels++ = encode_light(mean.x);
		*r_texels++ = encode_light(mean.y);
		*r_texels++ = encode_light(mean.z);
		*r_texels++ = uint8_t(std::lround(share * 255.0f));
	}
}

Vec3 LightGrid::mean_at(const Vec3 &p_place, const Light &p_strengths) const {
	if (_bytes.empty() || !p_place.is_finite()) {
		return {};
	}
	const auto index = [&](float p_at, int p_axis) {
		return std::size_t(std::clamp(p_at + 0.5f, 0.0f, float(_counts[p_axis] - 1)));
	};
	const std::size_t point =
			(index(p_place.z, 2) * _counts[1] + index(p_place.y, 1)) * _counts[0] + index(p_place.x, 0);
	Vec3 above;
	Vec3 below;
	sum_up(point, p_strengths, above, below);
	return (above + below) * 0.5f;
}

} // namespace level
