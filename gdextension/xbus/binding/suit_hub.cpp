// SPDX-License-Identifier: MIT
#include "suit_hub.hpp"

#include "text.hpp"

#include <clock/clock.hpp>
#include <usb/hub_library.hpp>

#include <godot_cpp/core/error_macros.hpp>

namespace godot {

namespace {

constexpr double MAX_RATE_HZ = 512.0;

} // namespace

String SuitHub::start(double p_rate_hz) {
	ERR_FAIL_COND_V_MSG(!(p_rate_hz >= 10.0 && p_rate_hz <= MAX_RATE_HZ), "the rate is no suit's",
			"A suit measures at 10 to 512 Hz.");
	stop();
	_player = Ref<RawPlayer>();
	xbus::SessionOptions options;
	options.rate_hz = p_rate_hz;
	std::string fault;
	_hub = usb::make_hub(options, &_tap, fault);
	if (_hub != nullptr) {
		fault = _hub->start();
	}
	if (!fault.empty()) {
		_hub.reset();
	}
	return as_string(fault);
}

void SuitHub::stop() {
	_hub.reset();
}

void SuitHub::set_recorder(const Ref<RawRecorder> &p_recorder) {
	ERR_FAIL_COND_MSG(_hub != nullptr,
			"Begin recording before looking for suits: their set-up says how the samples are laid out.");
	_tap.record_to(p_recorder.is_valid() ? p_recorder->share() : nullptr);
}

void SuitHub::play(const Ref<RawPlayer> &p_player) {
	stop();
	_player = p_player;
}

TypedArray<SuitDevice> SuitHub::get_devices() const {
	TypedArray<SuitDevice> devices;
	if (_player.is_valid()) {
		devices = _player->get_devices();
	} else if (_hub != nullptr) {
		const uint64_t now = clocks::now_usec();
		for (const usb::DeviceReport &report : _hub->report()) {
			devices.push_back(SuitDevice::make(report, now));
		}
	}
	return devices;
}

TypedArray<SuitMessage> SuitHub::take_messages() {
	TypedArray<SuitMessage> messages;
	if (_hub != nullptr) {
		for (const usb::HubMessage &message : _hub->take_messages()) {
			messages.push_back(SuitMessage::make(message));
		}
	}
	return messages;
}

TypedArray<SuitFrame> SuitHub::take_frames(int64_t p_device) {
	TypedArray<SuitFrame> frames;
	if (_player.is_valid()) {
		frames = _player->take_frames(p_device);
	} else if (_hub != nullptr) {
		const int64_t ahead = clocks::unix_ahead_usec();
		while (_hub->take_frame(int(p_device), _frame)) {
			frames.push_back(SuitFrame::make(_frame, ahead));
		}
	}
	return frames;
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
}

} // namespace godot
