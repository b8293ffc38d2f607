// SPDX-License-Identifier: MIT
#pragma once

#include "cable/time.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace emulator {

/// A control request, as its setup packet says.
struct UsbSetup {
	uint8_t type = 0;
	uint8_t request = 0;
	uint16_t value = 0;
	uint16_t index = 0;
	uint16_t length = 0;

	bool is_in() const { return (type & 0x80U) != 0; }
	/// From the packet's 8 bytes.
	static UsbSetup parse(const uint8_t *p_bytes);
	/// As the logs write it: "40 09 0010 0000 0".
	std::string text() const;
};

/// Answers of a device: the sizes of USB are never negative.
constexpr int USB_NAK = -11; // Nothing yet: EAGAIN.
constexpr int USB_STALL = -32; // EPIPE.

struct UsbEndpoint {
	/// With bit 7 set: to the host.
	uint8_t address = 0;
	/// 2 bulk, 3 interrupt.
	uint8_t type = 2;
	uint16_t packet = 64;
};

/// One alternate setting of an interface.
struct UsbInterface {
	uint8_t number = 0;
	uint8_t alternate = 0;
	std::vector<UsbEndpoint> endpoints;
};

/// What a device says of itself.
struct UsbDescription {
	uint16_t vendor = 0;
	uint16_t product = 0;
	uint16_t release = 0x0600;
	/// 12 or 480 Mbit/s.
	int speed = 12;
	std::string manufacturer;
	std::string product_name;
	std::string serial;
	std::vector<UsbInterface> interfaces;

	/// The 18 bytes of the device descriptor.
	std::vector<uint8_t> device_bytes() const;
	/// The configuration with its interfaces and endpoints.
	std::vector<uint8_t> configuration_bytes() const;
	/// A string descriptor, empty where there is none of that number.
	std::vector<uint8_t> string_bytes(uint8_t p_number) const;
	const UsbEndpoint *find_endpoint(uint8_t p_address) const;
	uint8_t interface_count() const;
};

/// A device at the end of a cable. Times never go back from one call to the next.
class UsbDevice {
public:
	virtual ~UsbDevice() = default;

	virtual const UsbDescription &description() const = 0;
	/// A vendor's request; `p_data` is read or written. Bytes that went, or USB_STALL.
	virtual int control(const UsbSetup &p_setup, uint8_t *p_data, Usec p_now) = 0;
	/// Takes bytes: how many, or USB_STALL.
	virtual int write(uint8_t p_endpoint, const uint8_t *p_bytes, std::size_t p_size, Usec p_now) = 0;
	/// One packet for the host, at most as large as the endpoint's: its size, USB_NAK or USB_STALL.
	/// `r_time`: when it was ready, not later than `p_now`.
	virtual int read_packet(uint8_t p_endpoint, uint8_t *r_packet, Usec p_now, Usec &r_time) = 0;
	/// Nobody has read since `p_since`: what has arrived since then has to be kept, or is lost. What came before
	/// would have been read if the emulator had not been late.
	virtual void wait(Usec p_now, Usec p_since) = 0;
	/// When there will be something to do next; with `p_is_read`, also when a packet will be ready.
	virtual Usec next_event(bool p_is_read) const = 0;
	/// The host takes back a stall.
	virtual void clear_halt(uint8_t p_endpoint) = 0;
	/// Powered by the cable, or no more.
	virtual void plug(bool p_in, Usec p_now) = 0;
};

/// Answers to the standard requests of chapter 9 of the USB specification.
int standard_control(const UsbDescription &p_description, const UsbSetup &p_setup, uint8_t *p_data);

} // namespace emulator
