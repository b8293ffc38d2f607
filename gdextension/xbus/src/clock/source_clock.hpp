// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace clocks {

/// Estimates when samples were taken, in this machine's time, by the source's own time (a time code, or a counter
/// times the period) and the times at which they arrive.
///
/// No sample arrives before it was taken, and each waits somewhere for a while: the quickest arrivals of every
/// second lie on a line that shows how far the two clocks are apart and how they drift. It is the line below all of
/// them that is nearest to them on the whole (Moon, Skelly, Towsley 1999, "Estimation and removal of clock skew
/// from network delay measurements": an edge of the lower convex hull). A source whose time runs at another rate
/// than ours (slow motion, a period other than was asked for) is believed once some seconds agree on it; one whose
/// time does not run at all has the times of arrival.
class SourceClock {
public:
	/// `p_is_trusted`: the source's time is believed at once, before it has been seen to run. `p_is_rough`: its rate
	/// is only known to a hundredth or two.
	explicit SourceClock(bool p_is_trusted = false, bool p_is_rough = false) :
			_is_trusted(p_is_trusted), _is_rough(p_is_rough), _runs(p_is_trusted) {}

	/// Begins anew: another stream.
	void reset() { *this = SourceClock(_is_trusted, _is_rough); }
	/// Nothing came for a while: the clocks are compared anew. What ran before runs now, as far as is known.
	void resume() { _is_known = false; }

	/// The time of a sample that arrived now, µs, never later than its arrival.
	uint64_t timestamp(int64_t p_source_usec, uint64_t p_arrival_usec) {
		const auto arrival = int64_t(p_arrival_usec);
		if (!_is_known || p_source_usec < _last_source - BACK_USEC || arrival < _span_arrival - BACK_USEC) {
			begin(p_source_usec, arrival);
		}
		_last_source = std::max(_last_source, p_source_usec);
		judge(arrival);
		if (!_runs) {
			return p_arrival_usec;
		}
		const double passed = double(p_source_usec - _origin_source) * _ratio;
		const double delay = double(arrival - _origin_arrival) - passed;
		if (_count > 0 && is_another_stream(delay - (_offset + _slope * passed), arrival)) {
			forget_line(p_source_usec, arrival);
			return p_arrival_usec;
		}
		note({ passed, delay });
		const double waited = delay - (_offset + _slope * passed);
		return uint64_t(arrival - int64_t(std::max(waited, 0.0)));
	}

	/// Whether the source's time is believed.
	bool runs() const { return _runs; }

private:
	/// When a sample was taken by the source (in our µs since the beginning), and how late it came, µs.
	struct Point {
		double passed = 0.0;
		double delay = 0.0;
	};

	/// Over which rates are judged and a quickest arrival is kept.
	static constexpr int64_t SPAN_USEC = 1000000;
	/// So many of these are kept: a machine that is busy for seconds must not look like a drift.
	static constexpr std::size_t KEPT = 48;
	/// A source's time that goes back by more has begun anew; by less, a datagram was overtaken.
	static constexpr int64_t BACK_USEC = 200000;
	/// Earlier than that, or later for a while, it is no delay, but another stream.
	static constexpr double MAX_LEAP_USEC = 250000.0;
	static constexpr int64_t LASTING_USEC = 1500000;
	/// Parts by which a rate is another than expected, and by which measured ones are alike, in how many spans.
	static constexpr double ANOTHER = 0.05;
	static constexpr double ALIKE = 0.015;
	static constexpr int ALIKE_SPANS = 3;
	/// A time that is so many times slower than ours does not run.
	static constexpr double SLOWEST = 20.0;
	/// A time that is so many times slower or faster, for three spans, is none.
	static constexpr double STANDS = 4.0;
	/// Clocks drift by no more than this; a rate that was measured in a few spans is off by up to the second.
	static constexpr double MAX_DRIFT = 0.0015;
	static constexpr double MAX_RATE_ERROR = 0.02;
	/// Drift is not told from jitter in fewer spans; until then the newest few are all that counts.
	static constexpr std::size_t DRIFT_SPANS = 12;
	static constexpr std::size_t RECENT_SPANS = 4;
	/// A rough rate is better measured as soon as can be: by so many spans that are over.
	static constexpr std::size_t ROUGH_SPANS = 2;

	void begin(int64_t p_source, int64_t p_arrival) {
		_is_known = true;
		_last_source = _span_source = p_source;
		_span_arrival = p_arrival;
		_measured = 0.0;
		forget_line(p_source, p_arrival);
	}

	void forget_line(int64_t p_source, int64_t p_arrival) {
		_origin_source = p_source;
		_origin_arrival = _in_time_arrival = p_arrival;
		_count = 0;
		_offset = _slope = _ends = 0.0;
	}

	/// Judges once a span whether the source's time runs, and how fast.
	void judge(int64_t p_arrival) {
		if (p_arrival - _span_arrival < SPAN_USEC) {
			return;
		}
		const double ours = double(p_arrival - _span_arrival);
		const double measured = ours / std::max(double(_last_source - _span_source), 1e-3 * ours);
		_alike = std::abs(measured - _measured) <= ALIKE * measured ? _alike + 1 : 0;
		_measured = measured;
		if (std::abs(measured - _ratio) <= ANOTHER * _ratio) {
			_runs = true;
			_doubts = 0;
		} else if (_alike >= ALIKE_SPANS && measured < SLOWEST) {
			_runs = true;
			_doubts = 0;
			_ratio = measured;
			forget_line(_last_source, p_arrival);
		} else if (measured < _ratio * STANDS && measured > _ratio / STANDS) {
			_doubts = 0; // A machine that is busy: held up now, catching up next.
		} else if (++_doubts > 2) {
			_runs = false;
		}
		_span_source = _last_source;
		_span_arrival = p_arrival;
	}

	/// Whether a sample that comes so much later than expected, µs, does not belong to the line. A machine that is
	/// busy holds a whole second up, but then catches up.
	bool is_another_stream(double p_late, int64_t p_arrival) {
		if (p_late < MAX_LEAP_USEC) {
			_in_time_arrival = p_arrival;
		}
		return p_late < -MAX_LEAP_USEC || p_arrival - _in_time_arrival > LASTING_USEC;
	}

	/// Takes a point into the quickest arrival of its second.
	void note(const Point &p_point) {
		if (_count == 0 || p_point.passed >= _ends) {
			if (_count == KEPT) {
				std::copy(_quickest.begin() + 1, _quickest.end(), _quickest.begin());
				--_count;
			}
			_quickest[_count++] = p_point;
			_ends = p_point.passed + double(SPAN_USEC);
		} else if (p_point.delay < _quickest[_count - 1].delay) {
			_quickest[_count - 1] = p_point;
		} else {
			return;
		}
		draw();
	}

	/// Draws the line below all quickest arrivals.
	void draw() {
		const bool is_nominal = _ratio == 1.0 && !_is_rough;
		const double most = is_nominal ? MAX_DRIFT : MAX_RATE_ERROR;
		// A span that is not over has not had its quickest arrival yet.
		const std::size_t spans = _is_rough ? _count - 1 : _count;
		const bool is_long = spans >= (is_nominal ? DRIFT_SPANS : _is_rough ? ROUGH_SPANS : RECENT_SPANS);
		_slope = is_long ? std::clamp(hull_slope(spans), -most, most) : 0.0;
		std::size_t at = is_long || _count < RECENT_SPANS ? 0 : _count - RECENT_SPANS;
		_offset = _quickest[at].delay - _slope * _quickest[at].passed;
		for (++at; at < _count; ++at) {
			_offset = std::min(_offset, _quickest[at].delay - _slope * _quickest[at].passed);
		}
	}

	/// The slope of the hull's edge over the middle of the first points.
	double hull_slope(std::size_t p_count) const {
		std::array<Point, KEPT> hull{};
		std::size_t corners = 0;
		double middle = 0.0;
		for (std::size_t at = 0; at < p_count; ++at) {
			const Point &point = _quickest[at];
			middle += point.passed / double(p_count);
			while (corners >= 2 && is_above(hull[corners - 2], hull[corners - 1], point)) {
				--corners;
			}
			hull[corners++] = point;
		}
		std::size_t edge = 1;
		while (edge + 1 < corners && hull[edge].passed < middle) {
			++edge;
		}
		const Point &from = hull[edge - 1];
		const Point &to = hull[edge];
		return (to.delay - from.delay) / std::max(to.passed - from.passed, 1.0);
	}

	/// Whether the point in the middle lies on or above the line between the two others.
	static bool is_above(const Point &p_from, const Point &p_middle, const Point &p_to) {
		return (p_middle.delay - p_from.delay) * (p_to.passed - p_from.passed) >=
				(p_to.delay - p_from.delay) * (p_middle.passed - p_from.passed);
	}

	bool _is_trusted = false;
	bool _is_rough = false;
	bool _runs = false;
	bool _is_known = false;
	int64_t _last_source = 0;
	int64_t _origin_source = 0;
	int64_t _origin_arrival = 0;
	int64_t _span_source = 0;
	int64_t _span_arrival = 0;
	/// When a sample last came about as expected.
	int64_t _in_time_arrival = 0;
	/// Our time for each µs of the source's, and that of the span before.
	double _ratio = 1.0;
	double _measured = 0.0;
	int _doubts = 0;
	int _alike = 0;
	std::array<Point, KEPT> _quickest{};
	std::size_t _count = 0;
	double _ends = 0.0;
	double _offset = 0.0;
	double _slope = 0.0;
};

} // namespace clocks
