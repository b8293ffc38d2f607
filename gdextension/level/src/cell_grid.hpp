// SPDX-License-Identifier: MIT
#pragma once

#include "ray_scene.hpp"

#include <array>
#include <cstddef>

namespace level {

/// A grid of cubes. Cells are in the order x, then z, then y from slow to fast, as in snapshots'
/// interest.
struct CellGrid {
	Vec3 origin;
	/// Edge of a cell, m.
	float size = 4.0f;
	/// Cells along x, y and z.
	std::array<int, 3> counts{ 0, 0, 0 };

	std::size_t cell_count() const { return std::size_t(counts[0]) * counts[1] * counts[2]; }
	std::array<int, 3> index_of(std::size_t p_cell) const;
	std::size_t number_of(const std::array<int, 3> &p_index) const;
	bool has(const std::array<int, 3> &p_index) const;
};

} // namespace level
