// SPDX-License-Identifier: MIT
#pragma once

#include "suit_tracker.hpp"

#include <usb/hub.hpp>

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/string.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <cstdint>

namespace godot {

/// What is known of a device: a suit's master or a tracker that stands alone. Documented in
/// doc_classes/SuitDevice.xml.
class SuitDevice : public RefCounted {
	GDCLASS(SuitDevice, RefCounted)

public:
	enum State {
		STATE_CLOSED,
		STATE_SEARCHING,
		STATE_CONFIGURING,
		STATE_MEASURING,
		STATE_SILENT,
		STATE_UNSUPPORTED,
		STATE_STOPPED,
		STATE_PLAYING,
		STATE_PLAYED,
	};

	/// A device on USB, as of a time (µs of CLOCK_MONOTONIC).
	static Ref<SuitDevice> make(const usb::DeviceReport &p_report, uint64_t p_now_usec);
	/// A device of a recording: its state is the player's, and ages count in played time, `p_speed` times as fast as
	/// the recorded one.
	static Ref<SuitDevice> make_recorded(const usb::DeviceReport &p_report, const String &p_name, State p_state,
			uint64_t p_now_usec, double p_speed);

	int64_t get_number() const { return _report.number; }
	String get_name() const { return _name; }
	String get_address() const;
	bool is_open() const { return _report.is_open; }
	State get_state() const { return _state; }
	String get_state_text() const;
	bool is_measuring() const { return _is_measuring; }
	String get_problem() const;
	int64_t get_id() const { return int64_t(_report.session.device_id); }
	String get_kind_text() const;
	int64_t get_baud() const { return int64_t(_report.session.baud); }
	double get_rate_hz() const { return _report.session.rate_hz; }
	double get_battery() const { return _report.session.battery; }
	int64_t get_malformed_bytes() const { return int64_t(_report.session.framer.skipped_bytes); }
	TypedArray<SuitTracker> get_trackers() const { return _trackers; }

protected:
	static void _bind_methods();

private:
	void take_trackers(uint64_t p_now_usec, double p_speed);

	usb::DeviceReport _report;
	String _name;
	State _state = STATE_CLOSED;
	bool _is_measuring = false;
	TypedArray<SuitTracker> _trackers;
};

} // namespace godot

VARIANT_ENUM_CAST(SuitDevice::State);
