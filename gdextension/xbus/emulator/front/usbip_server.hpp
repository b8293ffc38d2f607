// SPDX-License-Identifier: MIT
#pragma once

#include "cable/usb_port.hpp"

#include <atomic>
#include <mutex>
#include <thread>

namespace emulator {

/// Plugs a device into the kernel's own vhci_hcd: speaks USB/IP at one end of a pair of sockets, of which the
/// kernel has the other. To the kernel and its drivers it is a device like any other.
class UsbipServer {
public:
	/// `p_index`: which of the virtual ports, from 0.
	UsbipServer(UsbPort &p_port, std::function<Usec()> p_clock, int p_index);
	~UsbipServer();
	UsbipServer(const UsbipServer &) = delete;
	UsbipServer &operator=(const UsbipServer &) = delete;

	/// Hands the kernel its end; false if it takes none.
	bool plug();
	/// Pulls the cable.
	void unplug();

private:
	struct Header;

	void _serve();
	/// One request of the kernel; false at its end.
	bool _take();
	bool _submit(const Header &p_header);
	void _unlink(const Header &p_header);
	/// Answers what the port has completed.
	bool _answer();
	bool _read(void *r_bytes, std::size_t p_size) const;
	bool _write(const void *p_bytes, std::size_t p_size) const;

	UsbPort &_port;
	std::function<Usec()> _clock;
	int _index;
	int _socket = -1;
	std::thread _thread;
	std::atomic<bool> _is_over{ false };
};

} // namespace emulator
