// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <limits>

namespace clocks {

/// Estimates how far another clock is apart from ours, and how it drifts, from when its messages arrive.
///
/// A message's delay is the time of its arrival by our clock minus its time by the other clock: the difference of the
/// clocks and the time in transit. The time in transit varies but never falls below a minimum, so the quickest
/// arrivals show the difference. Of every span of time the quickest arrival is kept. The estimate is the line
/// below all of them that is nearest to them on the whole: the edge of the lower convex hull over their middle
/// (Moon, Skelly, Towsley 1999, "Estimation and removal of clock skew from network delay measurements"). Before
/// enough spans are known for a drift, it is the quickest of the last few.
///
/// Every clock of ours that follows another one uses this class: the smoother's (ServerClock), a source's
/// (SourceClock), and those of scripts (QuickestArrivals of the extension `wire`). All times are in one unit, which
/// the caller chooses.
class QuickestArrivals {
public:
	/// So many spans are kept at most.
	static constexpr std::size_t MAX_KEPT = 48;

	/// The defaults, in seconds, are for a network whose delay may change for good: they forget within two seconds.
	struct Options {
		/// Of each span of so much time the quickest arrival is kept.
		double span = 1.0;
		/// So many spans are kept, 1 to MAX_KEPT; and so many of the newest count before the drift is known.
		std::size_t kept = 2;
		std::size_t recent = 2;
		/// The drift is fitted from so many spans on (2 or more); with fewer kept, it is taken to be 0.
		std::size_t drift_spans = MAX_KEPT + 1;
		/// Two clocks drift by this part at most; more is an error of measurement.
		double max_drift = 0.0;
		/// Whether a span that is not over yet counts for the drift.
		bool counts_open_span = true;
		/// The estimate falls at once, but rises by this part of the time that passes, so that whoever follows it
		/// hardly has to wait. A rise beyond `pause` is taken over at once: the other machine had paused.
		double rise = 0.1;
		double pause = 0.25;
		/// After so long without an arrival those before it do not count.
		double silence = 0.5;
	};

	QuickestArrivals() = default;
	explicit QuickestArrivals(const Options &p_options) : _options(p_options) {}

	/// Takes the delay of a message that arrived at a time (by our clock, or by the other's where that goes evenly).
	void note(double p_at, double p_delay);
	/// Forgets all arrivals.
	void clear() { *this = QuickestArrivals(_options); }

	bool is_known() const { return _count > 0; }
	/// The delay of a message that arrives at a time and is as quick as the quickest; infinite before the first.
	double delay_at(double p_at) const { return _offset + _slope * (p_at - _origin); }
	/// How much the delay grows per time; 0 as long as it is not known.
	double drift() const { return _slope; }

private:
	/// An arrival, and by how much it came later than the other clock said.
	struct Arrival {
		double at = 0.0;
		double delay = 0.0;
	};

	bool _keep(const Arrival &p_arrival);
	double _draw();
	double _hull_slope(std::size_t p_count) const;

	Options _options;
	std::array<Arrival, MAX_KEPT> _quickest{};
	std::size_t _count = 0;
	double _span_end = 0.0;
	double _last = 0.0;
	/// The line: its height at `_origin` (the first arrival of all) as it is drawn and as far as it has risen, its
	/// slope.
	double _origin = 0.0;
	double _target = std::numeric_limits<double>::infinity();
	double _offset = std::numeric_limits<double>::infinity();
	double _slope = 0.0;
};

} // namespace clocks
