// SPDX-License-Identifier: MIT
#pragma once

#include "ray_scene.hpp"

#include <cstdint>

namespace level {

/// Numbers that are the same on every machine and whatever thread asks (xorshift).
class VisibilityDice {
public:
	explicit VisibilityDice(uint64_t p_seed) : _state(p_seed * 0x9E3779B97F4A7C15ULL + 0x2545F4914F6CDD1DULL) {}
	/// From 0 to below 1.
	float next() {
		_state ^= _state << 13;
		_state ^= _state >> 7;
		_state ^= _state << 17;
		return float(_state >> 40) * (1.0f / 16777216.0f);
	}
	/// Each coordinate from -1 to below 1.
	Vec3 aside() { return { 2.0f * next() - 1.0f, 2.0f * next() - 1.0f, 2.0f * next() - 1.0f }; }

private:
	uint64_t _state;
};

} // namespace level
