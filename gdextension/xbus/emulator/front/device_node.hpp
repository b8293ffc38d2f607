// SPDX-License-Identifier: MIT
#pragma once

#include "cable/usb_device.hpp"

#include <memory>

#include <umockdev.h>

namespace emulator {

/// The system that programs under umockdev see: /sys, /dev, messages of udev.
class Testbed {
public:
	/// `p_is_forbidden`: nobody may open the devices.
	explicit Testbed(bool p_is_forbidden);
	~Testbed();
	Testbed(const Testbed &) = delete;
	Testbed &operator=(const Testbed &) = delete;

	const std::string &root() const { return _root; }
	bool is_forbidden() const { return _is_forbidden; }
	/// umockdev's library for programs, to be loaded before all others.
	static std::string preload();
	UMockdevTestbed *raw() { return _testbed; }
	/// The next number of a device on the bus: a device that comes back has another.
	int next_device_number() { return ++_last_device; }

private:
	UMockdevTestbed *_testbed;
	std::string _root;
	bool _is_forbidden;
	int _last_device = 1;
};

/// One device from when it is plugged in: its entries in /sys, its node, the gate at the node.
class DeviceNode {
public:
	/// `p_index`: where it is plugged in, from 1. `p_driver`: the kernel's driver for its interfaces.
	DeviceNode(Testbed &p_testbed, const UsbDescription &p_description, int p_index, std::string p_driver,
			UMockdevIoctlBase *p_handler);
	~DeviceNode();
	DeviceNode(const DeviceNode &) = delete;
	DeviceNode &operator=(const DeviceNode &) = delete;

	/// Notifies udev's listeners that the device is there.
	void announce();
	/// Takes it out of the system and notifies the listeners. Who has the node open can still be woken.
	void leave();
	/// Whether programs that poll the node find it ready. libusb does so to learn that a transfer is over.
	void set_ready(bool p_is_ready);
	/// Links an interface to the driver in /sys, or not; false if that cannot be.
	bool set_driver(unsigned p_interface, bool p_is_bound);

private:
	std::string _interface_path(unsigned p_interface) const;
	std::string _text(const UsbDescription &p_description) const;
	void _make_gate();

	Testbed &_testbed;
	int _index;
	int _number;
	std::string _driver;
	std::string _syspath;
	std::string _devnode;
	uint8_t _interfaces;
	int _gate = -1;
	bool _is_ready = true;
	bool _has_left = false;
};

} // namespace emulator
