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

uint32_t float_bits(float p_value) {
	uint32_t bits = 0;
	static_assert(sizeof(bits) == sizeof(p_value));
	std::memcpy(&bits, &p_value, sizeof(bits));
	return bits;
}

} // namespace

Request request(Message p_message, uint8_t p_bus_id) {
	return with_data(p_message, nullptr, 0, p_bus_id);
}

Request with_u8(Message p_message, uint8_t p_value, uint8_t p_bus_id) {
	return with_data(p_message, &p_value, 1, p_bus_id);
}

Request with_u16(Message p_message, uint16_t p_value, uint8_t p_bus_id) {
	std::array<uint8_t, 2> data;
	write_u16(p_value, data.data());
	return with_data(p_message, data.data(), data.size(), p_bus_id);
}

Request with_u32(Message p_message, uint32_t p_value, uint8_t p_bus_id) {
	std::array<uint8_t, 4> data;
	write_u32(p_value, data.data());
	return with_data(p_message, data.data(), data.size(), p_bus_id);
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

Request request_bus_power() {
	return request(Message::BUS_POWER);
}

Request set_bus_power(bool p_on) {
	return with_u16(Message::BUS_POWER, p_on ? 1 : 0);
}

Request set_bus_id(uint8_t p_new, uint8_t p_bus_id) {
	return with_u8(Message::SET_BUS_ID, p_new, p_bus_id);
}

Request auto_start() {
	return request(Message::AUTO_START);
}

Request request_configuration() {
	return request(Message::REQ_CONFIGURATION);
}

Request request_data_length(uint8_t p_bus_id) {
	return request(Message::REQ_DATA_LENGTH, p_bus_id);
}

Request restore_factory_defaults(uint8_t p_bus_id) {
	return request(Message::RESTORE_FACTORY_DEFAULTS, p_bus_id);
}

Request request_period() {
	return request(Message::SET_PERIOD);
}

Request set_period(uint16_t p_ticks) {
	return with_u16(Message::SET_PERIOD, p_ticks);
}

Request request_firmware_revision(uint8_t p_bus_id) {
	return request(Message::REQ_FIRMWARE_REVISION, p_bus_id);
}

Request request_product_code(uint8_t p_bus_id) {
	return request(Message::REQ_PRODUCT_CODE, p_bus_id);
}

Request request_hardware_version(uint8_t p_bus_id) {
	return request(Message::REQ_HARDWARE_VERSION, p_bus_id);
}

Request request_bluetooth_disabled() {
	return request(Message::DISABLE_BLUETOOTH);
}

Request set_bluetooth_disabled(bool p_disabled) {
	return with_u8(Message::DISABLE_BLUETOOTH, p_disabled ? 1 : 0);
}

Request request_operating_mode() {
	return request(Message::OPERATING_MODE);
}

Request set_operating_mode(uint8_t p_mode) {
	return with_u8(Message::OPERATING_MODE, p_mode);
}

Request request_baud_rate() {
	return request(Message::SET_BAUD_RATE);
}

Request set_baud_rate(uint8_t p_code) {
	return with_u8(Message::SET_BAUD_RATE, p_code);
}

Request request_sync_mode() {
	return request(Message::SET_SYNC_MODE);
}

Request set_sync_mode(SyncMode p_mode) {
	return with_u8(Message::SET_SYNC_MODE, uint8_t(p_mode));
}

Request request_xm_error_mode() {
	return request(Message::XM_ERROR_MODE);
}

Request set_xm_error_mode(uint16_t p_mode) {
	return with_u16(Message::XM_ERROR_MODE, p_mode);
}

Request request_buffer_size() {
	return request(Message::BUFFER_SIZE);
}

Request set_buffer_size(uint16_t p_size) {
	return with_u16(Message::BUFFER_SIZE, p_size);
}

Request request_battery_level() {
	return request(Message::REQ_BATTERY_LEVEL);
}

Request switch_off() {
	return request(Message::XM_POWER_OFF);
}

Request request_data(uint8_t p_bus_id) {
	return request(Message::REQ_DATA, p_bus_id);
}

Request request_heading(uint8_t p_bus_id) {
	return request(Message::HEADING, p_bus_id);
}

Request set_heading(float p_degrees, uint8_t p_bus_id) {
	return with_u32(Message::HEADING, float_bits(p_degrees), p_bus_id);
}

Request request_location_id(uint8_t p_bus_id) {
	return request(Message::LOCATION_ID, p_bus_id);
}

Request set_location_id(uint16_t p_location, uint8_t p_bus_id) {
	return with_u16(Message::LOCATION_ID, p_location, p_bus_id);
}

Request request_output_mode(uint8_t p_bus_id) {
	return request(Message::SET_OUTPUT_MODE, p_bus_id);
}

Request set_output_mode(uint16_t p_mode, uint8_t p_bus_id) {
	return with_u16(Message::SET_OUTPUT_MODE, p_mode, p_bus_id);
}

Request request_output_settings(uint8_t p_bus_id) {
	return request(Message::SET_OUTPUT_SETTINGS, p_bus_id);
}

Request set_output_settings(uint32_t p_settings, uint8_t p_bus_id) {
	return with_u32(Message::SET_OUTPUT_SETTINGS, p_settings, p_bus_id);
}

Request request_skip_factor(uint8_t p_bus_id) {
	return request(Message::SET_OUTPUT_SKIP_FACTOR, p_bus_id);
}

Request set_skip_factor(uint16_t p_factor, uint8_t p_bus_id) {
	return with_u16(Message::SET_OUTPUT_SKIP_FACTOR, p_factor, p_bus_id);
}

Request request_error_mode() {
	return request(Message::SET_ERROR_MODE);
}

Request set_error_mode(ErrorMode p_mode) {
	return with_u16(Message::SET_ERROR_MODE, uint16_t(p_mode));
}

Request reset_orientation(OrientationReset p_reset, uint8_t p_bus_id) {
	return with_u16(Message::RESET_ORIENTATION, uint16_t(p_reset), p_bus_id);
}

Request request_object_alignment(uint8_t p_bus_id) {
	return request(Message::SET_OBJECT_ALIGNMENT, p_bus_id);
}

Request set_object_alignment(const std::array<float, 9> &p_matrix, uint8_t p_bus_id) {
	std::array<uint8_t, 36> data;
	for (std::size_t i = 0; i < p_matrix.size(); i++) {
		write_u32(float_bits(p_matrix[i]), data.data() + i * 4);
	}
	return with_data(Message::SET_OBJECT_ALIGNMENT, data.data(), data.size(), p_bus_id);
}

Request request_output_configuration(uint8_t p_bus_id) {
	return request(Message::SET_OUTPUT_CONFIGURATION, p_bus_id);
}

Request set_output_configuration(const OutputRequest *p_outputs, std::size_t p_count, uint8_t p_bus_id) {
	std::array<uint8_t, Request::MAX_OUTPUTS * 4> data;
	const std::size_t size = write_output_configuration(p_outputs, p_count, data.data(), data.size());
	return with_data(Message::SET_OUTPUT_CONFIGURATION, data.data(), size, p_bus_id);
}

} // namespace xbus::host
