// SPDX-License-Identifier: MIT
#pragma once

#include "session/session.hpp"
#include "usb/known_devices.hpp"
#include "usb/port_statistics.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace usb {

/// What is known of a device, for people and for logs.
struct DeviceReport {
	/// Counts the devices of this hub; a device that is plugged in anew is a new one.
	int number = 0;
	KnownDevice known{};
	/// Bus and address, as in /dev/bus/usb/001/004.
	std::string address;
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
	virtual void take_raw(
			int p_device, bool p_is_out, const uint8_t *p_bytes, std::size_t p_size, uint64_t p_time_usec) = 0;
	/// A device was opened.
	virtual void device_opened(const DeviceReport &p_report) = 0;
};

/// All suits on this machine: finds devices as they come and go, brings their masters to measuring, and hands
/// their samples on. Everything on the USB side happens in one thread of its own.
class Hub {
public:
	virtual ~Hub() = default;

	/// Begins. Returns why it can't, or an empty text.
	virtual std::string start() = 0;
	/// Lets all devices stop measuring, gives them back and ends the thread.
	virtual void stop() = 0;

	/// All devices that are there. Renewed some times a second.
	virtual std::vector<DeviceReport> report() const = 0;
	/// What was said since the last call.
	virtual std::vector<HubMessage> take_messages() = 0;
	/// The oldest frame of a device that was not taken yet; false if there is none. For one thread.
	virtual bool take_frame(int p_device, xbus::SuitFrame &r_frame) = 0;
};

} // namespace usb
