// SPDX-License-Identifier: MIT
#include "quickest_arrivals.hpp"

#include <cmath>

namespace godot {

void QuickestArrivals::keep(double p_span_s, int64_t p_drift_spans, double p_max_drift) {
	const auto most = int64_t(clocks::QuickestArrivals::MAX_KEPT);
	const bool is_drift = p_drift_spans >= 2 && p_drift_spans <= most && p_max_drift >= 0.0;
	ERR_FAIL_COND_MSG(!(p_span_s > 0.0) || (p_drift_spans != 0 && !is_drift),
			"QuickestArrivals: a span is longer than 0 s, and a drift needs 2 to 48 of them and a maximum of 0 or "
			"more.");
	clocks::QuickestArrivals::Options options;
	options.span = p_span_s;
	options.pause = 0.0;
	options.silence = p_span_s * double(most);
	if (p_drift_spans > 0) {
		options.kept = clocks::QuickestArrivals::MAX_KEPT;
		options.drift_spans = std::size_t(p_drift_spans);
		options.max_drift = p_max_drift;
	}
	_quickest = clocks::QuickestArrivals(options);
}

void QuickestArrivals::note(double p_at_s, double p_delay_s) {
	ERR_FAIL_COND_MSG(!std::isfinite(p_at_s) || !std::isfinite(p_delay_s),
			"QuickestArrivals: the time of an arrival and its delay are finite.");
	_quickest.note(p_at_s, p_delay_s);
}

void QuickestArrivals::_bind_methods() {
	ClassDB::bind_method(D_METHOD("keep", "span_s", "drift_spans", "max_drift"), &QuickestArrivals::keep);
	ClassDB::bind_method(D_METHOD("note", "at_s", "delay_s"), &QuickestArrivals::note);
	ClassDB::bind_method(D_METHOD("delay_at", "at_s"), &QuickestArrivals::delay_at);
	ClassDB::bind_method(D_METHOD("drift"), &QuickestArrivals::drift);
	ClassDB::bind_method(D_METHOD("clear"), &QuickestArrivals::clear);
}

} // namespace godot
