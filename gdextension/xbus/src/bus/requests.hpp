// SPDX-License-Identifier: MIT
#pragma once

#include "bus/data_item.hpp"
#include "bus/encoder.hpp"
#include "bus/message.hpp"

#include <array>

namespace xbus {

/// A message from the host, ready to be sent.
struct Request {
	/// Most entries of a SetOutputConfiguration.
	static constexpr std::size_t MAX_OUTPUTS = 32;

	std::array<uint8_t, MAX_OUTPUTS * 4 + 7> bytes{};
	std::size_t size = 0;

	uint8_t bus_id() const { return bytes[1]; }
	Message message() const { return Message(bytes[2]); }
	/// False where no answer comes.
	bool is_acknowledged() const { return message() != Message::XM_POWER_OFF && message() != Message::WAKE_UP_ACK; }
	Message reply() const { return acknowledgement(message()); }
};

/// Builders of every message that a host sends. Those named `request_...` ask for a value; `set_...` sets it.
/// The bus identifier is the master's, or 1..N for the trackers behind it.
namespace host {

enum class SyncMode : uint8_t {
	OFF = 0x00,
	PULSE_WIDTH = 0x01,
	MASTER = 0x10,
	SLAVE = 0x20,
	TOGGLE = 0x30,
};

/// What ResetOrientation does; sent in Measurement to the tracker meant.
enum class OrientationReset : uint16_t {
	STORE = 0,
	HEADING = 1,
	GLOBAL = 2,
	OBJECT = 3,
	ALIGN = 4,
};

/// What a device does about errors in Measurement.
enum class ErrorMode : uint16_t {
	IGNORE = 0,
	COUNT = 1,
	COUNT_AND_SEND = 2,
	SEND_AND_GO_TO_CONFIG = 3,
};

/// A message without data.
Request request(Message p_message, uint8_t p_bus_id = MASTER);
Request with_u8(Message p_message, uint8_t p_value, uint8_t p_bus_id = MASTER);
Request with_u16(Message p_message, uint16_t p_value, uint8_t p_bus_id = MASTER);
Request with_u32(Message p_message, uint32_t p_value, uint8_t p_bus_id = MASTER);

Request wake_up_ack();
Request reset();
Request go_to_config();
Request go_to_measurement();
Request request_device_id(uint8_t p_bus_id = MASTER);
Request init_bus();
Request request_bus_power();
Request set_bus_power(bool p_on);
Request set_bus_id(uint8_t p_new, uint8_t p_bus_id = MASTER);
/// The same number as SetBID, without data.
Request auto_start();
Request request_configuration();
Request request_data_length(uint8_t p_bus_id = MASTER);
Request restore_factory_defaults(uint8_t p_bus_id = MASTER);
Request request_period();
/// In 1/115200 s, from 225 to 11520; 1152 is 100 Hz.
Request set_period(uint16_t p_ticks);
Request request_firmware_revision(uint8_t p_bus_id = MASTER);
Request request_product_code(uint8_t p_bus_id = MASTER);
Request request_hardware_version(uint8_t p_bus_id = MASTER);
Request request_bluetooth_disabled();
Request set_bluetooth_disabled(bool p_disabled);
Request request_operating_mode();
/// 1: a master sends its data on both of its outputs.
Request set_operating_mode(uint8_t p_mode);
Request request_baud_rate();
/// By its code: baud_code() of message.hpp.
Request set_baud_rate(uint8_t p_code);
Request request_sync_mode();
Request set_sync_mode(SyncMode p_mode);
Request request_xm_error_mode();
/// What a master does when its buffer overflows: 0 goes on, 1 stops.
Request set_xm_error_mode(uint16_t p_mode);
Request request_buffer_size();
Request set_buffer_size(uint16_t p_size);
Request request_battery_level();
/// Switches the master off; no answer comes.
Request switch_off();
/// Of a tracker that sends only when asked (skip factor FFFF).
Request request_data(uint8_t p_bus_id = MASTER);
Request request_heading(uint8_t p_bus_id);
/// Heading offset in degrees, of a tracker.
Request set_heading(float p_degrees, uint8_t p_bus_id);
Request request_location_id(uint8_t p_bus_id);
Request set_location_id(uint16_t p_location, uint8_t p_bus_id);
Request request_output_mode(uint8_t p_bus_id);
Request set_output_mode(uint16_t p_mode, uint8_t p_bus_id);
Request request_output_settings(uint8_t p_bus_id);
Request set_output_settings(uint32_t p_settings, uint8_t p_bus_id);
Request request_skip_factor(uint8_t p_bus_id);
/// FFFF: data only when asked. A master knows no skip factor.
Request set_skip_factor(uint16_t p_factor, uint8_t p_bus_id);
Request request_error_mode();
Request set_error_mode(ErrorMode p_mode);
Request reset_orientation(OrientationReset p_reset, uint8_t p_bus_id);
Request request_object_alignment(uint8_t p_bus_id);
/// Rotation from the sensor's to the object's frame, nine values in the order in which they are sent.
Request set_object_alignment(const std::array<float, 9> &p_matrix, uint8_t p_bus_id);
Request request_output_configuration(uint8_t p_bus_id = MASTER);
/// At most Request::MAX_OUTPUTS entries are sent.
Request set_output_configuration(const OutputRequest *p_outputs, std::size_t p_count, uint8_t p_bus_id = MASTER);

} // namespace host

} // namespace xbus
