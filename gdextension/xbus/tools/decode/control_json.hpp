// SPDX-License-Identifier: MIT
#pragma once

#include "json.hpp"

#include "bus/message.hpp"

/// "0x036008A6".
std::string hex_id(uint32_t p_id, int p_digits = 8);
/// "00ff10".
std::string hex_data(const uint8_t *p_data, std::size_t p_size);

/// Writes the data of a message without samples as members of an object: as bytes, and what they say.
void write_control(const xbus::Frame &p_frame, JsonWriter &r_json);
