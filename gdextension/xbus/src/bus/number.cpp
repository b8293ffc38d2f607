// SPDX-License-Identifier: MIT
#include "bus/number.hpp"

namespace xbus {

void read_numbers(NumberFormat p_format, const uint8_t *p_bytes, std::size_t p_count, double *r_values) {
	switch (p_format) {
		case NumberFormat::FLOAT:
			for (std::size_t i = 0; i < p_count; i++) {
				r_values[i] = read_float(p_bytes + i * 4);
			}
			break;
		case NumberFormat::FIXED_12_20:
			for (std::size_t i = 0; i < p_count; i++) {
				r_values[i] = read_fixed_12_20(p_bytes + i * 4);
			}
			break;
		case NumberFormat::FIXED_16_32:
			for (std::size_t i = 0; i < p_count; i++) {
				r_values[i] = read_fixed_16_32(p_bytes + i * 6);
			}
			break;
		case NumberFormat::DOUBLE:
			for (std::size_t i = 0; i < p_count; i++) {
				r_values[i] = read_double(p_bytes + i * 8);
			}
			break;
	}
}

} // namespace xbus
