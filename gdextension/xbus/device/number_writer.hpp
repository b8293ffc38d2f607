// SPDX-License-Identifier: MIT
#pragma once

#include "bus/number.hpp"
#include "bus/sample.hpp"

namespace xbus {

/// Writes so many numbers, rounded to the nearest and kept within what the format can hold (a fixed-point NaN
/// is 0), and returns the bytes written.
std::size_t write_numbers(NumberFormat p_format, const double *p_values, std::size_t p_count, uint8_t *r_bytes);

/// The same of a sample's field; 0 if it is none of real numbers.
std::size_t write_field(NumberFormat p_format, const Sample &p_sample, Field p_field, uint8_t *r_bytes);

} // namespace xbus
