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
	Message reply() const { return acknowledgement(message()); }
};

/// Builders of the messages that the host sends. Those named `request_...` ask for a value; `set_...` sets it.
/// The bus identifier is the master's, or 1..N for the trackers behind it.
namespace host {

/// A message without data.
Request request(Message p_message, uint8_t p_bus_id = MASTER);

Request wake_up_ack();
Request reset();
Request go_to_config();
Request go_to_measurement();
Request request_device_id(uint8_t p_bus_id = MASTER);
Request init_bus();
Request set_bus_power(bool p_on);
Request request_configuration();
Request request_data_length(uint8_t p_bus_id = MASTER);
/// In 1/115200 s, from 225 to 11520; 1152 is 100 Hz.
Request set_period(uint16_t p_ticks);
/// By its code: baud_code() of message.hpp.
Request set_baud_rate(uint8_t p_code);
Request request_battery_level();
Request set_output_mode(uint16_t p_mode, uint8_t p_bus_id);
Request set_output_settings(uint32_t p_settings, uint8_t p_bus_id);
/// FFFF: data only when asked. A master knows no skip factor.
Request set_skip_factor(uint16_t p_factor, uint8_t p_bus_id);
/// At most Request::MAX_OUTPUTS entries are sent.
Request set_output_configuration(const OutputRequest *p_outputs, std::size_t p_count, uint8_t p_bus_id = MASTER);

} // namespace host

} // namespace xbus
