// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <cstdint>

namespace emulator {

/// Pseudo-random numbers (splitmix64) that are the same on every machine.
class Random {
public:
	explicit Random(uint64_t p_seed) : _state(p_seed) {}

	uint64_t next() {
		_state += 0x9E3779B97F4A7C15U;
		uint64_t mixed = _state;
		mixed = (mixed ^ (mixed >> 30U)) * 0xBF58476D1CE4E5B9U;
		mixed = (mixed ^ (mixed >> 27U)) * 0x94D049BB133111EBU;
		return mixed ^ (mixed >> 31U);
	}

	/// From 0 (included) to 1 (not included).
	double uniform() { return double(next() >> 11U) * 0x1p-53; }
	double between(double p_low, double p_high) { return p_low + (p_high - p_low) * uniform(); }

	/// Of mean 0 and standard deviation 1.
	double normal() {
		const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
		return radius * std::cos(6.283185307179586 * uniform());
	}

private:
	uint64_t _state;
};

} // namespace emulator
