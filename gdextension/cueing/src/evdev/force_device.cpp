// SPDX-License-Identifier: MIT
#include "force_device.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>

#include <dirent.h>
#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace cueing {

namespace {

constexpr const char *CLASS_FOLDER = "/sys/class/input/";
constexpr const char *REMEDY = "install 60-dismount-wheels.rules (docs/motion-platform.md), or "
							   "be a member of the group input, and log in anew";
constexpr std::size_t BITS_PER_BYTE = 8;

using Bits = std::array<uint8_t, FF_MAX / BITS_PER_BYTE + 1>;

bool has_bit(const Bits &p_bits, int p_bit) {
	return (p_bits[std::size_t(p_bit) / BITS_PER_BYTE] >> (unsigned(p_bit) % BITS_PER_BYTE) & 1U) != 0;
}

/// ioctl() that goes on after a signal.
template <class T>
int control(int p_descriptor, unsigned long p_request, T p_argument) {
	int result = 0;
	do {
		result = ioctl(p_descriptor, p_request, p_argument);
	} while (result < 0 && errno == EINTR);
	return result;
}

/// The first line of a file of the system; empty where there is none.
std::string read_line(const std::string &p_path) {
	const int file = open(p_path.c_str(), O_RDONLY | O_CLOEXEC);
	if (file < 0) {
		return "";
	}
	std::array<char, 256> bytes{};
	const ssize_t size = read(file, bytes.data(), bytes.size());
	close(file);
	const std::string text(bytes.data(), size > 0 ? std::size_t(size) : 0);
	return text.substr(0, text.find('\n'));
}

/// Bits as the system writes them: words of 64 bits in hexadecimal, the highest first.
Bits parse_bits(const std::string &p_text) {
	Bits bits{};
	std::size_t end = p_text.size();
	for (std::size_t word = 0; end > 0 && word * BITS_PER_BYTE < bits.size(); word++) {
		const std::size_t space = p_text.find_last_of(' ', end - 1);
		const std::size_t begin = space == std::string::npos ? 0 : space + 1;
		const uint64_t value = std::strtoull(p_text.substr(begin, end - begin).c_str(), nullptr, 16);
		for (std::size_t byte = 0; byte < BITS_PER_BYTE && word * BITS_PER_BYTE + byte < bits.size(); byte++) {
			bits[word * BITS_PER_BYTE + byte] = uint8_t(value >> (BITS_PER_BYTE * byte));
		}
		end = space == std::string::npos ? 0 : space;
	}
	return bits;
}

std::array<bool, FORCE_KINDS> find_kinds(const Bits &p_bits) {
	std::array<bool, FORCE_KINDS> kinds{};
	for (const ForceKind kind : ALL_FORCE_KINDS) {
		const bool is_there = has_bit(p_bits, force_bit(kind));
		kinds[std::size_t(kind)] = is_there && (kind != ForceKind::PERIODIC || has_bit(p_bits, FF_SINE));
	}
	return kinds;
}

std::string explain(const std::string &p_path, int p_error) {
	if (p_error == EACCES || p_error == EPERM) {
		return "no right to write to " + p_path + ": " + REMEDY;
	}
	return p_path + " cannot be opened: " + std::strerror(p_error);
}

std::vector<int> find_numbers() {
	std::vector<int> numbers;
	DIR *folder = opendir(CLASS_FOLDER);
	if (folder == nullptr) {
		return numbers;
	}
	for (const dirent *entry = readdir(folder); entry != nullptr; entry = readdir(folder)) {
		if (std::strncmp(entry->d_name, "event", 5) == 0) {
			numbers.push_back(int(std::strtol(entry->d_name + 5, nullptr, 10)));
		}
	}
	closedir(folder);
	std::sort(numbers.begin(), numbers.end());
	return numbers;
}

} // namespace

std::vector<ForceDeviceInfo> list_force_devices() {
	std::vector<ForceDeviceInfo> devices;
	for (const int number : find_numbers()) {
		const std::string name = "event" + std::to_string(number);
		const std::string folder = CLASS_FOLDER + name + "/device/";
		const Bits bits = parse_bits(read_line(folder + "capabilities/ff"));
		if (std::all_of(bits.begin(), bits.end(), [](uint8_t p_byte) { return p_byte == 0; })) {
			continue;
		}
		ForceDeviceInfo device;
		device.path = "/dev/input/" + name;
		device.name = read_line(folder + "name");
		device.vendor = uint16_t(std::strtoul(read_line(folder + "id/vendor").c_str(), nullptr, 16));
		device.product = uint16_t(std::strtoul(read_line(folder + "id/product").c_str(), nullptr, 16));
		device.can = find_kinds(bits);
		const int tried = open(device.path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
		if (tried < 0) {
			device.error = explain(device.path, errno);
		} else {
			close(tried);
		}
		devices.push_back(device);
	}
	return devices;
}

std::string ForceDevice::open(const std::string &p_path) {
	close();
	_info = ForceDeviceInfo();
	_info.path = p_path;
	_note.clear();
	_descriptor = ::open(p_path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
	if (_descriptor < 0) {
		_info.error = explain(p_path, errno);
		return _info.error;
	}
	read_capabilities();
	const bool can_any = std::any_of(_info.can.begin(), _info.can.end(), [](bool p_can) { return p_can; });
	if (!can_any || _room < 1) {
		close();
		_info.error = p_path + " has no force feedback";
		return _info.error;
	}
	return "";
}

void ForceDevice::read_capabilities() {
	Bits bits{};
	std::array<char, 256> name{};
	input_id id{};
	if (control(_descriptor, EVIOCGBIT(EV_FF, bits.size()), bits.data()) >= 0) {
		_info.can = find_kinds(bits);
	}
	if (control(_descriptor, EVIOCGNAME(name.size() - 1), name.data()) >= 0) {
		_info.name = name.data();
	}
	if (control(_descriptor, EVIOCGID, &id) >= 0) {
		_info.vendor = id.vendor;
		_info.product = id.product;
	}
	int room = 0;
	_room = control(_descriptor, EVIOCGEFFECTS, &room) >= 0 ? room : 0;
	_has_gain = has_bit(bits, FF_GAIN);
	_slots = {};
	// A wheel that pulls to its middle by itself would hide the spring of the vehicle.
	if (has_bit(bits, FF_AUTOCENTER)) {
		write_event(FF_AUTOCENTER, 0);
	}
}

void ForceDevice::close() {
	if (_descriptor < 0) {
		return;
	}
	for (const Slot &slot : _slots) {
		if (slot.is_uploaded) {
			control(_descriptor, EVIOCRMFF, long(slot.effect.id));
		}
	}
	::close(_descriptor);
	_descriptor = -1;
	_slots = {};
}

bool ForceDevice::has_gone(int p_error) {
	if (p_error != ENODEV && p_error != ENXIO && p_error != EBADF) {
		return false;
	}
	// Its effects went with it.
	_slots = {};
	close();
	return true;
}

bool ForceDevice::apply(const WheelForces &p_forces) {
	for (const ForceKind kind : ALL_FORCE_KINDS) {
		if (_descriptor >= 0 && _info.can[std::size_t(kind)]) {
			apply_one(kind, p_forces);
		}
	}
	return _descriptor >= 0;
}

bool ForceDevice::apply_one(ForceKind p_kind, const WheelForces &p_forces) {
	Slot &slot = _slots[std::size_t(p_kind)];
	if (slot.is_left_out || (!slot.is_uploaded && is_idle(p_kind, p_forces))) {
		return true;
	}
	const ff_effect effect = make_effect(p_kind, p_forces, slot.is_uploaded ? slot.effect.id : -1);
	const bool is_same = slot.is_uploaded && effect_bytes(effect) == effect_bytes(slot.effect);
	if (!is_same && !upload(p_kind, effect)) {
		return false;
	}
	if (slot.is_uploaded && !slot.is_playing) {
		slot.is_playing = write_event(uint16_t(slot.effect.id), 1);
	}
	return true;
}

bool ForceDevice::upload(ForceKind p_kind, const ff_effect &p_effect) {
	Slot &slot = _slots[std::size_t(p_kind)];
	ff_effect effect = p_effect;
	if (control(_descriptor, EVIOCSFF, &effect) >= 0) {
		slot.effect = effect;
		slot.is_uploaded = true;
		return true;
	}
	const int error = errno;
	if (!has_gone(error)) {
		// What it does not take once it will not take the next time.
		slot.is_left_out = true;
		const std::string why = error == ENOSPC ? "it has room for " + std::to_string(_room) + " effects"
												: std::string(std::strerror(error));
		_note += (_note.empty() ? "" : "; ") + std::string("no ") + force_name(p_kind) + " force: " + why;
	}
	return false;
}

bool ForceDevice::set_gain(double p_gain) {
	if (_descriptor < 0 || !_has_gain) {
		return false;
	}
	const double gain = std::isfinite(p_gain) ? std::clamp(p_gain, 0.0, 1.0) : 0.0;
	return write_event(FF_GAIN, int32_t(std::lround(gain * 0xFFFF)));
}

bool ForceDevice::write_event(uint16_t p_code, int32_t p_value) {
	input_event event{};
	event.type = EV_FF;
	event.code = p_code;
	event.value = p_value;
	ssize_t size = 0;
	do {
		size = write(_descriptor, &event, sizeof(event));
	} while (size < 0 && errno == EINTR);
	if (size != ssize_t(sizeof(event))) {
		has_gone(errno);
		return false;
	}
	return true;
}

} // namespace cueing
