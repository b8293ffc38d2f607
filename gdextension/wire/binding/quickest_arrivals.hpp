// SPDX-License-Identifier: MIT
#pragma once

#include <quickest_arrivals.hpp>

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>

namespace godot {

/// How far another clock is apart from ours. Documented in doc_classes/QuickestArrivals.xml.
class QuickestArrivals : public RefCounted {
	GDCLASS(QuickestArrivals, RefCounted)

public:
	void keep(double p_span_s, int64_t p_drift_spans, double p_max_drift);
	void note(double p_at_s, double p_delay_s);
	double delay_at(double p_at_s) const { return _quickest.delay_at(p_at_s); }
	double drift() const { return _quickest.drift(); }
	void clear() { _quickest.clear(); }

protected:
	static void _bind_methods();

private:
	clocks::QuickestArrivals _quickest;
};

} // namespace godot
