// SPDX-License-Identifier: MIT
#pragma once

#include "quickest_arrivals.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace clocks {

/// Estimates when samples were taken, in this machine's time, by the source's own time (a time code, or a counter
/// times the period) and the times at which they arrive (`QuickestArrivals`).
///
/// A source whose time runs at another rate than ours (slow motion, a period other than was asked for) is believed
/// once some seconds agree on it; one whose time does not run at all has the times of arrival.
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
		if (_arrivals.is_known() && is_another_stream(delay - _arrivals.delay_at(passed), arrival)) {
			forget_line(p_source_usec, arrival);
			return p_arrival_usec;
		}
		_arrivals.note(passed, delay);
		return uint64_t(arrival - int64_t(std::max(delay - _arrivals.delay_at(passed), 0.0)));
	}

	/// Whether the source's time is believed.
	bool runs() const { return _runs; }

private:
	/// Over which rates are judged and a quickest arrival is kept. As many as can be are kept: a machine that is busy
	/// for seconds must not look like a drift.
	static constexpr int64_t SPAN_USEC = 1000000;
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
		const bool is_nominal = _ratio == 1.0 && !_is_rough;
		QuickestArrivals::Options options;
		options.span = double(SPAN_USEC);
		options.kept = QuickestArrivals::MAX_KEPT;
		options.recent = RECENT_SPANS;
		options.drift_spans = is_nominal ? DRIFT_SPANS : _is_rough ? ROUGH_SPANS : RECENT_SPANS;
		options.max_drift = is_nominal ? MAX_DRIFT : MAX_RATE_ERROR;
		// A span that is not over has not had its quickest arrival yet.
		options.counts_open_span = !_is_rough;
		options.pause = 0.0;
		options.silence = std::numeric_limits<double>::infinity();
		_arrivals = QuickestArrivals(options);
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
	/// By the source's time, µs since its origin.
	QuickestArrivals _arrivals;
};

} // namespace clocks
