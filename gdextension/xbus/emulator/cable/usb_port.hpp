// SPDX-License-Identifier: MIT
#pragma once

#include "cable/usb_device.hpp"

#include <deque>
#include <functional>
#include <map>
#include <memory>

namespace emulator {

/// A transfer that the host has asked for.
struct Urb {
	enum class Type : uint8_t {
		ISOCHRONOUS,
		INTERRUPT,
		CONTROL,
		BULK
	};

	/// By which its owner knows it.
	uint64_t id = 0;
	Type type = Type::BULK;
	/// With bit 7 set: to the host.
	uint8_t endpoint = 0;
	UsbSetup setup;
	/// What goes, or room for what comes.
	std::vector<uint8_t> data;
	/// Bytes that went.
	std::size_t done = 0;
	/// 0, or a negative errno, as the kernel reports it.
	int status = 0;
};

/// A socket of the host: keeps the transfers of one device and completes them as its time goes on.
class UsbPort {
public:
	using Log = std::function<void(const std::string &)>;

	UsbPort(UsbDevice &p_device, Log p_log);

	bool is_plugged() const { return _is_plugged; }
	/// Puts the device in, or takes it out: every transfer then ends with ESHUTDOWN.
	void plug(bool p_in, Usec p_now);
	/// Starts a transfer; 0 or a negative errno where it cannot even be queued.
	int submit(std::unique_ptr<Urb> p_urb, Usec p_now);
	/// Ends a waiting transfer with `p_status`; false where there is none of that number.
	bool discard(uint64_t p_id, int p_status);
	void discard_all(int p_status);
	/// Completes what can be completed by now.
	void advance(Usec p_now);
	/// When there will be something to do next.
	Usec next_event() const;

	/// The next transfer that is over, or null.
	std::unique_ptr<Urb> take_completed();
	/// The host asks for an end of a stall.
	void clear_halt(uint8_t p_endpoint);

	const UsbDescription &description() const { return _device.description(); }

private:
	using Queue = std::deque<std::unique_ptr<Urb>>;

	void _complete(std::unique_ptr<Urb> p_urb, int p_status);
	void _control(std::unique_ptr<Urb> p_urb, Usec p_now);
	/// Moves on one endpoint to the host.
	void _serve(uint8_t p_endpoint, Queue &r_queue, Usec p_now);

	UsbDevice &_device;
	Log _log;
	bool _is_plugged = false;
	/// When it was last seen that somebody reads.
	Usec _last_read = 0;
	std::map<uint8_t, Queue> _reads;
	Queue _completed;
};

} // namespace emulator
