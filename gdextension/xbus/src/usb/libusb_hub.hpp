// SPDX-License-Identifier: MIT
#pragma once

#include "usb/hub.hpp"
#include "usb/port.hpp"
#include "usb/ring.hpp"

#include <libusb.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <thread>

namespace usb {

/// Frames between the thread of libusb and whoever reads them: some seconds of a suit.
using FrameRing = Ring<xbus::SuitFrame, 512>;

/// The suits that libusb finds.
class LibusbHub final : public Hub {
public:
	explicit LibusbHub(const xbus::SessionOptions &p_options, HubListener *p_listener = nullptr);
	LibusbHub(const LibusbHub &) = delete;
	LibusbHub &operator=(const LibusbHub &) = delete;
	~LibusbHub() override;

	std::string start() override;
	void stop() override;
	std::vector<DeviceReport> report() const override;
	std::vector<HubMessage> take_messages() override;
	bool take_frame(int p_device, xbus::SuitFrame &r_frame) override;

private:
	struct Device;
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
	void give_up(Device &p_device, uint64_t p_now_usec);
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
};

} // namespace usb
