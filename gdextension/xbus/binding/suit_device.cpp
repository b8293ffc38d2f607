// SPDX-License-Identifier: MIT
#include "suit_device.hpp"

#include "text.hpp"

#include <bus/message.hpp>

namespace godot {

namespace {

SuitDevice::State to_state(xbus::SessionState p_state) {
	switch (p_state) {
		case xbus::SessionState::SEARCHING:
			return SuitDevice::STATE_SEARCHING;
		case xbus::SessionState::CONFIGURING:
			return SuitDevice::STATE_CONFIGURING;
		case xbus::SessionState::MEASURING:
			return SuitDevice::STATE_MEASURING;
		case xbus::SessionState::SILENT:
			return SuitDevice::STATE_SILENT;
		case xbus::SessionState::UNSUPPORTED:
			return SuitDevice::STATE_UNSUPPORTED;
		default:
			return SuitDevice::STATE_STOPPED;
	}
}

} // namespace

Ref<SuitDevice> SuitDevice::make(const usb::DeviceReport &p_report, uint64_t p_now_usec) {
	Ref<SuitDevice> device;
	device.instantiate();
	device->_report = p_report;
	device->_name = String::utf8(p_report.known.name);
	device->_state = p_report.is_open ? to_state(p_report.session.state) : STATE_CLOSED;
	device->_is_measuring = p_report.session.state == xbus::SessionState::MEASURING;
	device->take_trackers(p_now_usec, 1.0);
	return device;
}

Ref<SuitDevice> SuitDevice::make_recorded(
		const usb::DeviceReport &p_report, const String &p_name, State p_state, uint64_t p_now_usec, double p_speed) {
	Ref<SuitDevice> device;
	device.instantiate();
	device->_report = p_report;
	device->_name = p_name;
	device->_state = p_state;
	for (const xbus::TrackerReport &tracker : p_report.session.trackers) {
		device->_is_measuring = device->_is_measuring || tracker.flow.newest_usec > 0;
	}
	device->take_trackers(p_now_usec, p_speed);
	return device;
}

void SuitDevice::take_trackers(uint64_t p_now_usec, double p_speed) {
	for (const xbus::TrackerReport &tracker : _report.session.trackers) {
		const uint64_t newest = tracker.flow.newest_usec;
		const double age_s = newest > 0 ? double(int64_t(p_now_usec - newest)) / 1e6 / p_speed : -1.0;
		_trackers.push_back(SuitTracker::make(tracker, age_s));
	}
}

String SuitDevice::get_address() const {
	return as_string(_report.address);
}

String SuitDevice::get_state_text() const {
	switch (_state) {
		case STATE_CLOSED:
			return "not open";
		case STATE_PLAYING:
			return "recorded";
		case STATE_PLAYED:
			return "recorded, at its end";
		default:
			return String::utf8(xbus::state_text(_report.session.state));
	}
}

String SuitDevice::get_problem() const {
	return as_string(_report.fault.empty() ? _report.session.problem : _report.fault);
}

String SuitDevice::get_kind_text() const {
	return String::utf8(xbus::device_kind_name(_report.session.kind));
}

void SuitDevice::_bind_methods() {
	ClassDB::bind_method(D_METHOD("get_number"), &SuitDevice::get_number);
	ClassDB::bind_method(D_METHOD("get_name"), &SuitDevice::get_name);
	ClassDB::bind_method(D_METHOD("get_address"), &SuitDevice::get_address);
	ClassDB::bind_method(D_METHOD("is_open"), &SuitDevice::is_open);
	ClassDB::bind_method(D_METHOD("get_state"), &SuitDevice::get_state);
	ClassDB::bind_method(D_METHOD("get_state_text"), &SuitDevice::get_state_text);
	ClassDB::bind_method(D_METHOD("is_measuring"), &SuitDevice::is_measuring);
	ClassDB::bind_method(D_METHOD("get_problem"), &SuitDevice::get_problem);
	ClassDB::bind_method(D_METHOD("get_id"), &SuitDevice::get_id);
	ClassDB::bind_method(D_METHOD("get_kind_text"), &SuitDevice::get_kind_text);
	ClassDB::bind_method(D_METHOD("get_baud"), &SuitDevice::get_baud);
	ClassDB::bind_method(D_METHOD("get_rate_hz"), &SuitDevice::get_rate_hz);
	ClassDB::bind_method(D_METHOD("get_battery"), &SuitDevice::get_battery);
	ClassDB::bind_method(D_METHOD("get_malformed_bytes"), &SuitDevice::get_malformed_bytes);
	ClassDB::bind_method(D_METHOD("get_trackers"), &SuitDevice::get_trackers);
	BIND_ENUM_CONSTANT(STATE_CLOSED);
	BIND_ENUM_CONSTANT(STATE_SEARCHING);
	BIND_ENUM_CONSTANT(STATE_CONFIGURING);
	BIND_ENUM_CONSTANT(STATE_MEASURING);
	BIND_ENUM_CONSTANT(STATE_SILENT);
	BIND_ENUM_CONSTANT(STATE_UNSUPPORTED);
	BIND_ENUM_CONSTANT(STATE_STOPPED);
	BIND_ENUM_CONSTANT(STATE_PLAYING);
	BIND_ENUM_CONSTANT(STATE_PLAYED);
}

} // namespace godot
