// SPDX-License-Identifier: MIT
#pragma once

#include <session/session.hpp>

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>

#include <cstdint>

namespace godot {

/// What is known of one tracker of a device. Documented in doc_classes/SuitTracker.xml.
class SuitTracker : public RefCounted {
	GDCLASS(SuitTracker, RefCounted)

public:
	/// `p_age_s`: since the newest sample, s; negative if none came.
	static Ref<SuitTracker> make(const xbus::TrackerReport &p_report, double p_age_s);

	int64_t get_id() const { return int64_t(_report.device_id); }
	int64_t get_bus_id() const { return int64_t(_report.bus_id); }
	int64_t get_received() const { return int64_t(_report.samples.received); }
	int64_t get_lost() const { return int64_t(_report.samples.lost); }
	double get_rate_hz() const { return _report.flow.rate_hz; }
	double get_age_s() const { return _age_s; }

protected:
	static void _bind_methods();

private:
	xbus::TrackerReport _report;
	double _age_s = -1.0;
};

} // namespace godot
