// SPDX-License-Identifier: MIT
#include "bus_streams.hpp"

#include "bus/configuration.hpp"
#include "bus/requests.hpp"

#include "check.hpp"

#include <algorithm>

namespace test_configuration {

using namespace streams;

namespace {

Configuration suit(std::size_t p_trackers) {
	Configuration configuration;
	configuration.master_id = 0x00120304;
	configuration.period = 1152;
	configuration.date = { '2', '0', '0', '8', '0', '1', '3', '1' };
	configuration.device_count = p_trackers;
	for (std::size_t i = 0; i < p_trackers; i++) {
		DeviceConfiguration &device = configuration.devices[i];
		device.device_id = uint32_t(0x00300000 + i);
		device.format = { output_mode::ORIENTATION, uint32_t(i) };
		device.data_length = uint16_t(16 + i);
	}
	return configuration;
}

} // namespace

TEST(configurations_of_all_sizes_go_both_ways) {
	for (const std::size_t trackers :
			{ std::size_t(0), std::size_t(1), std::size_t(10), std::size_t(20), MAX_DEVICES }) {
		Bytes bytes(Configuration::MAX_BYTES);
		bytes.resize(suit(trackers).write(bytes.data()));
		CHECK(bytes.size() == 98 + 20 * trackers);
		Configuration found;
		CHECK(found.parse(bytes.data(), bytes.size()) == ConfigurationFault::NONE);
		CHECK(found.device_count == trackers && found.master_id == 0x00120304 && found.period == 1152);
		for (std::size_t i = 0; i < trackers; i++) {
			CHECK(found.devices[i].device_id == 0x00300000 + i && found.devices[i].data_length == 16 + i);
			CHECK(found.devices[i].format.settings == i);
		}
		Bytes again(Configuration::MAX_BYTES);
		again.resize(found.write(again.data()));
		CHECK(again == bytes);
	}
}

TEST(a_lie_about_the_number_of_trackers_is_seen) {
	Bytes bytes(Configuration::MAX_BYTES);
	bytes.resize(suit(3).write(bytes.data()));
	Configuration found = suit(1);
	for (const uint16_t lie : { 0, 2, 4, 255, 65535 }) {
		write_u16(lie, &bytes[96]);
		CHECK(found.parse(bytes.data(), bytes.size()) == ConfigurationFault::WRONG_LENGTH);
	}
	// What was known before stays.
	CHECK(found.device_count == 1);
	CHECK(found.parse(bytes.data(), 97) == ConfigurationFault::TOO_SHORT);
	CHECK(found.parse(bytes.data(), 0) == ConfigurationFault::TOO_SHORT);
	bytes.resize(98 + 20 * 65);
	write_u16(65, &bytes[96]);
	CHECK(found.parse(bytes.data(), bytes.size()) == ConfigurationFault::TOO_MANY);
}

TEST(the_rate_counts_the_skip_factor) {
	Configuration configuration = suit(1);
	CHECK_NEAR(configuration.rate(), 100.0, 1e-9);
	configuration.skip_factor = 1;
	CHECK_NEAR(configuration.rate(), 50.0, 1e-9);
	configuration.period = 0;
	CHECK(configuration.rate() == 0.0);
}

TEST(devices_are_known_by_their_identifiers) {
	CHECK(device_kind(0x00100123) == DeviceKind::XBUS_MASTER);
	CHECK(device_kind(0x00300123) == DeviceKind::MTI_MTX && device_kind(0x00500123) == DeviceKind::MTI_G);
	CHECK(device_kind(0x00200123) == DeviceKind::AWINDA_STATION);
	CHECK(device_kind(0x00210123) == DeviceKind::AWINDA_DONGLE);
	CHECK(device_kind(0x00B40123) == DeviceKind::MTW2_MTX2 && device_kind(0x00A00001) == DeviceKind::BODY_PACK);
	CHECK(device_kind(0) == DeviceKind::UNKNOWN);
}

TEST(baud_rates_have_codes) {
	for (const uint32_t rate : { 921600U, 460800U, 230400U, 115200U, 57600U, 38400U, 19200U, 9600U, 4800U }) {
		uint8_t code = 0xEE;
		CHECK(baud_code(rate, code) && baud_rate(code) == rate);
	}
	uint8_t code = 0;
	CHECK(!baud_code(1234, code) && baud_rate(0x77) == 0 && baud_rate(0x0A) == 921600);
}

TEST(requests_say_what_they_ask) {
	const auto data = [](const Request &p_request) {
		return Bytes(p_request.bytes.begin() + 4, p_request.bytes.begin() + std::ptrdiff_t(p_request.size) - 1);
	};
	CHECK(data(host::set_bus_power(true)) == Bytes({ 0, 1 }) &&
			host::set_bus_power(true).message() == Message::BUS_POWER);
	CHECK(data(host::set_skip_factor(0xFFFF, 1)) == Bytes({ 0xFF, 0xFF }) && host::set_skip_factor(0, 3).bus_id() == 3);
	CHECK(data(host::set_baud_rate(0x02)) == Bytes({ 0x02 }));
	CHECK(data(host::set_output_settings(0x80000301, 2)) == Bytes({ 0x80, 0, 3, 1 }));
	CHECK(host::request_battery_level().size == 5 && host::request_battery_level().reply() == Message::BATTERY_LEVEL);
	// More outputs than there is room for: as many as there is.
	const std::vector<OutputRequest> outputs(50, { 0x2010, 100 });
	CHECK(host::set_output_configuration(outputs.data(), outputs.size()).size == 4 + 128 + 1);
}

TEST(replies_can_be_framed) {
	Bytes bytes(MAX_FRAME);
	std::vector<uint32_t> ids(70, 0x00300001);
	std::size_t size = device::write_device_list(ids.data(), ids.size(), bytes.data());
	std::size_t trackers = 0;
	Framer framer;
	const auto sink = [&](const Frame &p_frame) {
		trackers = p_frame.size / 4;
		CHECK(is_device_message(p_frame));
	};
	framer.feed(bytes.data(), size, sink);
	CHECK(trackers == MAX_DEVICES);
	for (const std::size_t written :
			{ device::write_error(0x1E, 3, bytes.data()), device::write_product_code("MTx-28A53G25", 1, bytes.data()),
					device::write_firmware_revision({ 2, 5, 1 }, MASTER, bytes.data()),
					device::write_u8_reply(Message::BATTERY_LEVEL, 200, MASTER, bytes.data()) }) {
		CHECK(written > 5);
	}
	framer.feed(bytes.data(), device::write_product_code("MTx-28A53G25", 1, bytes.data()), sink);
	CHECK(framer.statistics().frames == 2 && framer.statistics().skipped_bytes == 0);
}

} // namespace test_configuration
