// SPDX-License-Identifier: MIT
#include "cable/ftdi_chip.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace emulator {
namespace {

constexpr uint8_t RESET = 0x00;
constexpr uint8_t MODEM_CONTROL = 0x01;
constexpr uint8_t FLOW_CONTROL = 0x02;
constexpr uint8_t BAUD_RATE = 0x03;
constexpr uint8_t DATA_FORMAT = 0x04;
constexpr uint8_t MODEM_STATUS = 0x05;
constexpr uint8_t EVENT_CHARACTER = 0x06;
constexpr uint8_t ERROR_CHARACTER = 0x07;
constexpr uint8_t SET_LATENCY = 0x09;
constexpr uint8_t GET_LATENCY = 0x0A;
constexpr uint8_t SET_BIT_MODE = 0x0B;
constexpr uint8_t READ_EEPROM = 0x90;

constexpr std::size_t STATUS_BYTES = 2;
/// Bytes that the chip keeps while nobody reads.
constexpr std::size_t KEPT = 256;
constexpr uint16_t TWO_STOP_BITS = 0x1000;

UsbDescription describe(const ChipOptions &p_options) {
	UsbDescription description;
	description.vendor = p_options.vendor;
	description.product = p_options.product;
	description.release = p_options.is_fast ? 0x0900 : 0x0600;
	description.speed = p_options.is_fast ? 480 : 12;
	description.manufacturer = "Xsens";
	description.product_name = "Xsens USB-serial converter";
	description.serial = p_options.serial;
	const uint16_t packet = p_options.is_fast ? 512 : 64;
	description.interfaces = { { 0, 0, { { FtdiChip::IN, 2, packet }, { FtdiChip::OUT, 2, packet } } } };
	return description;
}

} // namespace

FtdiChip::FtdiChip(const ChipOptions &p_options, SerialDevice &p_device) :
		_description(describe(p_options)),
		_options(p_options),
		_device(p_device),
		_line(p_options.seed),
		_random(p_options.seed + 1) {}

uint32_t FtdiChip::baud_of_divisor(uint16_t p_value, uint16_t p_index, bool p_is_fast) {
	constexpr double EIGHTHS[] = { 0.0, 0.5, 0.25, 0.125, 0.375, 0.625, 0.75, 0.875 };
	const double whole = p_value & 0x3FFFU;
	// The chips with an H have the number of the channel in the index, and the rest one byte higher.
	const unsigned index = p_is_fast ? unsigned(p_index) >> 8U : unsigned(p_index);
	const unsigned eighths = unsigned(p_value) >> 14U | (index & 1U) << 2U;
	const double clock = p_is_fast && (index & 2U) != 0 ? 12e6 : 3e6;
	double divisor = whole + EIGHTHS[eighths];
	if (whole == 0.0) {
		divisor = 1.0;
	} else if (whole == 1.0) {
		divisor = 1.5;
	}
	return uint32_t(std::lround(clock / divisor));
}

int64_t FtdiChip::_byte_nsec() const {
	const int bits = (_format & TWO_STOP_BITS) != 0 ? 11 : 10;
	return _options.is_paced ? int64_t(bits) * 1000000000 / std::max(_baud, 1U) : 0;
}

bool FtdiChip::_speeds_agree() const {
	// A start bit must still be recognised at the byte's last bit.
	return std::abs(double(_baud) / double(_device.baud()) - 1.0) < 0.04;
}

void FtdiChip::_reset(uint16_t p_value, Usec p_now) {
	constexpr uint16_t PURGE_RX = 1;
	constexpr uint16_t PURGE_TX = 2;
	if (p_value != PURGE_TX) {
		_line.drop(_line.arrived(p_now));
	}
	if (p_value != PURGE_RX) {
		_deliveries.clear();
		_out_free = 0;
	}
}

uint16_t FtdiChip::_eeprom_word(uint16_t p_index) const {
	const uint16_t words[] = { 0x4000, _options.vendor, _options.product, 0x0600, 0x2D80, 0x0008 };
	return p_index < std::size(words) ? words[p_index] : uint16_t(0);
}

int FtdiChip::_read_register(const UsbSetup &p_setup, uint8_t *p_data) const {
	uint16_t value = 0;
	int size = 2;
	switch (p_setup.request) {
		case MODEM_STATUS:
			value = _options.is_fast ? 0x6032 : 0x6031;
			break;
		case GET_LATENCY:
			value = uint16_t(_latency_ms);
			size = 1;
			break;
		case READ_EEPROM:
			value = _eeprom_word(p_setup.index);
			break;
		default:
			return USB_STALL;
	}
	size = std::min(size, int(p_setup.length));
	const uint8_t bytes[] = { uint8_t(value & 0xFFU), uint8_t(value >> 8U) };
	std::memcpy(p_data, bytes, std::size_t(size));
	return size;
}

int FtdiChip::control(const UsbSetup &p_setup, uint8_t *p_data, Usec p_now) {
	_advance(p_now);
	if (p_setup.is_in()) {
		return _read_register(p_setup, p_data);
	}
	switch (p_setup.request) {
		case RESET:
			_reset(p_setup.value, p_now);
			return 0;
		case MODEM_CONTROL: {
			// The high byte says which of the two lines in the low byte are meant.
			const unsigned mask = unsigned(p_setup.value) >> 8U;
			_modem = uint16_t((_modem & ~mask) | (p_setup.value & mask));
			return 0;
		}
		case BAUD_RATE:
			_baud = baud_of_divisor(p_setup.value, p_setup.index, _options.is_fast);
			return 0;
		case DATA_FORMAT:
			_format = p_setup.value;
			return 0;
		case SET_LATENCY:
			_latency_ms = std::clamp(int(p_setup.value & 0xFFU), 1, 255);
			return 0;
		case FLOW_CONTROL:
		case EVENT_CHARACTER:
		case ERROR_CHARACTER:
		case SET_BIT_MODE:
			return 0;
		default:
			return USB_STALL;
	}
}

int FtdiChip::write(uint8_t p_endpoint, const uint8_t *p_bytes, std::size_t p_size, Usec p_now) {
	if (p_endpoint != OUT || _is_halted) {
		return USB_STALL;
	}
	_advance(p_now);
	Delivery delivery;
	delivery.bytes.assign(p_bytes, p_bytes + p_size);
	if (!_speeds_agree()) {
		for (uint8_t &byte : delivery.bytes) {
			byte = uint8_t(_random.next());
		}
	}
	delivery.time = std::max(p_now, _out_free) + int64_t(p_size) * _byte_nsec() / 1000;
	_out_free = delivery.time;
	_deliveries.push_back(std::move(delivery));
	_advance(p_now);
	return int(p_size);
}

void FtdiChip::_advance(Usec p_now) {
	while (!_deliveries.empty() && _deliveries.front().time <= p_now) {
		const Delivery delivery = std::move(_deliveries.front());
		_deliveries.pop_front();
		_line.advance(_device, delivery.time, _byte_nsec(), !_speeds_agree());
		_device.receive(delivery.bytes.data(), delivery.bytes.size(), delivery.time);
	}
	_line.advance(_device, p_now, _byte_nsec(), !_speeds_agree());
}

Usec FtdiChip::_next_packet() const {
	const std::size_t payload = std::size_t(_description.interfaces[0].endpoints[0].packet) - STATUS_BYTES;
	const Usec tick = _last_packet + Usec(_latency_ms) * 1000;
	return std::max(std::min(_line.arrival(payload), tick), _last_packet);
}

int FtdiChip::read_packet(uint8_t p_endpoint, uint8_t *r_packet, Usec p_now, Usec &r_time) {
	if (p_endpoint != IN || _is_halted) {
		return USB_STALL;
	}
	_advance(p_now);
	Usec time = _next_packet();
	if (time > p_now) {
		return USB_NAK;
	}
	const std::size_t payload = std::size_t(_description.interfaces[0].endpoints[0].packet) - STATUS_BYTES;
	if (p_now - time > Usec(_latency_ms) * 1000) {
		time = std::min(p_now, _line.arrival(payload)); // Late: not one packet for every tick that has passed.
	}
	constexpr uint8_t OVERRUN = 0x02;
	r_packet[0] = _options.is_fast ? 0x32 : 0x31;
	r_packet[1] = uint8_t(0x60U | (_has_overrun ? OVERRUN : 0U));
	const std::size_t size = _line.take(r_packet + STATUS_BYTES, payload, time);
	_line.collect(_traces, p_now);
	_has_overrun = false;
	_last_packet = time;
	r_time = time;
	return int(STATUS_BYTES + size);
}

void FtdiChip::wait(Usec p_now, Usec p_since) {
	_advance(p_now);
	const std::size_t arrived = _line.arrived(p_now);
	const std::size_t kept = _line.arrived(p_since) + KEPT;
	if (arrived > kept) {
		_line.drop(arrived - kept);
		_has_overrun = true;
	}
	// The ticks in which nobody asked are gone.
	_last_packet = std::max(_last_packet, p_now - Usec(_latency_ms) * 1000);
}

Usec FtdiChip::next_event(bool p_is_read) const {
	const Usec delivery = _deliveries.empty() ? NEVER : _deliveries.front().time;
	const Usec device = std::min(_device.next_event(), _line.next_pull(_device));
	return std::min({ delivery, device, p_is_read ? _next_packet() : NEVER });
}

void FtdiChip::clear_halt(uint8_t /*p_endpoint*/) {
	_is_halted = false;
}

void FtdiChip::plug(bool p_in, Usec p_now) {
	_line.clear();
	_traces.clear();
	_deliveries.clear();
	_out_free = 0;
	_baud = 9600;
	_format = 8;
	_modem = 0;
	_latency_ms = 16;
	_last_packet = p_now;
	_is_halted = false;
	_has_overrun = false;
	_device.power(p_in, p_now);
}

} // namespace emulator
