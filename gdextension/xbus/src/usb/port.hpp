// SPDX-License-Identifier: MIT
#pragma once

#include "usb/ftdi_protocol.hpp"
#include "usb/known_devices.hpp"
#include "usb/port_statistics.hpp"

#include <libusb.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace usb {

/// Who gets what a device says.
class PortListener {
public:
	virtual ~PortListener() = default;
	/// Bytes of the bus, without anything that the USB side added. `p_time_usec`: when the read completed,
	/// µs of CLOCK_MONOTONIC. Called in the thread that handles the events of libusb.
	virtual void take_bytes(const uint8_t *p_bytes, std::size_t p_size, uint64_t p_time_usec) = 0;
};

/// Why a device could not be opened.
struct PortFault {
	std::string text;
	/// Whether it may work a little later, without the device being plugged in anew.
	bool may_pass = false;
};

/// A device that is open: asynchronous reads and writes, several in flight.
///
/// Belongs to the thread that handles the events of libusb; only `take_bytes` is called from within them.
class Port {
public:
	/// Opens a device: finds the bulk endpoints in any interface and setting, takes the interface from the
	/// kernel's driver (which gets it back in the end), and sets an FTDI chip up.
	static std::unique_ptr<Port> open(
			libusb_device *p_device, const KnownDevice &p_known, PortListener &p_listener, PortFault &r_fault);

	Port(const Port &) = delete;
	Port &operator=(const Port &) = delete;
	~Port();

	/// Begins to read. False if not even one read could be begun.
	bool start();
	/// Sends bytes as soon as those before are gone. False where too many wait already.
	bool send(const uint8_t *p_bytes, std::size_t p_size);
	/// Sets the speed of an FTDI chip's line, bit/s. Not to be called in `take_bytes`.
	void set_baud(uint32_t p_baud);
	/// Begins to end all transfers; `is_idle` says when they have ended.
	void stop();
	/// What cannot be done within an event: ends a halt, begins reads anew.
	void look_after();

	bool is_idle() const { return _in_flight == 0; }
	/// Whether the device was unplugged.
	bool is_gone() const { return _gone; }
	/// Whether reads fail all the time, though it may still be plugged in.
	bool is_dead() const { return _is_dead; }
	void set_gone() { _gone = true; }
	bool has_baud() const { return _known.kind == DeviceLink::FTDI; }
	const std::string &serial() const { return _serial; }
	const PortStatistics &statistics() const { return _statistics; }

private:
	struct HandleCloser {
		void operator()(libusb_device_handle *p_handle) const { libusb_close(p_handle); }
	};
	struct TransferFreer {
		void operator()(libusb_transfer *p_transfer) const { libusb_free_transfer(p_transfer); }
	};
	using Handle = std::unique_ptr<libusb_device_handle, HandleCloser>;
	struct Transfer {
		std::unique_ptr<libusb_transfer, TransferFreer> transfer;
		std::vector<uint8_t> buffer;
		Port *port = nullptr;
		bool is_flying = false;
	};
	struct Endpoints {
		int interface = -1;
		int setting = 0;
		uint8_t in = 0;
		uint8_t out = 0;
		uint16_t packet_size = 64;
	};

	Port(const KnownDevice &p_known, PortListener &p_listener) : _known(p_known), _listener(p_listener) {}

	bool claim(libusb_device *p_device, PortFault &r_fault);
	bool set_up_chip(PortFault &r_fault);
	bool prepare_transfers();
	bool control(uint8_t p_request, uint16_t p_value, uint16_t p_index);
	uint16_t chip_port() const;
	bool submit(Transfer &p_transfer);
	void read_done(Transfer &p_transfer);
	void write_done(Transfer &p_transfer);

	static bool find_endpoints(libusb_device *p_device, Endpoints &r_endpoints);
	static void LIBUSB_CALL on_read(libusb_transfer *p_transfer);
	static void LIBUSB_CALL on_write(libusb_transfer *p_transfer);

	KnownDevice _known;
	PortListener &_listener;
	Handle _handle;
	Endpoints _ends;
	uint16_t _release = 0;
	std::string _serial;
	std::vector<Transfer> _reads;
	std::vector<Transfer> _writes;
	PortStatistics _statistics;
	int _in_flight = 0;
	int _failures = 0;
	bool _is_claimed = false;
	bool _is_stopping = false;
	bool _is_halted = false;
	bool _gone = false;
	bool _is_dead = false;
};

} // namespace usb
