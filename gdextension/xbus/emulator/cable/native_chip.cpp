// SPDX-License-Identifier: MIT
#include "cable/native_chip.hpp"

#include <algorithm>

namespace emulator {
namespace {

constexpr uint16_t XSENS = 0x2639;
constexpr std::size_t PACKET = 64;
/// Bytes that the chip keeps while nobody reads.
constexpr std::size_t KEPT_BYTES = 4096;

} // namespace

NativeChip::NativeChip(uint16_t p_product, const std::string &p_serial, uint64_t p_seed, SerialDevice &p_device) :
		_device(p_device), _line(p_seed) {
	_description.vendor = XSENS;
	_description.product = p_product;
	_description.release = 0x0100;
	_description.manufacturer = "Xsens";
	_description.product_name = "Xsens motion tracker";
	_description.serial = p_serial;
	_description.interfaces = {
		{ 0, 0, { { 0x81, 3, 16 } } },
		{ 1, 0, { { IN, 2, PACKET }, { OUT, 2, PACKET } } },
	};
}

int NativeChip::control(const UsbSetup & /*p_setup*/, uint8_t * /*p_data*/, Usec p_now) {
	_advance(p_now);
	return USB_STALL;
}

int NativeChip::write(uint8_t p_endpoint, const uint8_t *p_bytes, std::size_t p_size, Usec p_now) {
	if (p_endpoint != OUT || _is_halted) {
		return USB_STALL;
	}
	_advance(p_now);
	_device.receive(p_bytes, p_size, p_now);
	_advance(p_now);
	return int(p_size);
}

void NativeChip::_advance(Usec p_now) {
	_line.advance(_device, p_now, 0, false);
}

int NativeChip::read_packet(uint8_t p_endpoint, uint8_t *r_packet, Usec p_now, Usec &r_time) {
	if (p_endpoint != IN) {
		return p_endpoint == OUT ? USB_STALL : USB_NAK;
	}
	if (_is_halted) {
		return USB_STALL;
	}
	_advance(p_now);
	const std::size_t size = _line.take(r_packet, PACKET, p_now);
	_line.collect(_traces, p_now);
	r_time = p_now;
	return size > 0 ? int(size) : USB_NAK;
}

void NativeChip::wait(Usec p_now, Usec p_since) {
	_advance(p_now);
	const std::size_t arrived = _line.arrived(p_now);
	const std::size_t kept = _line.arrived(p_since) + KEPT_BYTES;
	if (arrived > kept) {
		_line.drop(arrived - kept);
	}
}

Usec NativeChip::next_event(bool p_is_read) const {
	const Usec device = std::min(_device.next_event(), _line.next_pull(_device));
	return std::min(device, p_is_read ? _line.arrival(1) : NEVER);
}

void NativeChip::clear_halt(uint8_t /*p_endpoint*/) {
	_is_halted = false;
}

void NativeChip::plug(bool p_in, Usec p_now) {
	_line.clear();
	_traces.clear();
	_is_halted = false;
	_device.power(p_in, p_now);
}

} // namespace emulator
