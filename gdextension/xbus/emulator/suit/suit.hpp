// SPDX-License-Identifier: MIT
#pragma once

#include "cable/ftdi_chip.hpp"
#include "cable/native_chip.hpp"
#include "cable/usb_port.hpp"
#include "suit/master.hpp"
#include "suit/stand_alone.hpp"
#include "suit/suit_options.hpp"

#include <memory>

namespace emulator {

/// One USB device of the suit: what is at the end of the cable, the chip, the host's port.
struct SuitDevice {
	std::unique_ptr<XbusDevice> device;
	std::unique_ptr<UsbDevice> chip;
	std::unique_ptr<UsbPort> port;
	/// The same, where it is of this kind.
	Master *master = nullptr;
	FtdiChip *ftdi = nullptr;
	NativeChip *native = nullptr;

	SerialLine &line() { return ftdi != nullptr ? ftdi->line() : native->line(); }
	std::vector<SampleTrace> &traces() { return ftdi != nullptr ? ftdi->traces() : native->traces(); }
	/// The kernel's driver for such a device.
	std::string kernel_driver() const { return ftdi != nullptr ? "ftdi_sio" : "xsens_mt"; }
};

/// All devices that a person wears, made from the options. Knows no system: its fronts do.
class Suit {
public:
	/// A line for the log: time, number of the device from 1, what happened.
	using Log = std::function<void(Usec, std::size_t, const std::string &)>;

	/// `p_stream`: the motion; sensors that are more than its limbs share them.
	Suit(const SuitOptions &p_options, MotionStream p_stream, std::function<Usec()> p_clock, Log p_log);

	/// What is wrong with the options, or an empty text.
	const std::string &error() const { return _error; }
	std::vector<SuitDevice> &devices() { return _devices; }
	/// The wearer stands in the first pose, until a device has measured for a moment or, with --hold, until a command.
	void begin(Usec p_now);
	void advance(Usec p_now);
	Usec next_event() const;

	/// Does what a line of text says, as "corrupt 0.001", "error 2a", "mute", "battery 40". Returns an empty
	/// text or what is wrong; `r_is_known` is false for what the suit alone cannot do.
	std::string command(const std::string &p_line, Usec p_now, bool &r_is_known);

private:
	/// "hold", "go", "calibrate", "clip", "motion SECONDS"; false if it is none of them.
	bool _move(const std::string &p_name, double p_value, Usec p_since);
	/// All the other commands, for one device; false if it is none.
	static bool _disturb(SuitDevice &r_device, const std::string &p_name, double p_value, Usec p_now);
	std::string _make(const std::string &p_kind, std::vector<Tracker> p_trackers);
	std::string _read_mountings(std::vector<Tracker> &r_trackers) const;
	std::string _make_trackers(std::vector<Tracker> &r_trackers);
	std::string _make_all(std::vector<Tracker> p_trackers);
	void _add(std::unique_ptr<XbusDevice> p_device, const std::string &p_kind, uint16_t p_product);

	SuitOptions _options;
	MotionStream _stream;
	std::function<Usec()> _clock;
	Log _log;
	Random _random;
	std::string _error;
	std::vector<SuitDevice> _devices;
	bool _waits = true;
};

} // namespace emulator
