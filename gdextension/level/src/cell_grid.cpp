// SPDX-License-Identifier: MIT
#include "cell_grid.hpp"

namespace level {

std::array<int, 3> CellGrid::index_of(std::size_t p_cell) const {
	const auto y = int(p_cell % counts[1]);
	const auto rest = int(p_cell / counts[1]);
	return { rest / counts[2], y, rest % counts[2] };
}

std::size_t CellGrid::number_of(const std::array<int, 3> &p_index) const {
	return (std::size_t(p_index[0]) * counts[2] + p_index[2]) * counts[1] + p_index[1];
}

bool CellGrid::has(const std::array<int, 3> &p_index) const {
	for (int axis = 0; axis < 3; axis++) {
		if (p_index[axis] < 0 || p_index[axis] >= counts[axis]) {
			return false;
		}
	}
	return true;
}

} // namespace level
