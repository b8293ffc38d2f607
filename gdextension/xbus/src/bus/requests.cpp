// SPDX-License-Identifier: MIT
#include "bus/requests.hpp"

#include "bus/bytes.hpp"

namespace xbus::host {

namespace {

Request with_data(Message p_message, const uint8_t *p_data, std::size_t p_size, uint8_t p_bus_id) {
	Request made;
	made.size = write_frame(p_bus_id, p_message, p_data, p_size, made.bytes.data());
	return made;
}

Request with_u8(Message p_message, uint8_t p_value, uint8_t p_bus_id = MASTER) {
	return with_data(p_message, &p_value, 1, p_bus_id);
}

Request with_u16(Message p_message, uint16_t p_value, uint8_t p_bus_id = MASTER) {
	std::array<uint8_t, 2> data;
	write_u16(p_value, data.data());
	return with_data(p_message, data.data(), data.size(), p_bus_id);
}

Request with_u32(Message p_message, uint32_t p_value, uint8_t p_bus_id = MASTER) {
	std::array<uint8_t, 4> data;
	write_u32(p_value, data.data());
	return with_data(p_message, data.data(), data.size(), p_bus_id);
}

} // namespace

Request request(Message p_message, uint8_t p_bus_id) {
	return with_data(p_message, nullptr, 0, p_bus_id);
}

Request wake_up_ack() {
	return request(Message::WAKE_UP_ACK);
}

Request reset() {
	return request(Message::RESET);
}

Request go_to_config() {
	return request(Message::GO_TO_CONFIG);
}

Request go_to_measurement() {
	return request(Message::GO_TO_MEASUREMENT);
}

Request request_device_id(uint8_t p_bus_id) {
	return request(Message::REQ_DEVICE_ID, p_bus_id);
}

Request init_bus() {
	return request(Message::INIT_BUS);
}

Request set_bus_power(bool p_on) {
	return with_u16(Message::BUS_POWER, p_on ? 1 : 0);
}

Request request_configuration() {
	return request(Message::REQ_CONFIGURATION);
}

Request request_data_length(uint8_t p_bus_id) {
	return request(Message::REQ_DATA_LENGTH, p_bus_id);
}

Request set_period(uint16_t p_ticks) {
	return with_u16(Message::SET_PERIOD, p_ticks);
}

Request set_baud_rate(uint8_t p_code) {
	return with_u8(Message::SET_BAUD_RATE, p_code);
}

Request request_battery_level() {
	return request(Message::REQ_BATTERY_LEVEL);
}

Request set_output_mode(uint16_t p_mode, uint8_t p_bus_id) {
	return with_u16(Message::SET_OUTPUT_MODE, p_mode, p_bus_id);
}

Request set_output_settings(uint32_t p_settings, uint8_t p_bus_id) {
	return with_u32(Message::SET_OUTPUT_SETTINGS, p_settings, p_bus_id);
}

Request set_skip_factor(uint16_t p_factor, uint8_t p_bus_id) {
	return with_u16(Message::SET_OUTPUT_SKIP_FACTOR, p_factor, p_bus_id);
}

Request set_output_configuration(const OutputRequest *p_outputs, std::size_t p_count, uint8_t p_bus_id) {
	std::array<uint8_t, Request::MAX_OUTPUTS * 4> data;
	const std::size_t size = write_output_configuration(p_outputs, p_count, data.data(), data.size());
	return with_data(Message::SET_OUTPUT_CONFIGURATION, data.data(), size, p_bus_id);
}

} // namespace xbus::host
