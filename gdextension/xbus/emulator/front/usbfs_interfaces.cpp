// SPDX-License-Identifier: MIT
// What usbfs says of interfaces and of the kernel's drivers that have them.
#include "front/usbfs_node.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <linux/usbdevice_fs.h>
#include <sys/ioctl.h>

namespace emulator {

template <class T>
T *UsbfsNode::_argument(UMockdevIoctlClient *p_client) {
	UMockdevIoctlData *argument = umockdev_ioctl_client_get_arg(p_client);
	UMockdevIoctlData *data = umockdev_ioctl_data_resolve(argument, 0, sizeof(T), nullptr);
	return data == nullptr ? nullptr : reinterpret_cast<T *>(data->data);
}

UsbfsNode::Result UsbfsNode::_dispatch(UMockdevIoctlClient *p_client, unsigned p_request) {
	switch (p_request) {
		case USBDEVFS_REAPURB:
		case USBDEVFS_REAPURBNDELAY:
			return _reap(p_client, p_request == USBDEVFS_REAPURB);
		default:
			break;
	}
	if (!_port.is_plugged()) {
		return -ENODEV;
	}
	switch (p_request) {
		case USBDEVFS_SUBMITURB:
			return _submit(p_client);
		case USBDEVFS_DISCARDURB:
			return _discard(p_client);
		case USBDEVFS_CONTROL:
			return _control(p_client);
		case USBDEVFS_GET_CAPABILITIES: {
			auto *capabilities = _argument<uint32_t>(p_client);
			if (capabilities == nullptr) {
				return -EFAULT;
			}
			*capabilities =
					USBDEVFS_CAP_ZERO_PACKET | USBDEVFS_CAP_NO_PACKET_SIZE_LIM | USBDEVFS_CAP_REAP_AFTER_DISCONNECT;
			return 0;
		}
		case USBDEVFS_RESET:
			_log("reset");
			_port.discard_all(-ENOENT);
			return 0;
		case USBDEVFS_GET_SPEED:
			return _port.description().speed == 480 ? 3 : 2;
		default:
			return _dispatch_interface(p_client, p_request);
	}
}

UsbfsNode::Result UsbfsNode::_dispatch_interface(UMockdevIoctlClient *p_client, unsigned p_request) {
	Opened &opened = _opened[p_client];
	switch (p_request) {
		case USBDEVFS_GETDRIVER:
			return _tell_driver(p_client);
		case USBDEVFS_IOCTL:
			return _driver_ioctl(p_client);
		case USBDEVFS_DISCONNECT_CLAIM:
			return _disconnect_and_claim(p_client);
		default:
			break;
	}
	const auto *number = _argument<unsigned>(p_client);
	if (number == nullptr) {
		return p_request == USBDEVFS_CONNECTINFO ? -ENOTTY : -EFAULT;
	}
	switch (p_request) {
		case USBDEVFS_CLAIMINTERFACE:
			return _claim(opened, *number);
		case USBDEVFS_RELEASEINTERFACE:
			return _release(opened, *number);
		case USBDEVFS_CLEAR_HALT:
		case USBDEVFS_RESETEP:
			_log("clear halt " + std::to_string(*number));
			_port.clear_halt(uint8_t(*number));
			return 0;
		case USBDEVFS_SETINTERFACE:
		case USBDEVFS_SETCONFIGURATION:
			return 0;
		default:
			return -ENOTTY;
	}
}

bool UsbfsNode::_is_claimed(unsigned p_interface) const {
	const auto has = [p_interface](const auto &p_pair) { return p_pair.second.claimed.count(p_interface) > 0; };
	return std::any_of(_opened.begin(), _opened.end(), has);
}

UsbfsNode::Result UsbfsNode::_claim(Opened &r_opened, unsigned p_interface) {
	if (p_interface >= _port.description().interface_count()) {
		return -ENOENT;
	}
	if (r_opened.claimed.count(p_interface) > 0) {
		return 0;
	}
	if (_bound.count(p_interface) > 0 || _is_claimed(p_interface)) {
		_log("claim " + std::to_string(p_interface) + " refused");
		return -EBUSY;
	}
	r_opened.claimed.insert(p_interface);
	_log("claim " + std::to_string(p_interface));
	return 0;
}

UsbfsNode::Result UsbfsNode::_release(Opened &r_opened, unsigned p_interface) {
	if (r_opened.claimed.erase(p_interface) == 0) {
		return -EINVAL;
	}
	_log("release " + std::to_string(p_interface));
	return 0;
}

UsbfsNode::Result UsbfsNode::_tell_driver(UMockdevIoctlClient *p_client) {
	auto *asked = _argument<usbdevfs_getdriver>(p_client);
	if (asked == nullptr) {
		return -EFAULT;
	}
	const bool is_bound = _bound.count(asked->interface) > 0;
	if (!is_bound && !_is_claimed(asked->interface)) {
		return -ENODATA;
	}
	std::memset(asked->driver, 0, sizeof(asked->driver));
	const std::string name = is_bound ? _driver : "usbfs";
	std::memcpy(asked->driver, name.data(), std::min(name.size(), sizeof(asked->driver) - 1));
	return 0;
}

UsbfsNode::Result UsbfsNode::_unbind(unsigned p_interface) {
	if (_bound.erase(p_interface) == 0) {
		return -ENODATA;
	}
	_log("driver detached " + std::to_string(p_interface));
	_node->set_driver(p_interface, false);
	return 0;
}

UsbfsNode::Result UsbfsNode::_bind(unsigned p_interface) {
	if (_is_claimed(p_interface)) {
		return -EBUSY;
	}
	if (_bound.insert(p_interface).second) {
		_log("driver attached " + std::to_string(p_interface));
		_node->set_driver(p_interface, true);
		return 1;
	}
	return 0;
}

UsbfsNode::Result UsbfsNode::_driver_ioctl(UMockdevIoctlClient *p_client) {
	const auto *asked = _argument<usbdevfs_ioctl>(p_client);
	if (asked == nullptr) {
		return -EFAULT;
	}
	const auto number = unsigned(asked->ifno);
	if (number >= _port.description().interface_count()) {
		return -EINVAL;
	}
	switch (unsigned(asked->ioctl_code)) {
		case USBDEVFS_DISCONNECT:
			return _unbind(number);
		case USBDEVFS_CONNECT:
			return _bind(number);
		default:
			return -ENOTTY;
	}
}

UsbfsNode::Result UsbfsNode::_disconnect_and_claim(UMockdevIoctlClient *p_client) {
	const auto *asked = _argument<usbdevfs_disconnect_claim>(p_client);
	if (asked == nullptr) {
		return -EFAULT;
	}
	const unsigned number = asked->interface;
	const bool is_named = strncmp(asked->driver, _driver.c_str(), sizeof(asked->driver)) == 0;
	if (_bound.count(number) > 0) {
		if ((asked->flags & USBDEVFS_DISCONNECT_CLAIM_IF_DRIVER) != 0 && !is_named) {
			return -EBUSY;
		}
		if ((asked->flags & USBDEVFS_DISCONNECT_CLAIM_EXCEPT_DRIVER) != 0 && is_named) {
			return -EBUSY;
		}
		_unbind(number);
	}
	return _claim(_opened[p_client], number);
}

} // namespace emulator
