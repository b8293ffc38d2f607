// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace level {

/// The most light that the coding holds.
constexpr float MAX_LIGHT = 2.0f;

/// Light as a byte: the cube root, as the eye tells dark shades apart much better than bright ones.
inline uint8_t encode_light(float p_light) {
	return uint8_t(std::lround(std::cbrt(std::clamp(p_light, 0.0f, MAX_LIGHT) / MAX_LIGHT) * 255.0f));
}

/// Light of a byte.
inline float decode_light(uint8_t p_byte) {
	const float root = float(p_byte) / 255.0f;
	return root * root * root * MAX_LIGHT;
}

} // namespace level
