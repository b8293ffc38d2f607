// SPDX-License-Identifier: MIT
#pragma once

#include "light_tracer.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace level {

/// Light in the air at the points of a grid, for what moves: made from what a bake holds, summed for
/// the strengths that the five sources have now.
class LightGrid {
public:
	/// Bytes of a point: 1 in the air and 0 inside something, then light from above and from below.
	static constexpr std::size_t POINT_SIZE = 6 * LIGHT_SETS + 1;

	/// Takes the points, x fastest, then y, then z. Returns false if the sizes do not fit.
	bool set_points(const uint8_t *p_bytes, std::size_t p_size, const std::array<int, 3> &p_counts);
	/// Sums the sources with their strengths (linear RGB). Four bytes for each point: the mean of light
	/// from above and below, in the coding of light_coding.hpp, and the share that comes from above.
	void combine(const Light &p_strengths, uint8_t *r_texels) const;
	/// Mean light at a place, in distances of the points from the first one; the nearest point inside the
	/// grid is taken.
	Vec3 mean_at(const Vec3 &p_place, const Light &p_strengths) const;
	std::size_t size() const { return _bytes.size() / POINT_SIZE; }

private:
	void fill_solid();
	void sum_up(std::size_t p_point, const Light &p_strengths, Vec3 &r_above, Vec3 &r_below) const;

	std::array<int, 3> _counts{};
	std::vector<uint8_t> _bytes;
};

} // namespace level
