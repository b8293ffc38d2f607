// SPDX-License-Identifier: MIT
#pragma once

#include "cable/usb_port.hpp"

#include <functional>
#include <map>
#include <set>
#include <string>

#include <linux/usbdevice_fs.h>

namespace emulator {

/// Who has which interface of a device, as usbfs keeps it: the kernel's driver, or a program that claimed it.
/// Results are those of the ioctls: 0 or more, or a negative errno.
class InterfaceClaims {
public:
	using Result = long;
	/// Links an interface to the driver in /sys, or not.
	using SetDriver = std::function<void(unsigned p_interface, bool p_is_bound)>;

	/// `p_driver`: the kernel's driver that takes the interfaces first.
	InterfaceClaims(const UsbPort &p_port, std::string p_driver, UsbPort::Log p_log, SetDriver p_set_driver);

	/// The device has come: the kernel's driver takes its interfaces.
	void begin();
	/// A program, or each, has let go of what it claimed.
	void forget(const void *p_program) { _claimed.erase(p_program); }
	void forget_all() { _claimed.clear(); }

	/// USBDEVFS_CLAIMINTERFACE, USBDEVFS_RELEASEINTERFACE.
	Result claim(const void *p_program, unsigned p_interface);
	Result release(const void *p_program, unsigned p_interface);
	/// USBDEVFS_GETDRIVER: writes the name of who has an interface.
	Result tell_driver(usbdevfs_getdriver &r_asked) const;
	/// USBDEVFS_IOCTL, of which there are DISCONNECT and CONNECT: the driver lets go of an interface, or takes it.
	Result ask_driver(const usbdevfs_ioctl &p_asked);
	/// USBDEVFS_DISCONNECT_CLAIM: both at once.
	Result disconnect_and_claim(const void *p_program, const usbdevfs_disconnect_claim &p_asked);

private:
	bool _is_claimed(unsigned p_interface) const;
	Result _unbind(unsigned p_interface);
	Result _bind(unsigned p_interface);

	const UsbPort &_port;
	std::string _driver;
	UsbPort::Log _log;
	SetDriver _set_driver;
	/// Interfaces that the kernel's driver has.
	std::set<unsigned> _bound;
	/// Interfaces that programs have.
	std::map<const void *, std::set<unsigned>> _claimed;
};

} // namespace emulator
