// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace wire {

/// 16 log2(1 + i / 16), rounded.
constexpr uint8_t LOG16_OF_MANTISSA[16] = { 0, 1, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 15 };
/// 65536 / 2^(i / 16), rounded.
constexpr uint32_t RECIPROCAL_OF_LEVEL[16] = { 65536, 62757, 60097, 57549, 55109, 52773, 50535, 48393, 46341, 44376,
	42495, 40693, 38968, 37316, 35734, 34219 };
/// Kinds of limbs in the order of Limbs (scripts/core/limbs.gd).
constexpr uint8_t CLASS_OF_LIMB[16] = { 0, 1, 2, 3, 4, 5, 6, 4, 5, 6, 7, 8, 9, 7, 8, 9 };
/// Ages of the base that share parameters: the oldest of each step, ticks. What is older is in the last.
constexpr int AGE_STEPS = 8;
constexpr int LAST_OF_AGE_STEP[AGE_STEPS] = { 1, 2, 4, 6, 9, 14, 24, 255 };
/// Resolutions from here on use the tables for small errors.
constexpr int MIN_FINE = 1200;

} // namespace wire
