// SPDX-License-Identifier: MIT
#include "control_json.hpp"

#include "bus/bytes.hpp"
#include "bus/configuration.hpp"
#include "device/items.hpp"

#include <algorithm>
#include <array>

using namespace xbus;

namespace {

std::string version(const std::array<uint8_t, 3> &p_parts) {
	return std::to_string(p_parts[0]) + "." + std::to_string(p_parts[1]) + "." + std::to_string(p_parts[2]);
}

/// Up to the first zero; what is not ASCII becomes a question mark.
template <std::size_t N>
std::string text_of(const std::array<char, N> &p_text) {
	std::string text(p_text.begin(), std::find(p_text.begin(), p_text.end(), '\0'));
	for (char &letter : text) {
		letter = uint8_t(letter) < 0x20 || uint8_t(letter) > 0x7E ? '?' : letter;
	}
	return text;
}

void write_configuration(const Frame &p_frame, JsonWriter &r_json) {
	Configuration configuration;
	const ConfigurationFault fault = configuration.parse(p_frame.data, p_frame.size);
	if (fault != ConfigurationFault::NONE) {
		r_json.member("fault", configuration_fault_text(fault));
		return;
	}
	r_json.member("master_id", hex_id(configuration.master_id));
	r_json.member("period", unsigned(configuration.period));
	r_json.member("skip_factor", unsigned(configuration.skip_factor));
	r_json.member("date", text_of(configuration.date));
	r_json.member("time", text_of(configuration.time));
	r_json.key("trackers");
	r_json.begin_list();
	for (std::size_t i = 0; i < configuration.device_count; i++) {
		const DeviceConfiguration &device = configuration.devices[i];
		r_json.begin_object();
		r_json.member("device_id", hex_id(device.device_id));
		r_json.member("data_length", unsigned(device.data_length));
		r_json.member("mode", unsigned(device.format.mode));
		r_json.member("settings", unsigned(device.format.settings));
		r_json.member("scenario", unsigned(device.scenario));
		r_json.member("firmware", version(device.firmware));
		r_json.end_object();
	}
	r_json.end_list();
}

void write_outputs(const Frame &p_frame, JsonWriter &r_json) {
	std::array<OutputRequest, 64> outputs;
	std::size_t count = 0;
	if (!parse_output_configuration(p_frame.data, p_frame.size, outputs.data(), outputs.size(), count)) {
		r_json.member("fault", "its length is not that of a list of outputs");
		return;
	}
	r_json.key("outputs");
	r_json.begin_list();
	for (std::size_t i = 0; i < count; i++) {
		const ItemType &type = item_type(outputs[i].id);
		r_json.begin_object();
		r_json.member("id", hex_id(outputs[i].id, 4));
		r_json.key("name");
		if (type.is_known()) {
			r_json.value(type.name);
		} else {
			r_json.null();
		}
		r_json.member("rate", unsigned(outputs[i].rate));
		r_json.end_object();
	}
	r_json.end_list();
}

void write_error(const Frame &p_frame, JsonWriter &r_json) {
	if (p_frame.size == 0) {
		return;
	}
	const char *text = error_text(p_frame.data[0]);
	r_json.member("code", unsigned(p_frame.data[0]));
	r_json.member("text", text != nullptr ? text : "unknown error");
	if (p_frame.size > 1) {
		r_json.member("faulty_bus_id", unsigned(p_frame.data[1]));
	}
}

void write_device_ids(const Frame &p_frame, JsonWriter &r_json) {
	r_json.key("device_ids");
	r_json.begin_list();
	for (std::size_t i = 0; i + 4 <= p_frame.size; i += 4) {
		r_json.value(hex_id(read_u32(p_frame.data + i)));
	}
	r_json.end_list();
}

} // namespace

std::string hex_id(uint32_t p_id, int p_digits) {
	std::array<char, 16> text;
	std::snprintf(text.data(), text.size(), "0x%0*X", p_digits, unsigned(p_id));
	return text.data();
}

std::string hex_data(const uint8_t *p_data, std::size_t p_size) {
	static constexpr const char *DIGITS = "0123456789abcdef";
	std::string text;
	text.reserve(p_size * 2);
	for (std::size_t i = 0; i < p_size; i++) {
		text += DIGITS[unsigned(p_data[i]) >> 4U];
		text += DIGITS[p_data[i] & 0xFU];
	}
	return text;
}

void write_control(const Frame &p_frame, JsonWriter &r_json) {
	r_json.member("data", hex_data(p_frame.data, p_frame.size));
	switch (p_frame.message) {
		case Message::CONFIGURATION:
			write_configuration(p_frame, r_json);
			break;
		case Message::DEVICE_ID:
		case Message::INIT_BUS_RESULTS:
			write_device_ids(p_frame, r_json);
			break;
		case Message::ERROR:
			write_error(p_frame, r_json);
			break;
		case Message::SET_OUTPUT_CONFIGURATION:
		case Message::SET_OUTPUT_CONFIGURATION_ACK:
			write_outputs(p_frame, r_json);
			break;
		default:
			// A number is most of what small messages say.
			if (p_frame.size == 1) {
				r_json.member("value", unsigned(p_frame.data[0]));
			} else if (p_frame.size == 2) {
				r_json.member("value", unsigned(read_u16(p_frame.data)));
			} else if (p_frame.size == 4) {
				r_json.member("value", unsigned(read_u32(p_frame.data)));
			}
			break;
	}
}
