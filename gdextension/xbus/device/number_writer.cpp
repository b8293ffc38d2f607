// SPDX-License-Identifier: MIT
#include "device/number_writer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace xbus {

namespace {

/// To an integer in units of 2^-`p_bits`, of `p_width` bits in all.
int64_t to_fixed(double p_value, int p_bits, int p_width) {
	if (std::isnan(p_value)) {
		return 0;
	}
	const double limit = std::ldexp(1.0, p_width - 1);
	const double scaled = std::round(std::ldexp(p_value, p_bits));
	return int64_t(std::clamp(scaled, -limit, limit - 1.0));
}

/// To the nearest float; a finite number that is too great becomes an infinity, as the conversion of one that
/// is out of range is undefined.
float to_float(double p_value) {
	constexpr double MAX = double(std::numeric_limits<float>::max());
	if (std::fabs(p_value) <= MAX || !std::isfinite(p_value)) {
		return float(p_value);
	}
	return p_value > 0.0 ? std::numeric_limits<float>::infinity() : -std::numeric_limits<float>::infinity();
}

void write_number(NumberFormat p_format, double p_value, uint8_t *r_bytes) {
	switch (p_format) {
		case NumberFormat::FLOAT: {
			const float value = to_float(p_value);
			uint32_t bits = 0;
			std::memcpy(&bits, &value, sizeof(bits));
			write_u32(bits, r_bytes);
		} break;
		case NumberFormat::FIXED_12_20:
			write_u32(uint32_t(to_fixed(p_value, 20, 32)), r_bytes);
			break;
		case NumberFormat::FIXED_16_32: {
			const auto value = uint64_t(to_fixed(p_value, 32, 48));
			write_u32(uint32_t(value), r_bytes);
			write_u16(uint16_t(value >> 32U), r_bytes + 4);
		} break;
		case NumberFormat::DOUBLE: {
			uint64_t bits = 0;
			std::memcpy(&bits, &p_value, sizeof(bits));
			write_u64(bits, r_bytes);
		} break;
	}
}

} // namespace

std::size_t write_numbers(NumberFormat p_format, const double *p_values, std::size_t p_count, uint8_t *r_bytes) {
	const std::size_t size = number_size(p_format);
	for (std::size_t i = 0; i < p_count; i++) {
		write_number(p_format, p_values[i], r_bytes + i * size);
	}
	return p_count * size;
}

std::size_t write_field(NumberFormat p_format, const Sample &p_sample, Field p_field, uint8_t *r_bytes) {
	// Only read from here.
	const Numbers found = const_cast<Sample &>(p_sample).numbers(p_field);
	return write_numbers(p_format, found.values, found.count, r_bytes);
}

} // namespace xbus
