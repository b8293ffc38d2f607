// SPDX-License-Identifier: MIT
#include "bus/encoder.hpp"

#include "bus/bytes.hpp"

namespace xbus {

namespace {

void place_data(std::size_t p_head, const uint8_t *p_data, std::size_t p_size, uint8_t *r_bytes) {
	if (p_size > 0) {
		std::memmove(r_bytes + p_head, p_data, p_size);
	}
}

std::size_t finish_frame(std::size_t p_head, std::size_t p_size, uint8_t *r_bytes) {
	const std::size_t end = p_head + p_size;
	r_bytes[end] = uint8_t(0U - sum_bytes(r_bytes + 1, end - 1));
	return end + 1;
}

} // namespace

std::size_t write_frame(
		uint8_t p_bus_id, Message p_message, const uint8_t *p_data, std::size_t p_size, uint8_t *r_bytes) {
	if (p_size > MAX_SHORT_DATA) {
		return write_extended_frame(p_bus_id, p_message, p_data, p_size, r_bytes);
	}
	place_data(4, p_data, p_size, r_bytes);
	r_bytes[0] = PREAMBLE;
	r_bytes[1] = p_bus_id;
	r_bytes[2] = uint8_t(p_message);
	r_bytes[3] = uint8_t(p_size);
	return finish_frame(4, p_size, r_bytes);
}

std::size_t write_extended_frame(
		uint8_t p_bus_id, Message p_message, const uint8_t *p_data, std::size_t p_size, uint8_t *r_bytes) {
	if (p_size > MAX_DATA) {
		return 0;
	}
	place_data(6, p_data, p_size, r_bytes);
	r_bytes[0] = PREAMBLE;
	r_bytes[1] = p_bus_id;
	r_bytes[2] = uint8_t(p_message);
	r_bytes[3] = EXTENDED;
	write_u16(uint16_t(p_size), r_bytes + 4);
	return finish_frame(6, p_size, r_bytes);
}

} // namespace xbus
