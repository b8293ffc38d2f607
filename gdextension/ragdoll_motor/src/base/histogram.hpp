// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace ragdoll {

/// Counts values from 0 on in bins of equal width; what is beyond the last bin, or no number, is in that.
template <std::size_t BINS>
class Histogram {
public:
	/// @param p_value in widths of a bin
	void add(double p_value) {
		_bins[std::size_t(std::fmax(std::fmin(p_value, double(BINS - 1)), 0.0))]++;
		_count++;
	}
	/// How many values there are.
	std::uint64_t get_count() const { return _count; }
	/// The bin up to whose end that part of the values lies; -1 where there are none.
	int find(double p_fraction) const {
		std::uint64_t below = 0;
		for (std::size_t i = 0; i < BINS; i++) {
			below += _bins[i];
			if (below > 0 && double(below) >= p_fraction * double(_count)) {
				return int(i);
			}
		}
		return -1;
	}
	void clear() { *this = Histogram(); }

private:
	std::array<std::uint64_t, BINS> _bins{};
	std::uint64_t _count = 0;
};

} // namespace ragdoll
