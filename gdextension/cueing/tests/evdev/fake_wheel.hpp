// SPDX-License-Identifier: MIT
#pragma once

#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include <dlfcn.h>
#include <fcntl.h>
#include <linux/input.h>
#include <sys/stat.h>
#include <umockdev.h>
#include <unistd.h>

/// Starts the program again with umockdev's library loaded first: only then it sees what is not there.
inline void enter_umockdev(char **p_arguments) {
	if (std::getenv("FAKE_WHEEL_ENTERED") != nullptr) {
		return;
	}
	// It must be of the same version, so it is looked for beside the other.
	Dl_info info{};
	dladdr(reinterpret_cast<const void *>(&umockdev_testbed_new), &info);
	const std::string library = info.dli_fname;
	const std::string beside = library.substr(0, library.rfind('/') + 1) + "libumockdev-preload.so.0";
	setenv("LD_PRELOAD", access(beside.c_str(), R_OK) == 0 ? beside.c_str() : "libumockdev-preload.so.0", 1);
	setenv("FAKE_WHEEL_ENTERED", "1", 1);
	execv("/proc/self/exe", p_arguments);
}

/// An input device with force feedback that is not there: it answers the kernel's requests and keeps what it was sent.
class FakeWheel {
public:
	std::string name = "Fake Wheel";
	std::vector<int> bits = { FF_CONSTANT, FF_SPRING, FF_DAMPER, FF_PERIODIC, FF_SINE, FF_GAIN, FF_AUTOCENTER };
	int room = 16;
	/// What EVIOCSFF answers instead; 0: it takes the effect.
	int upload_error = 0;

	explicit FakeWheel(UMockdevTestbed *p_testbed) : _testbed(p_testbed), _handler(umockdev_ioctl_base_new()) {
		char *root = umockdev_testbed_get_root_dir(_testbed);
		_root = root;
		g_free(root);
		g_signal_connect(_handler, "handle-ioctl", G_CALLBACK(on_ioctl), this);
	}
	~FakeWheel() {
		unplug();
		g_signal_handlers_disconnect_by_data(_handler, this);
		g_object_unref(_handler);
	}
	FakeWheel(const FakeWheel &) = delete;
	FakeWheel &operator=(const FakeWheel &) = delete;

	std::string path() const { return "/dev/input/" + _event; }
	/// Returns what umockdev has against it, or an empty text.
	std::string plug() {
		// umockdev takes no number a second time; the kernel may give another one as well.
		static int last_number = 4;
		last_number++;
		_event = "event" + std::to_string(last_number);
		_parent = "/devices/fake/input" + std::to_string(last_number);
		_written.clear();
		GError *error = nullptr;
		umockdev_testbed_add_from_string(_testbed, text().c_str(), &error);
		if (error == nullptr) {
			umockdev_testbed_attach_ioctl(_testbed, path().c_str(), _handler, &error);
		}
		if (error != nullptr) {
			const std::string what = error->message;
			g_error_free(error);
			return what;
		}
		const std::lock_guard<std::mutex> lock(_mutex);
		_is_there = true;
		return "";
	}
	void unplug() {
		{
			const std::lock_guard<std::mutex> lock(_mutex);
			if (!_is_there) {
				return;
			}
			_is_there = false;
			_effects.clear();
		}
		umockdev_testbed_detach_ioctl(_testbed, path().c_str(), nullptr);
		umockdev_testbed_remove_device(_testbed, ("/sys" + _parent + "/" + _event).c_str());
		umockdev_testbed_remove_device(_testbed, ("/sys" + _parent).c_str());
		unlink((_root + path()).c_str());
	}
	/// Its requests fail as those of a device that is gone, though it can still be found.
	void die() {
		const std::lock_guard<std::mutex> lock(_mutex);
		upload_error = ENODEV;
	}
	void forbid() const { chmod((_root + path()).c_str(), 0); }

	/// What EVIOCSFF was given, in order, and what was erased.
	std::vector<ff_effect> uploads() const {
		const std::lock_guard<std::mutex> lock(_mutex);
		return _uploads;
	}
	std::map<int, ff_effect> effects() const {
		const std::lock_guard<std::mutex> lock(_mutex);
		return _effects;
	}
	/// The events that were written to it since it was plugged in.
	std::vector<input_event> events() {
		// umockdev gives a program a terminal for a device; this is its other end.
		const int other_end = umockdev_testbed_get_dev_fd(_testbed, path().c_str());
		fcntl(other_end, F_SETFL, O_NONBLOCK);
		char bytes[512];
		for (ssize_t size = read(other_end, bytes, sizeof(bytes)); size > 0;
				size = read(other_end, bytes, sizeof(bytes))) {
			_written.insert(_written.end(), bytes, bytes + size);
		}
		std::vector<input_event> events(_written.size() / sizeof(input_event));
		std::memcpy(events.data(), _written.data(), events.size() * sizeof(input_event));
		return events;
	}

private:
	std::string text() const {
		uint64_t words[2] = {};
		for (const int bit : bits) {
			words[bit / 64] |= uint64_t(1) << (bit % 64);
		}
		char mask[40];
		(void)snprintf(mask, sizeof(mask), "%llx %llx", static_cast<unsigned long long>(words[1]),
				static_cast<unsigned long long>(words[0]));
		const std::string place = "P: " + _parent;
		return place + "\nE: SUBSYSTEM=input\nA: name=" + name + "\\n\nA: id/vendor=046d\\n\nA: id/product=c24f\\n\n" +
				"A: capabilities/ff=" + mask + "\\n\n\n" + place + "/" + _event + "\nN: input/" + _event +
				"\nE: DEVNAME=" + path() + "\nE: SUBSYSTEM=input\nE: MAJOR=13\nE: MINOR=69\nL: device=../../" +
				_parent.substr(_parent.rfind('/') + 1) + "\n\n";
	}

	static gboolean on_ioctl(UMockdevIoctlBase * /*p_base*/, UMockdevIoctlClient *p_client, gpointer p_self) {
		const int result = static_cast<FakeWheel *>(p_self)->answer(p_client);
		umockdev_ioctl_client_complete(p_client, result < 0 ? -1 : result, result < 0 ? -result : 0);
		return TRUE;
	}

	template <class T>
	static T *argument(UMockdevIoctlClient *p_client, std::size_t p_size = sizeof(T)) {
		UMockdevIoctlData *data =
				umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(p_client), 0, p_size, nullptr);
		return data == nullptr ? nullptr : reinterpret_cast<T *>(data->data);
	}

	int answer(UMockdevIoctlClient *p_client) {
		const std::lock_guard<std::mutex> lock(_mutex);
		const unsigned long request = umockdev_ioctl_client_get_request(p_client);
		const std::size_t size = _IOC_SIZE(request);
		if (!_is_there) {
			return -ENODEV;
		}
		if (_IOC_TYPE(request) != 'E') {
			return -ENOTTY;
		}
		switch (_IOC_NR(request)) {
			case 0x20 + EV_FF: {
				auto *mask = argument<uint8_t>(p_client, size);
				std::memset(mask, 0, size);
				for (const int bit : bits) {
					mask[bit / 8] |= uint8_t(1U << (bit % 8));
				}
				return int(size);
			}
			case _IOC_NR(EVIOCGNAME(0)):
				std::strncpy(argument<char>(p_client, size), name.c_str(), size);
				return int(name.size() + 1);
			case _IOC_NR(EVIOCGID):
				*argument<input_id>(p_client) = { BUS_USB, 0x046d, 0xc24f, 1 };
				return 0;
			case _IOC_NR(EVIOCGEFFECTS):
				*argument<int>(p_client) = room;
				return 0;
			case _IOC_NR(EVIOCSFF):
				return take(*argument<ff_effect>(p_client));
			case _IOC_NR(EVIOCRMFF):
				return erase(p_client);
			default:
				return -ENOTTY;
		}
	}

	int take(ff_effect &r_effect) {
		if (upload_error != 0) {
			return -upload_error;
		}
		if (r_effect.id < 0) {
			if (int(_effects.size()) >= room) {
				return -ENOSPC;
			}
			r_effect.id = int16_t(_effects.size());
		} else if (_effects.count(r_effect.id) == 0) {
			return -EINVAL;
		}
		_uploads.push_back(r_effect);
		_effects[r_effect.id] = r_effect;
		return 0;
	}

	int erase(UMockdevIoctlClient *p_client) {
		gulong id = 0;
		std::memcpy(&id, umockdev_ioctl_client_get_arg(p_client)->data, sizeof(id));
		return _effects.erase(int(id)) == 1 ? 0 : -EINVAL;
	}

	UMockdevTestbed *_testbed;
	UMockdevIoctlBase *_handler;
	std::string _event;
	std::string _parent;
	std::string _root;
	mutable std::mutex _mutex;
	bool _is_there = false;
	std::vector<ff_effect> _uploads;
	std::map<int, ff_effect> _effects;
	std::vector<char> _written;
};
