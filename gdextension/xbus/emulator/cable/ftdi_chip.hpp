// SPDX-License-Identifier: MIT
#pragma once

#include "cable/serial_line.hpp"
#include "cable/usb_device.hpp"

namespace emulator {

/// How a chip is made.
struct ChipOptions {
	uint16_t vendor = 0x0403;
	uint16_t product = 0xD38B;
	std::string serial;
	/// 480 Mbit/s with packets of 512 bytes, as the chips with an H have it.
	bool is_fast = false;
	/// Bytes take their time on the serial line.
	bool is_paced = true;
	uint64_t seed = 1;
};

/// An FTDI chip (FT232R, or an H with large packets) between USB and a serial line: two status bytes
/// before every packet, a packet at least once a latency period, divisors, purges, EEPROM.
class FtdiChip final : public UsbDevice {
public:
	FtdiChip(const ChipOptions &p_options, SerialDevice &p_device);

	const UsbDescription &description() const override { return _description; }
	int control(const UsbSetup &p_setup, uint8_t *p_data, Usec p_now) override;
	int write(uint8_t p_endpoint, const uint8_t *p_bytes, std::size_t p_size, Usec p_now) override;
	int read_packet(uint8_t p_endpoint, uint8_t *r_packet, Usec p_now, Usec &r_time) override;
	void wait(Usec p_now, Usec p_since) override;
	Usec next_event(bool p_is_read) const override;
	void clear_halt(uint8_t p_endpoint) override;
	void plug(bool p_in, Usec p_now) override;

	/// Bits a second that a divisor stands for.
	static uint32_t baud_of_divisor(uint16_t p_value, uint16_t p_index, bool p_is_fast);

	SerialLine &line() { return _line; }
	std::vector<SampleTrace> &traces() { return _traces; }
	/// Answers the data endpoints with a stall until the host clears it.
	void halt() { _is_halted = true; }

	static constexpr uint8_t IN = 0x81;
	static constexpr uint8_t OUT = 0x02;

private:
	struct Delivery {
		Usec time = 0;
		std::vector<uint8_t> bytes;
	};

	void _reset(uint16_t p_value, Usec p_now);
	int _read_register(const UsbSetup &p_setup, uint8_t *p_data) const;
	/// Moves everything on to `p_now`: what the host sent, what the device answers.
	void _advance(Usec p_now);
	int64_t _byte_nsec() const;
	bool _speeds_agree() const;
	Usec _next_packet() const;
	uint16_t _eeprom_word(uint16_t p_index) const;

	UsbDescription _description;
	ChipOptions _options;
	SerialDevice &_device;
	SerialLine _line;
	std::vector<SampleTrace> _traces;
	std::deque<Delivery> _deliveries;
	Usec _out_free = 0;
	uint32_t _baud = 9600;
	uint16_t _format = 8;
	uint16_t _modem = 0;
	int _latency_ms = 16;
	Usec _last_packet = 0;
	bool _has_overrun = false;
	bool _is_halted = false;
	Random _random;
};

} // namespace emulator
