// SPDX-License-Identifier: MIT
#include "recording/taps.hpp"

#include "clock/clock.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace recording {

namespace {

/// Senders that have a stream of their own; any others share the last one.
constexpr std::size_t MAX_SENDERS = std::size_t(MAX_STREAMS) / 2;

/// One line of what is known; what a device says of itself may hold anything.
std::string line(const char *p_key, std::string p_value) {
	std::replace_if(p_value.begin(), p_value.end(), [](char p_one) { return uint8_t(p_one) < 0x20; }, ' ');
	return std::string(p_key) + "=" + p_value + "\n";
}

} // namespace

std::string about_file() {
	const int64_t ahead = clocks::unix_ahead_usec();
	return line("by", "Dismount") + line("unix_ahead_usec", std::to_string(ahead));
}

void BusTap::record_to(std::shared_ptr<Recorder> p_recorder) {
	_recorder = std::move(p_recorder);
	_streams.clear();
}

void BusTap::device_opened(const usb::DeviceReport &p_report) {
	if (_recorder == nullptr) {
		return;
	}
	std::array<char, 16> ids{};
	std::snprintf(ids.data(), ids.size(), "%04x:%04x", p_report.known.vendor, p_report.known.product);
	// "place" is the key for the address in all recordings that exist.
	_streams[p_report.number] =
			_recorder->add_stream(line("kind", "bus") + line("usb", ids.data()) + line("name", p_report.known.name) +
							line("place", p_report.address) + line("serial", p_report.serial),
					clocks::now_usec());
}

void BusTap::take_raw(int p_device, bool p_is_out, const uint8_t *p_bytes, std::size_t p_size, uint64_t p_time_usec) {
	const auto found = _streams.find(p_device);
	if (_recorder != nullptr && found != _streams.end()) {
		_recorder->add(p_is_out ? Kind::BUS_OUT : Kind::BUS_IN, found->second, p_bytes, p_size, p_time_usec);
	}
}

void DatagramTap::take(const std::string &p_sender, const uint8_t *p_bytes, std::size_t p_size, uint64_t p_time_usec) {
	int stream = MAX_STREAMS - 1;
	const auto found = _streams.find(p_sender);
	if (found != _streams.end()) {
		stream = found->second;
	} else if (_streams.size() < MAX_SENDERS) {
		stream = _recorder->add_stream(
				line("kind", "mvn") + line("sender", p_sender) + line("port", std::to_string(_port)), p_time_usec);
		_streams.emplace(p_sender, stream);
	}
	_recorder->add(Kind::DATAGRAM, stream, p_bytes, p_size, p_time_usec);
}

} // namespace recording
