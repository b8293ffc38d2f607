// SPDX-License-Identifier: MIT
#pragma once

#include "features.hpp"

#include <limits>
#include <vector>

namespace matching {

/// The rows of many frames, made comparable, and the search for the nearest one.
class FeatureTable {
public:
	struct Found {
		int row = -1;
		float cost = std::numeric_limits<float>::max();
	};

	/// Takes the rows over, each part weighted by how much it varies.
	void assign(const std::vector<Features> &p_rows);
	/// Makes a row comparable with those of the table.
	void scale(Features &r_row) const;
	/// The row nearest to a scaled one, of those from one up to another; one that costs `p_most` or more is none.
	Found nearest(const Features &p_row, int p_first, int p_end, float p_most) const;
	/// How far a row is from a scaled one.
	float cost(int p_row, const Features &p_of) const;
	int size() const { return int(_rows.size()); }

private:
	/// Rows that share a box: most are passed over by one comparison.
	static constexpr int BLOCK = 16;
	struct Box {
		Features least{};
		Features most{};
	};

	float _box_cost(const Box &p_box, const Features &p_row, float p_most) const;

	std::vector<Features> _rows;
	std::vector<Box> _boxes;
	Features _scales{};
};

} // namespace matching
