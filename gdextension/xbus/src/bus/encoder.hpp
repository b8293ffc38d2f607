// SPDX-License-Identifier: MIT
#pragma once

#include "bus/message.hpp"

namespace xbus {

/// Writes one message, in the extended form where it has more than 254 data bytes, and returns how many bytes
/// were written: at most `p_size` + 7. Returns 0 if `p_size` is more than MAX_DATA. `p_data` may be null if
/// there is none, and may overlap with `r_bytes`.
std::size_t write_frame(
		uint8_t p_bus_id, Message p_message, const uint8_t *p_data, std::size_t p_size, uint8_t *r_bytes);

/// The same, always in the extended form, which a receiver has to take for short messages as well.
std::size_t write_extended_frame(
		uint8_t p_bus_id, Message p_message, const uint8_t *p_data, std::size_t p_size, uint8_t *r_bytes);

/// Bytes of a message with so many data bytes.
constexpr std::size_t frame_size(std::size_t p_data_size) {
	return p_data_size + (p_data_size > MAX_SHORT_DATA ? 7 : 5);
}

} // namespace xbus
