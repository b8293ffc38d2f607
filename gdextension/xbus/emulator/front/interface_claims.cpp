// SPDX-License-Identifier: MIT
#include "front/interface_claims.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include <sys/ioctl.h>

namespace emulator {

InterfaceClaims::InterfaceClaims(
		const UsbPort &p_port, std::string p_driver, UsbPort::Log p_log, SetDriver p_set_driver) :
		_port(p_port), _driver(std::move(p_driver)), _log(std::move(p_log)), _set_driver(std::move(p_set_driver)) {}

void InterfaceClaims::begin() {
	_bound.clear();
	for (unsigned i = 0; i < _port.description().interface_count(); i++) {
		// The kernel's driver for native devices takes the second interface and no other.
		if (_driver != "xsens_mt" || i == 1) {
			_bind(i);
		}
	}
}

InterfaceClaims::Result InterfaceClaims::claim(const void *p_program, unsigned p_interface) {
	if (p_interface >= _port.description().interface_count()) {
		return -ENOENT;
	}
	const auto claimed = _claimed.find(p_program);
	if (claimed != _claimed.end() && claimed->second.count(p_interface) > 0) {
		return 0;
	}
	if (_bound.count(p_interface) > 0 || _is_claimed(p_interface)) {
		_log("claim " + std::to_string(p_interface) + " refused");
		return -EBUSY;
	}
	_claimed[p_program].insert(p_interface);
	_log("claim " + std::to_string(p_interface));
	return 0;
}

InterfaceClaims::Result InterfaceClaims::release(const void *p_program, unsigned p_interface) {
	if (_claimed[p_program].erase(p_interface) == 0) {
		return -EINVAL;
	}
	_log("release " + std::to_string(p_interface));
	return 0;
}

InterfaceClaims::Result InterfaceClaims::tell_driver(usbdevfs_getdriver &r_asked) const {
	const bool is_bound = _bound.count(r_asked.interface) > 0;
	if (!is_bound && !_is_claimed(r_asked.interface)) {
		return -ENODATA;
	}
	std::memset(r_asked.driver, 0, sizeof(r_asked.driver));
	const std::string name = is_bound ? _driver : "usbfs";
	std::memcpy(r_asked.driver, name.data(), std::min(name.size(), sizeof(r_asked.driver) - 1));
	return 0;
}

InterfaceClaims::Result InterfaceClaims::ask_driver(const usbdevfs_ioctl &p_asked) {
	const auto number = unsigned(p_asked.ifno);
	if (number >= _port.description().interface_count()) {
		return -EINVAL;
	}
	switch (unsigned(p_asked.ioctl_code)) {
		case USBDEVFS_DISCONNECT:
			return _unbind(number);
		case USBDEVFS_CONNECT:
			return _bind(number);
		default:
			return -ENOTTY;
	}
}

InterfaceClaims::Result InterfaceClaims::disconnect_and_claim(
		const void *p_program, const usbdevfs_disconnect_claim &p_asked) {
	const unsigned number = p_asked.interface;
	const bool is_named = strncmp(p_asked.driver, _driver.c_str(), sizeof(p_asked.driver)) == 0;
	if (_bound.count(number) > 0) {
		if ((p_asked.flags & USBDEVFS_DISCONNECT_CLAIM_IF_DRIVER) != 0 && !is_named) {
			return -EBUSY;
		}
		if ((p_asked.flags & USBDEVFS_DISCONNECT_CLAIM_EXCEPT_DRIVER) != 0 && is_named) {
			return -EBUSY;
		}
		_unbind(number);
	}
	return claim(p_program, number);
}

bool InterfaceClaims::_is_claimed(unsigned p_interface) const {
	const auto has = [p_interface](const auto &p_pair) { return p_pair.second.count(p_interface) > 0; };
	return std::any_of(_claimed.begin(), _claimed.end(), has);
}

InterfaceClaims::Result InterfaceClaims::_unbind(unsigned p_interface) {
	if (_bound.erase(p_interface) == 0) {
		return -ENODATA;
	}
	_log("driver detached " + std::to_string(p_interface));
	_set_driver(p_interface, false);
	return 0;
}

InterfaceClaims::Result InterfaceClaims::_bind(unsigned p_interface) {
	if (_is_claimed(p_interface)) {
		return -EBUSY;
	}
	if (_bound.insert(p_interface).second) {
		_log("driver attached " + std::to_string(p_interface));
		_set_driver(p_interface, true);
		return 1;
	}
	return 0;
}

} // namespace emulator
