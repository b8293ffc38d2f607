// SPDX-License-Identifier: MIT
#include "suit_tracker.hpp"

namespace godot {

Ref<SuitTracker> SuitTracker::make(const xbus::TrackerReport &p_report, double p_age_s) {
	Ref<SuitTracker> tracker;
	tracker.instantiate();
	tracker->_report = p_report;
	tracker->_age_s = p_age_s;
	return tracker;
}

void SuitTracker::_bind_methods() {
	ClassDB::bind_method(D_METHOD("get_id"), &SuitTracker::get_id);
	ClassDB::bind_method(D_METHOD("get_bus_id"), &SuitTracker::get_bus_id);
	ClassDB::bind_method(D_METHOD("get_received"), &SuitTracker::get_received);
	ClassDB::bind_method(D_METHOD("get_lost"), &SuitTracker::get_lost);
	ClassDB::bind_method(D_METHOD("get_rate_hz"), &SuitTracker::get_rate_hz);
	ClassDB::bind_method(D_METHOD("get_age_s"), &SuitTracker::get_age_s);
}

} // namespace godot
