// SPDX-License-Identifier: MIT
#include "suit_hub.hpp"

#include "suit_dictionary.hpp"

#include <clock/clock.hpp>
#include <usb/hub_library.hpp>

#include <godot_cpp/core/error_macros.hpp>

namespace godot {

namespace {

constexpr double MAX_RATE_HZ = 512.0;

String text(const std::string &p_text) {
	return String::utf8(p_text.c_str());
}

Dictionary tracker_dictionary(const xbus::TrackerReport &p_tracker, uint64_t p_now_usec) {
	const uint64_t newest = p_tracker.flow.newest_usec;
	Dictionary result;
	result["id"] = int64_t(p_tracker.device_id);
	result["bus_id"] = int64_t(p_tracker.bus_id);
	result["received"] = int64_t(p_tracker.samples.received);
	result["lost"] = int64_t(p_tracker.samples.lost);
	result["implausible"] = int64_t(p_tracker.samples.implausible);
	result["rate_hz"] = p_tracker.flow.rate_hz;
	result["age_s"] = newest > 0 ? double(p_now_usec - newest) / 1e6 : -1.0;
	return result;
}

Dictionary device_dictionary(const usb::DeviceReport &p_report, uint64_t p_now_usec) {
	const xbus::SessionReport &session = p_report.session;
	TypedArray<Dictionary> trackers;
	for (const xbus::TrackerReport &tracker : session.trackers) {
		trackers.push_back(tracker_dictionary(tracker, p_now_usec));
	}
	Dictionary result;
	result["number"] = int64_t(p_report.number);
	result["name"] = String::utf8(p_report.known.name);
	result["usb"] = int64_t((uint32_t(p_report.known.vendor) << 16U) | p_report.known.product);
	result["place"] = text(p_report.place);
	result["serial"] = text(p_report.serial);
	result["is_open"] = p_report.is_open;
	result["state"] = String::utf8(p_report.is_open ? xbus::state_text(session.state) : "not open");
	result["measures"] = session.state == xbus::SessionState::MEASURING;
	result["trouble"] = text(p_report.fault.empty() ? session.problem : p_report.fault);
	result["id"] = int64_t(session.device_id);
	result["kind"] = String::utf8(xbus::device_kind_name(session.kind));
	result["baud"] = int64_t(session.baud);
	result["rate_hz"] = session.rate_hz;
	result["battery"] = session.battery;
	result["malformed_bytes"] = int64_t(session.framer.skipped_bytes);
	result["refused"] = int64_t(session.framer.refused_frames);
	result["errors"] = int64_t(session.errors);
	result["restarts"] = int64_t(session.restarts);
	result["line_faults"] = int64_t(p_report.port.ftdi.line_faults);
	result["overruns"] = int64_t(p_report.overruns);
	result["trackers"] = trackers;
	return result;
}

} // namespace

String SuitHub::start(double p_rate_hz) {
	ERR_FAIL_COND_V_MSG(!(p_rate_hz >= 10.0 && p_rate_hz <= MAX_RATE_HZ), "the rate is no suit's",
			"A suit measures at 10 to 512 Hz.");
	stop();
	player = Ref<RawPlayer>();
	xbus::SessionOptions options;
	options.rate_hz = p_rate_hz;
	std::string fault;
	hub = usb::make_hub(options, &tap, fault);
	if (hub != nullptr) {
		fault = hub->start();
	}
	if (!fault.empty()) {
		hub.reset();
	}
	return text(fault);
}

void SuitHub::stop() {
	hub.reset();
}

void SuitHub::set_recorder(const Ref<RawRecorder> &p_recorder) {
	ERR_FAIL_COND_MSG(
			hub != nullptr, "A recording begins before the suits are looked for, or nobody could tell what is in it.");
	tap.record_to(p_recorder.is_valid() ? p_recorder->share() : nullptr);
}

void SuitHub::play(const Ref<RawPlayer> &p_player) {
	stop();
	player = p_player;
}

TypedArray<Dictionary> SuitHub::get_devices() const {
	TypedArray<Dictionary> devices;
	if (player.is_valid()) {
		devices = player->get_devices();
	} else if (hub != nullptr) {
		const uint64_t now = clocks::now_usec();
		for (const usb::DeviceReport &report : hub->report()) {
			devices.push_back(device_dictionary(report, now));
		}
	}
	return devices;
}

TypedArray<Dictionary> SuitHub::take_messages() {
	TypedArray<Dictionary> messages;
	if (hub != nullptr) {
		for (const usb::HubMessage &message : hub->take_messages()) {
			Dictionary entry;
			entry["severity"] = int64_t(message.severity);
			entry["text"] = text(message.text);
			messages.push_back(entry);
		}
	}
	return messages;
}

TypedArray<Dictionary> SuitHub::take_frames(int64_t p_device) {
	TypedArray<Dictionary> frames;
	if (player.is_valid()) {
		frames = player->take_frames(p_device);
	} else if (hub != nullptr) {
		const int64_t ahead = clocks::unix_ahead_usec();
		while (hub->take_frame(int(p_device), frame)) {
			frames.push_back(suit_frame_dictionary(frame, ahead));
		}
	}
	return frames;
}

void SuitHub::reset_orientation(int64_t p_device, Reset p_method) {
	ERR_FAIL_COND_MSG(p_method < RESET_STORE || p_method > RESET_ALIGN, "There is no such reset.");
	if (hub != nullptr) {
		hub->reset_orientation(int(p_device), xbus::ResetMethod(p_method));
	}
}

void SuitHub::_bind_methods() {
	ClassDB::bind_method(D_METHOD("start", "rate_hz"), &SuitHub::start);
	ClassDB::bind_method(D_METHOD("stop"), &SuitHub::stop);
	ClassDB::bind_method(D_METHOD("is_running"), &SuitHub::is_running);
	ClassDB::bind_method(D_METHOD("set_recorder", "recorder"), &SuitHub::set_recorder);
	ClassDB::bind_method(D_METHOD("play", "player"), &SuitHub::play);
	ClassDB::bind_method(D_METHOD("get_devices"), &SuitHub::get_devices);
	ClassDB::bind_method(D_METHOD("take_messages"), &SuitHub::take_messages);
	ClassDB::bind_method(D_METHOD("take_frames", "device"), &SuitHub::take_frames);
	ClassDB::bind_method(D_METHOD("reset_orientation", "device", "method"), &SuitHub::reset_orientation);
	BIND_ENUM_CONSTANT(RESET_STORE);
	BIND_ENUM_CONSTANT(RESET_HEADING);
	BIND_ENUM_CONSTANT(RESET_GLOBAL);
	BIND_ENUM_CONSTANT(RESET_OBJECT);
	BIND_ENUM_CONSTANT(RESET_ALIGN);
}

} // namespace godot
