// SPDX-License-Identifier: MIT
#pragma once

#include "motion_clip.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace matching {

/// The bytes of a set's recorded clips ("motionset" file, version 1, little-endian; layout in motion_file.cpp).
std::vector<uint8_t> write_motion_file(const std::vector<Clip> &p_clips);

/// Reads them; returns what is wrong with them in one sentence, or an empty text.
std::string read_motion_file(const uint8_t *p_bytes, std::size_t p_size, std::vector<Clip> &r_clips);

} // namespace matching
