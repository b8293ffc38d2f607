// SPDX-License-Identifier: MIT
// The wire of FTDI's chips: divisors as Linux sets them, status bytes out of what is read.
#include "usb/ftdi_protocol.hpp"
#include "usb/known_devices.hpp"

#include "check.hpp"

#include <random>
#include <vector>

namespace test_ftdi_protocol {

TEST(divisors_are_those_of_the_kernels_driver) {
	// What Linux 6.1 was seen to send: docs/suits.md, "The wire".
	constexpr struct {
		uint32_t baud;
		uint16_t value;
	} TRACE[] = { { 9600, 0x4138 }, { 57600, 0xC034 }, { 115200, 0x001A }, { 230400, 0x000D }, { 460800, 0x4006 },
		{ 921600, 0x8003 } };
	for (const auto &line : TRACE) {
		const usb::FtdiDivisor divisor = usb::ftdi_divisor(line.baud, 0x0600, 0);
		CHECK(divisor.value == line.value);
		CHECK(divisor.index == 0);
	}
	CHECK(usb::ftdi_divisor(3000000, 0x0600, 0).value == 0);
	CHECK(usb::ftdi_divisor(2000000, 0x0600, 0).value == 1);
	// A chip with several ports wants the port's number too.
	CHECK(usb::ftdi_divisor(460800, 0x0700, 1).index == 1);
	CHECK(usb::ftdi_divisor(0, 0x0600, 0).value != 0);
}

TEST(status_bytes_go_payload_stays_however_reads_are_cut) {
	std::mt19937 random(5);
	for (const std::size_t packet : { 64U, 512U }) {
		std::vector<uint8_t> payload;
		std::vector<uint8_t> wire;
		std::size_t faults = 0;
		while (payload.size() < 20000) {
			const std::size_t size = random() % 4 == 0 ? random() % (packet - 1) : packet - 2;
			const bool is_faulty = random() % 10 == 0;
			wire.push_back(0x01);
			wire.push_back(is_faulty ? 0x62 : 0x60);
			faults += is_faulty ? 1U : 0U;
			for (std::size_t at = 0; at < size; ++at) {
				payload.push_back(uint8_t(random()));
				wire.push_back(payload.back());
			}
			if (size != packet - 2) {
				// A short packet ends a read.
				usb::FtdiStatistics statistics;
				std::vector<uint8_t> found;
				usb::ftdi_strip(
						wire.data(), wire.size(), packet, statistics, [&](const uint8_t *p_bytes, std::size_t p_size) {
							found.insert(found.end(), p_bytes, p_bytes + p_size);
						});
				CHECK(found == payload);
				CHECK(statistics.line_faults == faults);
				payload.clear();
				wire.clear();
				faults = 0;
				if (random() % 40 == 0) {
					break;
				}
			}
		}
	}
}

TEST(hostile_reads_stay_within_their_bytes) {
	std::mt19937 random(6);
	for (int round = 0; round < 200000; ++round) {
		const std::size_t size = random() % 200;
		const std::vector<uint8_t> bytes(size, uint8_t(random()));
		usb::FtdiStatistics statistics;
		std::size_t total = 0;
		usb::ftdi_strip(bytes.data(), size, random() % 70, statistics, [&](const uint8_t *p_bytes, std::size_t p_size) {
			total += p_size;
			CHECK(p_bytes >= bytes.data() && p_bytes + p_size <= bytes.data() + size);
		});
		CHECK(total <= size);
	}
}

TEST(devices_are_distinguished_by_their_numbers) {
	using usb::DeviceLink;
	CHECK(usb::identify(0x0403, 0xD388).kind == DeviceLink::FTDI);
	CHECK(usb::identify(0x0403, 0xD38D).kind == DeviceLink::AWINDA);
	CHECK(usb::identify(0x0403, 0x6001).kind == DeviceLink::OTHER);
	CHECK(usb::identify(0x2639, 0x0003).kind == DeviceLink::NATIVE);
	CHECK(usb::identify(0x2639, 0x0200).kind == DeviceLink::AWINDA);
	CHECK(usb::identify(0x2639, 0x0100).kind == DeviceLink::BODY_PACK);
	CHECK(usb::identify(0x2639, 0x7777).kind == DeviceLink::NATIVE);
	CHECK(usb::identify(0x1D6B, 0x0002).kind == DeviceLink::OTHER);
}

} // namespace test_ftdi_protocol
