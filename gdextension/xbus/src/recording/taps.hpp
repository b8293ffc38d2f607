// SPDX-License-Identifier: MIT
#pragma once

#include "recording/recorder.hpp"
#include "usb/hub.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <string>

namespace recording {

/// What a recording says of itself: who wrote it, and how far Unix time was ahead of its times.
std::string about_file();

/// Puts the bytes of all suits into a recording.
class BusTap final : public usb::HubListener {
public:
	/// For the next hub; null records nothing.
	void record_to(std::shared_ptr<Recorder> p_recorder);
	void take_frame(int, const xbus::SuitFrame &) override {}
	void take_raw(
			int p_device, bool p_is_out, const uint8_t *p_bytes, std::size_t p_size, uint64_t p_time_usec) override;
	void device_opened(const usb::DeviceReport &p_report) override;

private:
	std::shared_ptr<Recorder> _recorder;
	std::map<int, int> _streams;
};

/// Puts the datagrams of MVN's stream into a recording.
class DatagramTap {
public:
	/// They come in at a port of this machine.
	DatagramTap(std::shared_ptr<Recorder> p_recorder, int p_port) : _recorder(std::move(p_recorder)), _port(p_port) {}
	void take(const std::string &p_sender, const uint8_t *p_bytes, std::size_t p_size, uint64_t p_time_usec);

private:
	std::shared_ptr<Recorder> _recorder;
	int _port;
	std::map<std::string, int> _streams;
};

} // namespace recording
