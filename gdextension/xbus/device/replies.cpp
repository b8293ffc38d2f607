// SPDX-License-Identifier: MIT
#include "device/replies.hpp"

#include "bus/bytes.hpp"
#include "device/full_mt_data.hpp"
#include "device/items.hpp"

namespace xbus::device {

std::size_t write_ack(Message p_request, uint8_t p_bus_id, uint8_t *r_bytes) {
	return write_frame(p_bus_id, acknowledgement(p_request), nullptr, 0, r_bytes);
}

std::size_t write_u8_reply(Message p_message, uint8_t p_value, uint8_t p_bus_id, uint8_t *r_bytes) {
	return write_frame(p_bus_id, p_message, &p_value, 1, r_bytes);
}

std::size_t write_u32_reply(Message p_message, uint32_t p_value, uint8_t p_bus_id, uint8_t *r_bytes) {
	std::array<uint8_t, 4> data;
	write_u32(p_value, data.data());
	return write_frame(p_bus_id, p_message, data.data(), data.size(), r_bytes);
}

std::size_t write_wake_up(uint8_t *r_bytes) {
	return write_frame(MASTER, Message::WAKE_UP, nullptr, 0, r_bytes);
}

std::size_t write_device_id(uint32_t p_device_id, uint8_t p_bus_id, uint8_t *r_bytes) {
	return write_u32_reply(Message::DEVICE_ID, p_device_id, p_bus_id, r_bytes);
}

std::size_t write_device_list(const uint32_t *p_device_ids, std::size_t p_count, uint8_t *r_bytes) {
	std::array<uint8_t, MAX_DEVICES * 4> data;
	const std::size_t count = p_count < MAX_DEVICES ? p_count : MAX_DEVICES;
	for (std::size_t i = 0; i < count; i++) {
		write_u32(p_device_ids[i], data.data() + i * 4);
	}
	return write_frame(MASTER, Message::INIT_BUS_RESULTS, data.data(), count * 4, r_bytes);
}

std::size_t write_configuration(const Configuration &p_configuration, uint8_t *r_bytes) {
	std::array<uint8_t, Configuration::MAX_BYTES> data;
	const std::size_t size = p_configuration.write(data.data());
	return write_frame(MASTER, Message::CONFIGURATION, data.data(), size, r_bytes);
}

std::size_t write_error(uint8_t p_code, uint8_t *r_bytes) {
	return write_u8_reply(Message::ERROR, p_code, MASTER, r_bytes);
}

std::size_t write_error(uint8_t p_code, uint8_t p_bus_id, uint8_t *r_bytes) {
	const std::array<uint8_t, 2> data = { p_code, p_bus_id };
	return write_frame(MASTER, Message::ERROR, data.data(), data.size(), r_bytes);
}

std::size_t write_firmware_revision(const std::array<uint8_t, 3> &p_revision, uint8_t p_bus_id, uint8_t *r_bytes) {
	return write_frame(p_bus_id, Message::FIRMWARE_REVISION, p_revision.data(), p_revision.size(), r_bytes);
}

std::array<uint8_t, 20> product_code(const char *p_code) {
	std::array<uint8_t, 20> code;
	code.fill(' ');
	for (std::size_t i = 0; i < code.size() && p_code[i] != '\0'; i++) {
		code[i] = uint8_t(p_code[i]);
	}
	return code;
}

std::size_t write_product_code(const char *p_code, uint8_t p_bus_id, uint8_t *r_bytes) {
	const std::array<uint8_t, 20> code = product_code(p_code);
	return write_frame(p_bus_id, Message::PRODUCT_CODE, code.data(), code.size(), r_bytes);
}

std::size_t write_mt_data(
		const MasterFormat &p_format, uint16_t p_counter, const FullSample *p_samples, uint8_t *r_bytes) {
	// Written where the data of a long message begin; a short message's begin two bytes earlier.
	const std::size_t head = frame_size(p_format.size()) - p_format.size() - 1;
	const std::size_t size = write_data(p_format, p_counter, p_samples, r_bytes + head);
	return write_frame(MASTER, Message::MT_DATA, r_bytes + head, size, r_bytes);
}

std::size_t write_mt_data(
		const OutputFormat &p_format, const FullSample &p_sample, uint8_t p_bus_id, uint8_t *r_bytes) {
	const std::size_t head = frame_size(p_format.size()) - p_format.size() - 1;
	const std::size_t size = write_block(p_format, p_sample, true, r_bytes + head);
	return write_frame(p_bus_id, Message::MT_DATA, r_bytes + head, size, r_bytes);
}

std::size_t write_mt_data2(
		const uint16_t *p_ids, std::size_t p_count, const FullSample &p_sample, uint8_t p_bus_id, uint8_t *r_bytes) {
	std::array<uint8_t, MAX_DATA> data;
	const std::size_t size = xbus::write_mt_data2(p_ids, p_count, p_sample, data.data(), data.size());
	return size > 0 ? write_frame(p_bus_id, Message::MT_DATA2, data.data(), size, r_bytes) : 0;
}

} // namespace xbus::device
