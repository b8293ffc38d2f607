// SPDX-License-Identifier: MIT
#pragma once

#include "cable/serial_line.hpp"
#include "cable/usb_device.hpp"

namespace emulator {

/// A device with bulk endpoints of its own, as the MTi-10 and MTi-100 series have them. They are on the
/// second interface and have numbers that nobody would guess: a host has to look for them.
class NativeChip final : public UsbDevice {
public:
	NativeChip(uint16_t p_product, const std::string &p_serial, uint64_t p_seed, SerialDevice &p_device);

	const UsbDescription &description() const override { return _description; }
	int control(const UsbSetup &p_setup, uint8_t *p_data, Usec p_now) override;
	int write(uint8_t p_endpoint, const uint8_t *p_bytes, std::size_t p_size, Usec p_now) override;
	int read_packet(uint8_t p_endpoint, uint8_t *r_packet, Usec p_now, Usec &r_time) override;
	void wait(Usec p_now, Usec p_since) override;
	Usec next_event(bool p_is_read) const override;
	void clear_halt(uint8_t p_endpoint) override;
	void plug(bool p_in, Usec p_now) override;

	SerialLine &line() { return _line; }
	std::vector<SampleTrace> &traces() { return _traces; }
	/// Answers the data endpoints with a stall until the host clears it.
	void halt() { _is_halted = true; }

	static constexpr uint8_t IN = 0x83;
	static constexpr uint8_t OUT = 0x04;

private:
	void _advance(Usec p_now);

	UsbDescription _description;
	SerialDevice &_device;
	SerialLine _line;
	std::vector<SampleTrace> _traces;
	bool _is_halted = false;
};

} // namespace emulator
