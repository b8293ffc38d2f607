// SPDX-License-Identifier: MIT
#pragma once

#include "bus/configuration.hpp"
#include "bus/encoder.hpp"
#include "device/full_sample.hpp"

// Messages that devices send: for tests and the emulator. All return the bytes written, head included.

namespace xbus::device {

/// An acknowledgement without data.
std::size_t write_ack(Message p_request, uint8_t p_bus_id, uint8_t *r_bytes);
std::size_t write_u8_reply(Message p_message, uint8_t p_value, uint8_t p_bus_id, uint8_t *r_bytes);
std::size_t write_u32_reply(Message p_message, uint32_t p_value, uint8_t p_bus_id, uint8_t *r_bytes);
std::size_t write_wake_up(uint8_t *r_bytes);
std::size_t write_device_id(uint32_t p_device_id, uint8_t p_bus_id, uint8_t *r_bytes);
/// InitBusResults; at most MAX_DEVICES identifiers.
std::size_t write_device_list(const uint32_t *p_device_ids, std::size_t p_count, uint8_t *r_bytes);
std::size_t write_configuration(const Configuration &p_configuration, uint8_t *r_bytes);
std::size_t write_error(uint8_t p_code, uint8_t *r_bytes);
/// Names the tracker at fault.
std::size_t write_error(uint8_t p_code, uint8_t p_bus_id, uint8_t *r_bytes);
std::size_t write_firmware_revision(const std::array<uint8_t, 3> &p_revision, uint8_t p_bus_id, uint8_t *r_bytes);
/// As a device says it: padded with spaces to 20 characters.
std::array<uint8_t, 20> product_code(const char *p_code);
std::size_t write_product_code(const char *p_code, uint8_t p_bus_id, uint8_t *r_bytes);
/// MTData of a master, and of a tracker that stands alone (its counter last).
std::size_t write_mt_data(
		const MasterFormat &p_format, uint16_t p_counter, const FullSample *p_samples, uint8_t *r_bytes);
std::size_t write_mt_data(const OutputFormat &p_format, const FullSample &p_sample, uint8_t p_bus_id, uint8_t *r_bytes);
/// 0 if it cannot be written.
std::size_t write_mt_data2(
		const uint16_t *p_ids, std::size_t p_count, const FullSample &p_sample, uint8_t p_bus_id, uint8_t *r_bytes);

} // namespace xbus::device
