// SPDX-License-Identifier: MIT
#pragma once

#include "clock/clock.hpp"
#include "usb/libusb_hub.hpp"

namespace usb {

/// A device that is there, open or not.
struct LibusbHub::Device final : public PortListener, public xbus::SessionHost {
	LibusbHub &hub;
	libusb_device *device;
	DeviceReport report;
	std::unique_ptr<Port> port;
	std::unique_ptr<xbus::Session> session;
	std::shared_ptr<FrameRing> frames = std::make_shared<FrameRing>();
	uint64_t retry_usec = 0;
	uint32_t wanted_baud = 0;
	bool is_leaving = false;

	Device(LibusbHub &p_hub, libusb_device *p_device) : hub(p_hub), device(libusb_ref_device(p_device)) {}
	Device(const Device &) = delete;
	Device &operator=(const Device &) = delete;
	~Device() override {
		if (port != nullptr && !port->is_idle()) {
			// libusb still holds transfers of it: rather lost than used after it is gone.
			const Port *const lost = port.release();
			static_cast<void>(lost);
		}
		port.reset();
		libusb_unref_device(device);
	}

	void take_bytes(const uint8_t *p_bytes, std::size_t p_size, uint64_t p_time_usec) override {
		if (hub._listener != nullptr) {
			hub._listener->take_raw(report.number, false, p_bytes, p_size, p_time_usec);
		}
		session->take_bytes(p_bytes, p_size, p_time_usec);
	}

	bool send(const uint8_t *p_bytes, std::size_t p_size) override {
		if (hub._listener != nullptr) {
			hub._listener->take_raw(report.number, true, p_bytes, p_size, clocks::now_usec());
		}
		return port->send(p_bytes, p_size);
	}

	// Not at once: it takes a request of its own, which an event must not wait for.
	void set_baud(uint32_t p_baud) override { wanted_baud = p_baud; }

	void take_frame(const xbus::SuitFrame &p_frame) override {
		if (hub._listener != nullptr) {
			hub._listener->take_frame(report.number, p_frame);
		}
		if (xbus::SuitFrame *entry = frames->claim(); entry != nullptr) {
			*entry = p_frame;
			frames->publish();
		} else {
			++report.overruns;
		}
	}

	void say(xbus::Severity p_severity, const char *p_text) override { hub.say(p_severity, name() + ": " + p_text); }

	std::string name() const { return std::string(report.known.name) + " at " + report.address; }
};

} // namespace usb
