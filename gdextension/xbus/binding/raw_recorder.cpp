// SPDX-License-Identifier: MIT
#include "raw_recorder.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace godot {

namespace {

template <class Clock>
int64_t clock_usec() {
	using namespace std::chrono;
	return int64_t(duration_cast<microseconds>(Clock::now().time_since_epoch()).count());
}

/// One line of what is known; what a device says of itself may hold anything.
std::string line(const char *p_key, std::string p_value) {
	std::replace_if(p_value.begin(), p_value.end(), [](char p_one) { return uint8_t(p_one) < 0x20; }, ' ');
	return std::string(p_key) + "=" + p_value + "\n";
}

} // namespace

void BusTap::record_to(std::shared_ptr<recording::Recorder> p_recorder) {
	recorder = std::move(p_recorder);
	streams.clear();
}

void BusTap::device_opened(const usb::DeviceReport &p_report) {
	if (recorder == nullptr) {
		return;
	}
	std::array<char, 16> ids{};
	std::snprintf(ids.data(), ids.size(), "%04x:%04x", p_report.known.vendor, p_report.known.product);
	streams[p_report.number] = recorder->add_stream(line("kind", "bus") + line("usb", ids.data()) +
					line("name", p_report.known.name) + line("place", p_report.place) + line("serial", p_report.serial),
			uint64_t(clock_usec<std::chrono::steady_clock>()));
}

void BusTap::take_raw(int p_device, bool p_is_out, const uint8_t *p_bytes, std::size_t p_size, uint64_t p_time_usec) {
	const auto found = streams.find(p_device);
	if (recorder != nullptr && found != streams.end()) {
		recorder->add(p_is_out ? recording::Kind::BUS_OUT : recording::Kind::BUS_IN, found->second, p_bytes, p_size,
				p_time_usec);
	}
}

void DatagramTap::take(const std::string &p_sender, const uint8_t *p_bytes, std::size_t p_size, uint64_t p_time_usec) {
	int stream = recording::MOST_STREAMS - 1;
	const auto found = streams.find(p_sender);
	if (found != streams.end()) {
		stream = found->second;
	} else if (streams.size() < std::size_t(recording::MOST_STREAMS) / 2) {
		stream = recorder->add_stream(
				line("kind", "mvn") + line("sender", p_sender) + line("port", std::to_string(port)), p_time_usec);
		streams.emplace(p_sender, stream);
	}
	recorder->add(recording::Kind::DATAGRAM, stream, p_bytes, p_size, p_time_usec);
}

String RawRecorder::open(const String &p_path) {
	const int64_t ahead = clock_usec<std::chrono::system_clock>() - clock_usec<std::chrono::steady_clock>();
	const std::string about = line("by", "Dismount") + line("unix_ahead_usec", std::to_string(ahead));
	return String::utf8(recorder->open(p_path.utf8().get_data(), about).c_str());
}

Dictionary RawRecorder::get_figures() const {
	const recording::RecorderFigures figures = recorder->figures();
	Dictionary result;
	result["records"] = int64_t(figures.records);
	result["bytes"] = int64_t(figures.bytes);
	result["lost"] = int64_t(figures.lost);
	result["fault"] = String::utf8(figures.fault.c_str());
	return result;
}

void RawRecorder::_bind_methods() {
	ClassDB::bind_method(D_METHOD("open", "path"), &RawRecorder::open);
	ClassDB::bind_method(D_METHOD("close"), &RawRecorder::close);
	ClassDB::bind_method(D_METHOD("get_figures"), &RawRecorder::get_figures);
}

} // namespace godot
