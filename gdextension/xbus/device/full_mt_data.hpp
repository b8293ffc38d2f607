// SPDX-License-Identifier: MIT
#pragma once

#include "bus/mt_data.hpp"
#include "device/full_sample.hpp"

// MTData with everything that it holds, read and written.

namespace xbus {

/// Decodes the block of one tracker that stands alone, of exactly the size given; false if it is not.
bool decode_data(const OutputFormat &p_format, const uint8_t *p_data, std::size_t p_size, FullSample &r_sample);
/// Decodes a master's message into as many samples as there are trackers; false if its size is not exactly right.
bool decode_data(const MasterFormat &p_format, const uint8_t *p_data, std::size_t p_size, FullSample *r_samples);

/// Writes the block of one tracker and returns its size; `p_with_time`: as one that stands alone.
std::size_t write_block(const OutputFormat &p_format, const FullSample &p_sample, bool p_with_time, uint8_t *r_bytes);
/// Writes the data of a master's message and returns its size; there is room for p_format.size().
std::size_t write_data(const MasterFormat &p_format, uint16_t p_counter, const FullSample *p_samples, uint8_t *r_bytes);

} // namespace xbus
