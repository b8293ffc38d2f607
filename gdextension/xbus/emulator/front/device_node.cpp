// SPDX-License-Identifier: MIT
#include "front/device_node.hpp"

#include <array>
#include <cstdio>
#include <stdexcept>
#include <utility>

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace emulator {
namespace {

std::string hex(const std::vector<uint8_t> &p_bytes) {
	std::string text;
	text.reserve(p_bytes.size() * 2);
	for (const uint8_t byte : p_bytes) {
		std::array<char, 4> digits{};
		(void)snprintf(digits.data(), digits.size(), "%02X", byte);
		text += digits.data();
	}
	return text;
}

std::string decimal(int p_value, int p_count) {
	std::array<char, 16> text{};
	(void)snprintf(text.data(), text.size(), "%0*d", p_count, p_value);
	return text.data();
}

std::string hex4(unsigned p_value) {
	std::array<char, 16> text{};
	(void)snprintf(text.data(), text.size(), "%04x", p_value);
	return text.data();
}

std::string attribute(const std::string &p_name, const std::string &p_value) {
	return "A: " + p_name + "=" + p_value + "\\n\n";
}

std::string property(const std::string &p_name, const std::string &p_value) {
	return "E: " + p_name + "=" + p_value + "\n";
}

} // namespace

Testbed::Testbed(bool p_is_forbidden) : _testbed(umockdev_testbed_new()), _is_forbidden(p_is_forbidden) {
	char *root = umockdev_testbed_get_root_dir(_testbed);
	_root = root == nullptr ? "" : root;
	g_free(root);
}

Testbed::~Testbed() {
	g_object_unref(_testbed);
}

std::string Testbed::preload() {
	// It must be of the same version as the library, so it is looked for beside it.
	Dl_info info{};
	std::string name = "libumockdev-preload.so.0";
	if (dladdr(reinterpret_cast<const void *>(&umockdev_testbed_new), &info) == 0 || info.dli_fname == nullptr) {
		return name;
	}
	const std::string library = info.dli_fname;
	std::string beside = library.substr(0, library.rfind('/') + 1) + name;
	return access(beside.c_str(), R_OK) == 0 ? beside : name;
}

DeviceNode::DeviceNode(Testbed &p_testbed, const UsbDescription &p_description, int p_index, std::string p_driver,
		UMockdevIoctlBase *p_handler) :
		_testbed(p_testbed),
		_index(p_index),
		_number(p_testbed.next_device_number()),
		_driver(std::move(p_driver)),
		_syspath("/sys/devices/pci0000:00/0000:00:14.0/usb1/1-" + std::to_string(p_index)),
		_devnode("/dev/bus/usb/001/" + decimal(_number, 3)),
		_interfaces(p_description.interface_count()) {
	GError *error = nullptr;
	umockdev_testbed_add_from_string(_testbed.raw(), _text(p_description).c_str(), &error);
	if (error == nullptr) {
		umockdev_testbed_attach_ioctl(_testbed.raw(), _devnode.c_str(), p_handler, &error);
	}
	if (error != nullptr) {
		const std::string what = error->message;
		g_error_free(error);
		throw std::runtime_error("umockdev takes no device: " + what);
	}
	_make_gate();
}

std::string DeviceNode::_text(const UsbDescription &p_description) const {
	const std::string path = _syspath.substr(4);
	std::vector<uint8_t> descriptors = p_description.device_bytes();
	const std::vector<uint8_t> configuration = p_description.configuration_bytes();
	descriptors.insert(descriptors.end(), configuration.begin(), configuration.end());
	const std::string vendor = hex4(p_description.vendor);
	const std::string product = hex4(p_description.product);
	const std::string minor = std::to_string(_number - 1);
	std::string text = "P: " + path + "\nN: " + _devnode.substr(5) + "\n";
	text += property("SUBSYSTEM", "usb") + property("DEVTYPE", "usb_device") + property("DEVNAME", _devnode);
	text += property("BUSNUM", "001") + property("DEVNUM", decimal(_number, 3)) + property("MAJOR", "189");
	text += property("MINOR", minor) + property("PRODUCT", vendor + "/" + product + "/600");
	text += attribute("dev", "189:" + minor) + attribute("busnum", "1") + attribute("devnum", std::to_string(_number));
	text += attribute("devpath", std::to_string(_index)) + attribute("bConfigurationValue", "1");
	text += attribute("speed", std::to_string(p_description.speed)) + attribute("idVendor", vendor);
	text += attribute("idProduct", product) + attribute("manufacturer", p_description.manufacturer);
	text += attribute("product", p_description.product_name);
	text += p_description.serial.empty() ? "" : attribute("serial", p_description.serial);
	text += "H: descriptors=" + hex(descriptors) + "\n";
	for (unsigned i = 0; i < _interfaces; i++) {
		text += "\nP: " + _interface_path(i).substr(4) + "\n";
		text += property("SUBSYSTEM", "usb") + property("DEVTYPE", "usb_interface");
		text += attribute("bInterfaceNumber", decimal(int(i), 2));
	}
	return text + "\n";
}

void DeviceNode::leave() {
	if (_has_left) {
		return;
	}
	_has_left = true;
	// The kernel's order: the node goes, then udev's listeners learn it.
	unlink((_testbed.root() + _devnode).c_str());
	umockdev_testbed_uevent(_testbed.raw(), _syspath.c_str(), "remove");
	GError *error = nullptr;
	umockdev_testbed_detach_ioctl(_testbed.raw(), _devnode.c_str(), &error);
	g_clear_error(&error);
	for (unsigned i = 0; i < _interfaces; i++) {
		set_driver(i, false);
		umockdev_testbed_remove_device(_testbed.raw(), _interface_path(i).c_str());
	}
	umockdev_testbed_remove_device(_testbed.raw(), _syspath.c_str());
}

DeviceNode::~DeviceNode() {
	leave();
	if (_gate >= 0) {
		close(_gate);
	}
}

void DeviceNode::announce() {
	umockdev_testbed_uevent(_testbed.raw(), _syspath.c_str(), "add");
}

std::string DeviceNode::_interface_path(unsigned p_interface) const {
	return _syspath + "/1-" + std::to_string(_index) + ":1." + std::to_string(p_interface);
}

void DeviceNode::_make_gate() {
	// umockdev's node is a plain file, which is always ready: libusb would turn in circles. A pipe of one
	// page is ready for writing only while it is empty.
	constexpr int PAGE = 4096;
	const std::string path = _testbed.root() + _devnode;
	unlink(path.c_str());
	if (mkfifo(path.c_str(), 0666) != 0) {
		throw std::runtime_error("cannot make " + path);
	}
	_gate = open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
	if (_gate < 0 || fcntl(_gate, F_SETPIPE_SZ, PAGE) < 0) {
		throw std::runtime_error("cannot open " + path);
	}
	if (chmod(path.c_str(), _testbed.is_forbidden() ? 0000 : 0666) != 0) {
		throw std::runtime_error("cannot change " + path);
	}
	set_ready(false);
}

void DeviceNode::set_ready(bool p_is_ready) {
	char byte = 0;
	if (p_is_ready == _is_ready || _gate < 0) {
		return;
	}
	const ssize_t went = p_is_ready ? read(_gate, &byte, 1) : write(_gate, &byte, 1);
	_is_ready = went == 1 ? p_is_ready : _is_ready;
}

bool DeviceNode::set_driver(unsigned p_interface, bool p_is_bound) {
	const std::string link = _testbed.root() + _interface_path(p_interface) + "/driver";
	unlink(link.c_str());
	if (!p_is_bound) {
		return true;
	}
	const std::string target = "../../../../../../bus/usb/drivers/" + _driver;
	return symlink(target.c_str(), link.c_str()) == 0;
}

} // namespace emulator
