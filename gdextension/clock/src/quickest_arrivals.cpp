// SPDX-License-Identifier: MIT
#include "quickest_arrivals.hpp"

#include <algorithm>
#include <cmath>

namespace clocks {

void QuickestArrivals::note(double p_at, double p_delay) {
	if (!is_known()) {
		_origin = _last = p_at;
	}
	if (_keep({ p_at, p_delay })) {
		_target = _draw();
	}
	const double rise = _target - _offset;
	const bool is_limited = rise > 0.0 && rise <= _options.pause;
	_offset = is_limited ? _offset + std::min(rise, std::max(p_at - _last, 0.0) * _options.rise) : _target;
	_last = p_at;
}

/// Takes an arrival into the quickest of its span; false if it is slower than that.
bool QuickestArrivals::_keep(const Arrival &p_arrival) {
	if (_count > 0 && p_arrival.at < _span_end) {
		if (p_arrival.delay >= _quickest[_count - 1].delay) {
			return false;
		}
		_quickest[_count - 1] = p_arrival;
		return true;
	}
	if (p_arrival.at - _last > _options.silence) {
		_count = 0;
	} else if (_count == _options.kept) {
		std::copy(_quickest.begin() + 1, _quickest.begin() + std::ptrdiff_t(_count), _quickest.begin());
		--_count;
	}
	_quickest[_count++] = p_arrival;
	_span_end = p_arrival.at + _options.span;
	return true;
}

/// Draws the line below the quickest arrivals: sets its slope and returns its height at the origin.
double QuickestArrivals::_draw() {
	const std::size_t spans = _options.counts_open_span ? _count : _count - 1;
	const bool has_drift = spans >= _options.drift_spans;
	_slope = has_drift ? std::clamp(_hull_slope(spans), -_options.max_drift, _options.max_drift) : 0.0;
	double height = std::numeric_limits<double>::infinity();
	for (std::size_t i = has_drift || _count < _options.recent ? 0 : _count - _options.recent; i < _count; ++i) {
		height = std::min(height, _quickest[i].delay - _slope * (_quickest[i].at - _origin));
	}
	return height;
}

/// The slope of the edge of the lower convex hull (Andrew 1979, the monotone chain) over the middle of the first
/// arrivals.
double QuickestArrivals::_hull_slope(std::size_t p_count) const {
	const auto is_above = [](const Arrival &p_from, const Arrival &p_middle, const Arrival &p_to) {
		return (p_middle.delay - p_from.delay) * (p_to.at - p_from.at) >=
				(p_to.delay - p_from.delay) * (p_middle.at - p_from.at);
	};
	std::array<Arrival, MAX_KEPT> hull{};
	std::size_t corners = 0;
	double middle = 0.0;
	for (std::size_t i = 0; i < p_count; ++i) {
		const Arrival &arrival = _quickest[i];
		middle += (arrival.at - _origin) / double(p_count);
		while (corners >= 2 && is_above(hull[corners - 2], hull[corners - 1], arrival)) {
			--corners;
		}
		hull[corners++] = arrival;
	}
	std::size_t edge = 1;
	while (edge + 1 < corners && hull[edge].at - _origin < middle) {
		++edge;
	}
	const Arrival &from = hull[edge - 1];
	const Arrival &to = hull[edge];
	return to.at > from.at ? (to.delay - from.delay) / (to.at - from.at) : 0.0;
}

} // namespace clocks
