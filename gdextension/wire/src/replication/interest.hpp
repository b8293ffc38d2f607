// SPDX-License-Identifier: MIT
#pragma once

#include "updates.hpp"

#include <cstddef>
#include <vector>

namespace wire {

/// Which parts of the world can be seen from which: a grid of cells (a potentially visible set, thesis
/// sections 4.2.2 and 7.2).
class Interest {
public:
	/// Most cells: their table takes this squared in bits.
	static constexpr int MAX_CELLS = 8192;
	/// Distance (m) at which half as much is sent of something.
	static constexpr float HALF_DISTANCE_M = 12.0f;
	/// What is left of the weight of something that is out of sight, or far away.
	static constexpr float HIDDEN = 0.05f;
	static constexpr float FAR = 0.1f;

	/// Sets the grid. The table has a byte for each pair of cells (from, to), in the order x, then z, then
	/// y from slow to fast; not 0 means visible. Returns false, and everything is visible, if it is none.
	bool set_cells(const Vec3 &p_origin, float p_size, const std::array<int, 3> &p_counts, const uint8_t *p_visible,
			std::size_t p_table_size);
	/// The number of the cell that a position lies in, or -1 if in none.
	int cell(const Vec3 &p_position) const;
	/// How much somebody at one position wants to know about another, 0 to 1.
	float weight(const Vec3 &p_from, const Vec3 &p_to) const;

private:
	Vec3 _origin;
	float _size = 0.0f;
	std::array<int, 3> _counts{};
	std::vector<bool> _visible;
};

} // namespace wire
