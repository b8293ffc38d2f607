// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace usb {

/// Control requests of FTDI's serial chips, as Linux' ftdi_sio issues them (docs/suits.md, "The wire").
namespace ftdi {

constexpr uint8_t OUT = 0x40; // bmRequestType: vendor, to the device.
constexpr uint8_t IN = 0xC0; // bmRequestType: vendor, from the device.

constexpr uint8_t RESET = 0x00;
constexpr uint8_t MODEM_CONTROL = 0x01;
constexpr uint8_t FLOW_CONTROL = 0x02;
constexpr uint8_t BAUD_RATE = 0x03;
constexpr uint8_t DATA_FORMAT = 0x04;
constexpr uint8_t MODEM_STATUS = 0x05;
constexpr uint8_t LATENCY_TIMER = 0x09;

constexpr uint16_t RESET_ALL = 0;
constexpr uint16_t PURGE_IN = 1;
constexpr uint16_t PURGE_OUT = 2;
constexpr uint16_t DTR_RTS_ON = 0x0303;
constexpr uint16_t DTR_RTS_OFF = 0x0300;
/// 8 data bits, no parity, 2 stop bits: what old trackers want.
constexpr uint16_t FORMAT_8N2 = 0x1008;
/// With a stop bit too few nothing is lost, with a stop bit too many neither: bits on the line per byte.
constexpr uint32_t BITS_PER_BYTE = 11;

/// Bits of the second status byte that say that bytes are lost or wrong.
constexpr unsigned LINE_OVERRUN = 0x02;
constexpr unsigned LINE_PARITY = 0x04;
constexpr unsigned LINE_FRAMING = 0x08;
constexpr unsigned LINE_BREAK = 0x10;
constexpr unsigned LINE_FAULTS = LINE_OVERRUN | LINE_PARITY | LINE_FRAMING | LINE_BREAK;

/// Status bytes at the beginning of every packet.
constexpr std::size_t STATUS_SIZE = 2;

} // namespace ftdi

/// How a chip's baud rate is set: the request's wValue and wIndex.
struct FtdiDivisor {
	uint16_t value = 0;
	uint16_t index = 0;
};

/// Whether a chip addresses its ports in wIndex (2232 and the high-speed ones), by its bcdDevice.
inline bool ftdi_has_ports(uint16_t p_release) {
	return p_release == 0x0500 || p_release == 0x0700 || p_release == 0x0800 || p_release == 0x0900;
}

/// The divisor of a baud rate: 3 MHz / rate in eighths, the fraction coded in bits 14 to 16 (FTDI AN232B-05).
/// `p_port` counts from 1.
inline FtdiDivisor ftdi_divisor(uint32_t p_baud, uint16_t p_release, uint16_t p_port) {
	constexpr uint32_t CLOCK = 24000000; // 48 MHz / 2: the divisor in eighths.
	constexpr uint32_t FRACTIONS[8] = { 0, 3, 2, 4, 1, 5, 6, 7 };
	const uint32_t eighths = std::clamp((CLOCK + p_baud / 2) / std::max(p_baud, 1U), 8U, 0x1FFFFU);
	uint32_t divisor = (eighths >> 3U) | (FRACTIONS[eighths & 7U] << 14U);
	if (divisor == 1) {
		divisor = 0; // 3 Mbaud
	} else if (divisor == 0x4001) {
		divisor = 1; // 2 Mbaud
	}
	FtdiDivisor result;
	result.value = uint16_t(divisor & 0xFFFFU);
	result.index = uint16_t(divisor >> 16U);
	if (ftdi_has_ports(p_release)) {
		result.index = uint16_t((uint32_t(result.index) << 8U) | uint32_t(p_port));
	}
	return result;
}

/// What the status bytes said.
struct FtdiStatistics {
	uint64_t packets = 0;
	/// Packets that were too short for a status: the chip never sends such.
	uint64_t short_packets = 0;
	/// Packets whose status has overrun, parity, framing or break.
	uint64_t line_faults = 0;
};

/// Hands the payload of a read on without the two status bytes that begin every packet.
/// `p_sink(const uint8_t *bytes, std::size_t size)` is called for each run of payload.
template <class Sink>
void ftdi_strip(const uint8_t *p_bytes, std::size_t p_size, std::size_t p_packet_size, FtdiStatistics &r_statistics,
		Sink &&p_sink) {
	const std::size_t packet_size = std::max(p_packet_size, ftdi::STATUS_SIZE + 1);
	for (std::size_t at = 0; at < p_size; at += packet_size) {
		const std::size_t size = std::min(packet_size, p_size - at);
		++r_statistics.packets;
		if (size < ftdi::STATUS_SIZE) {
			++r_statistics.short_packets;
			continue;
		}
		if ((p_bytes[at + 1] & ftdi::LINE_FAULTS) != 0) {
			++r_statistics.line_faults;
		}
		if (size > ftdi::STATUS_SIZE) {
			p_sink(p_bytes + at + ftdi::STATUS_SIZE, size - ftdi::STATUS_SIZE);
		}
	}
}

} // namespace usb
