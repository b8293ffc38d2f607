// SPDX-License-Identifier: MIT
#include "cable/usb_device.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>

namespace emulator {
namespace {

constexpr uint8_t DEVICE = 1;
constexpr uint8_t CONFIGURATION = 2;
constexpr uint8_t STRING = 3;
constexpr uint8_t INTERFACE = 4;
constexpr uint8_t ENDPOINT = 5;

uint16_t read_u16(const uint8_t *p_bytes) {
	return uint16_t(p_bytes[0] | unsigned(p_bytes[1]) << 8U);
}

uint8_t low(unsigned p_value) {
	return uint8_t(p_value & 0xFFU);
}

uint8_t high(unsigned p_value) {
	return uint8_t(p_value >> 8U);
}

void append_interface(std::vector<uint8_t> &r_bytes, const UsbInterface &p_interface) {
	r_bytes.reserve(r_bytes.size() + 9 + 7 * p_interface.endpoints.size());
	const uint8_t endpoints = uint8_t(p_interface.endpoints.size());
	const uint8_t head[] = { 9, INTERFACE, p_interface.number, p_interface.alternate, endpoints, 0xFF, 0xFF, 0xFF, 2 };
	r_bytes.insert(r_bytes.end(), std::begin(head), std::end(head));
	for (const UsbEndpoint &endpoint : p_interface.endpoints) {
		const uint8_t interval = endpoint.type == 3 ? 10 : 0;
		const uint8_t bytes[] = { 7, ENDPOINT, endpoint.address, endpoint.type, low(endpoint.packet),
			high(endpoint.packet), interval };
		r_bytes.insert(r_bytes.end(), std::begin(bytes), std::end(bytes));
	}
}

std::vector<uint8_t> descriptor(const UsbDescription &p_description, uint16_t p_value) {
	switch (high(p_value)) {
		case DEVICE:
			return p_description.device_bytes();
		case CONFIGURATION:
			return p_description.configuration_bytes();
		case STRING:
			return p_description.string_bytes(low(p_value));
		default:
			return {};
	}
}

} // namespace

UsbSetup UsbSetup::parse(const uint8_t *p_bytes) {
	UsbSetup setup;
	setup.type = p_bytes[0];
	setup.request = p_bytes[1];
	setup.value = read_u16(p_bytes + 2);
	setup.index = read_u16(p_bytes + 4);
	setup.length = read_u16(p_bytes + 6);
	return setup;
}

std::string UsbSetup::text() const {
	std::array<char, 40> line{};
	(void)snprintf(line.data(), line.size(), "%02x %02x %04x %04x %u", type, request, value, index, length);
	return line.data();
}

std::vector<uint8_t> UsbDescription::device_bytes() const {
	return { 18, DEVICE, 0x00, 0x02, 0, 0, 0, 64, low(vendor), high(vendor), low(product), high(product), low(release),
		high(release), 1, 2, uint8_t(serial.empty() ? 0 : 3), 1 };
}

std::vector<uint8_t> UsbDescription::configuration_bytes() const {
	std::vector<uint8_t> bytes = { 9, CONFIGURATION, 0, 0, interface_count(), 1, 0, 0x80, 45 };
	for (const UsbInterface &one : interfaces) {
		append_interface(bytes, one);
	}
	bytes[2] = low(unsigned(bytes.size()));
	bytes[3] = high(unsigned(bytes.size()));
	return bytes;
}

std::vector<uint8_t> UsbDescription::string_bytes(uint8_t p_number) const {
	if (p_number == 0) {
		return { 4, STRING, 0x09, 0x04 };
	}
	const std::array<const std::string *, 3> texts = { &manufacturer, &product_name, &serial };
	if (p_number > texts.size() || texts.at(p_number - 1U)->empty()) {
		return {};
	}
	const std::string &text = *texts.at(p_number - 1U);
	std::vector<uint8_t> bytes = { uint8_t(2 + 2 * text.size()), STRING };
	bytes.reserve(2 + 2 * text.size());
	for (const char letter : text) {
		bytes.push_back(uint8_t(letter));
		bytes.push_back(0);
	}
	return bytes;
}

const UsbEndpoint *UsbDescription::find_endpoint(uint8_t p_address) const {
	for (const UsbInterface &one : interfaces) {
		for (const UsbEndpoint &endpoint : one.endpoints) {
			if (endpoint.address == p_address) {
				return &endpoint;
			}
		}
	}
	return nullptr;
}

uint8_t UsbDescription::interface_count() const {
	uint8_t count = 0;
	for (const UsbInterface &one : interfaces) {
		count = std::max(count, uint8_t(one.number + 1));
	}
	return count;
}

int standard_control(const UsbDescription &p_description, const UsbSetup &p_setup, uint8_t *p_data) {
	constexpr uint8_t GET_STATUS = 0;
	constexpr uint8_t GET_DESCRIPTOR = 6;
	constexpr uint8_t GET_CONFIGURATION = 8;
	constexpr uint8_t GET_INTERFACE = 10;
	if (!p_setup.is_in()) {
		return 0; // SET_ADDRESS, SET_CONFIGURATION, SET_INTERFACE, CLEAR_FEATURE: as you wish.
	}
	std::vector<uint8_t> answer;
	switch (p_setup.request) {
		case GET_STATUS:
			answer = { 0, 0 };
			break;
		case GET_DESCRIPTOR:
			answer = descriptor(p_description, p_setup.value);
			break;
		case GET_CONFIGURATION:
			answer = { 1 };
			break;
		case GET_INTERFACE:
			answer = { 0 };
			break;
		default:
			break;
	}
	if (answer.empty()) {
		return USB_STALL;
	}
	const std::size_t size = std::min(answer.size(), std::size_t(p_setup.length));
	std::memcpy(p_data, answer.data(), size);
	return int(size);
}

} // namespace emulator
