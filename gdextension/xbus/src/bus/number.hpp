// SPDX-License-Identifier: MIT
#pragma once

#include "bus/bytes.hpp"

namespace xbus {

/// How a real number lies on the bus.
enum class NumberFormat : uint8_t {
	/// IEEE 754, 4 bytes.
	FLOAT = 0,
	/// 32-bit integer in units of 2^-20.
	FIXED_12_20 = 1,
	/// 4 bytes of fraction in units of 2^-32, then a 16-bit integer part.
	FIXED_16_32 = 2,
	/// IEEE 754, 8 bytes.
	DOUBLE = 3,
};

/// Bytes of one number.
constexpr std::size_t number_size(NumberFormat p_format) {
	return p_format == NumberFormat::DOUBLE ? 8 : (p_format == NumberFormat::FIXED_16_32 ? 6 : 4);
}

inline double read_float(const uint8_t *p_bytes) {
	const uint32_t bits = read_u32(p_bytes);
	float value = 0.0F;
	std::memcpy(&value, &bits, sizeof(value));
	return double(value);
}

inline double read_double(const uint8_t *p_bytes) {
	const uint64_t bits = read_u64(p_bytes);
	double value = 0.0;
	std::memcpy(&value, &bits, sizeof(value));
	return value;
}

inline double read_fixed_12_20(const uint8_t *p_bytes) {
	return double(read_i32(p_bytes)) / double(1U << 20U);
}

inline double read_fixed_16_32(const uint8_t *p_bytes) {
	return double(int16_t(read_u16(p_bytes + 4))) + double(read_u32(p_bytes)) / 4294967296.0;
}

/// Reads so many numbers, exactly: a double holds every value of every format.
void read_numbers(NumberFormat p_format, const uint8_t *p_bytes, std::size_t p_count, double *r_values);

} // namespace xbus
