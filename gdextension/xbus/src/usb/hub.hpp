// SPDX-License-Identifier: MIT
#pragma once

#include "session/session.hpp"
#include "usb/known_devices.hpp"
#include "usb/port.hpp"
#include "usb/ring.hpp"

#include <libusb.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace usb {

/// Frames between the thread of libusb and whoever reads them: some seconds of a suit.
using FrameRing = Ring<xbus::SuitFrame, 512>;

/// What is known of a device, for people and for logs.
struct DeviceReport {
	/// Counts the devices of this hub; a device that is plugged in anew is a new one.
	int number = 0;
	KnownDevice known{};
	/// Bus and address, as in /dev/bus/usb/001/004.
	std::string place;
	std::string serial;
	/// Why it does not work, and what to do about it; empty while it does.
	std::string fault;
	xbus::SessionReport session;
	PortStatistics port;
	/// Frames that nobody fetched in time.
	uint64_t overruns = 0;
	bool is_open = false;
};

/// One line for the log.
struct HubMessage {
	xbus::Severity severity = xbus::Severity::INFO;
	std::string text;
};

/// Who hears of everything at once. All calls come from the hub's thread.
class HubListener {
public:
	virtual ~HubListener() = default;
	/// A sample of all trackers of a device.
	virtual void take_frame(int p_device, const xbus::SuitFrame &p_frame) = 0;
	/// Bytes of the bus as they come in (or go out), µs of CLOCK_MONOTONIC.
	virtual void take_raw(int p_device, bool p_is_out, const uint8_t *p_bytes, std::size_t p_size,
			uint64_t p_time_usec) = 0;
	/// A device was opened.
	virtual void device_opened(const DeviceReport &p_report) = 0;
};

/// All suits on this machine: finds devices as they come and go, brings their masters to measuring, and hands
/// their samples on. Everything on the USB side happens in one thread of its own.
class Hub {
public:
	explicit Hub(const xbus::SessionOptions &p_options, HubListener *p_listener = nullptr);
	Hub(const Hub &) = delete;
	Hub &operator=(const Hub &) = delete;
	~Hub();

	/// Begins. Returns why it can't, or an empty text.
	std::string start();
	/// Lets all devices stop measuring, gives them back and ends the thread.
	void stop();

	/// All devices that are there. Renewed some times a second.
	std::vector<DeviceReport> report() const;
	/// What was said since the last call.
	std::vector<HubMessage> take_messages();
	/// The oldest frame of a device that was not taken yet; false if there is none. For one thread.
	bool take_frame(int p_device, xbus::SuitFrame &r_frame);
	/// Asks all trackers of a device to take their present orientation as `p_method` says.
	void reset_orientation(int p_device, xbus::ResetMethod p_method);

private:
	struct Device;
	struct Command {
		int device = 0;
		xbus::ResetMethod method{};
	};
	struct Change {
		libusb_device *device = nullptr;
		bool has_come = false;
	};
	struct Queue {
		int device = 0;
		std::shared_ptr<FrameRing> ring;
	};

	void run();
	void look_for_changes();
	void poll_devices();
	void add(libusb_device *p_device);
	void remove(libusb_device *p_device);
	void advance(Device &p_device, uint64_t p_now_usec);
	void open(Device &p_device, uint64_t p_now_usec);
	void obey();
	void publish();
	void say(xbus::Severity p_severity, const std::string &p_text);
	void close_all();
	static int LIBUSB_CALL on_hotplug(
			libusb_context *p_context, libusb_device *p_device, libusb_hotplug_event p_event, void *p_self);

	const xbus::SessionOptions _options;
	HubListener *const _listener;
	std::unique_ptr<libusb_context, void (*)(libusb_context *)> _context;
	libusb_hotplug_callback_handle _hotplug = 0;
	bool _has_hotplug = false;
	std::thread _thread;
	std::atomic<bool> _stops{ false };
	// Of the hub's thread alone.
	std::vector<Change> _changes;
	std::vector<std::unique_ptr<Device>> _devices;
	int _next_number = 0;
	uint64_t _polled_usec = 0;
	uint64_t _published_usec = 0;
	// Shared with who asks, and guarded.
	mutable std::mutex _mutex;
	std::vector<DeviceReport> _reports;
	std::vector<Queue> _queues;
	std::vector<HubMessage> _messages;
	std::vector<Command> _commands;
};

} // namespace usb
