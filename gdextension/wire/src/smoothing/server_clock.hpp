// SPDX-License-Identifier: MIT
#pragma once

#include <quickest_arrivals.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace wire {

/// What the server's clock shows, seen from a client: estimated from when ticks arrive.
///
/// The quickest arrivals of the last one or two seconds give the difference of the clocks (`QuickestArrivals`). What
/// the others were later than that says how far display must stay behind to have them in time.
class ServerClock {
public:
	/// What a tick is to the clock.
	enum class Verdict {
		USABLE,
		OUTLANDISH, ///< More than JUMP_S off; perhaps the first of a new server.
		NEW_SERVER, ///< CONFIRMATIONS in a row were: the clock has begun anew, and so must all tracks.
	};

	static constexpr double JUMP_S = 5.0; ///< Ticks that are further off come from another server.
	static constexpr int CONFIRMATIONS = 3; ///< One stray datagram does not make a new server.
	static constexpr double LATENESS_S = 2.0; ///< Span over which lateness counts.
	static constexpr double LATELY_S = 0.1; ///< Span whose quickest arrival counts for lately_now().

	/// Takes note of a tick that arrived at a time of the client's clock, s.
	Verdict arrived(uint32_t p_tick, double p_now_s);
	void clear();

	bool is_known() const { return _quickest.is_known(); }
	/// Time of a tick in the server's clock, s.
	double time_of(uint32_t p_tick) const { return double(p_tick) / tick_rate; }
	/// Time of the newest tick that has arrived, s.
	double newest() const { return time_of(_newest_tick); }
	/// The server's time of what would arrive now if it was as quick as the quickest, s.
	double server_now(double p_now_s) const { return p_now_s - _difference(); }
	/// The server's time of what would arrive now if it was as quick as the quickest of late, s. Beyond
	/// server_now() never; behind it while the server runs slower than its clock.
	double lately_now(double p_now_s) const;
	/// How much later than the quickest a fraction (0 to 1) of the arrivals is not, s.
	double lateness(double p_fraction) const;
	/// Time between two ticks that are sent, s: the median of the last ones.
	double interval() const;

	double tick_rate = 60.0; ///< Ticks per second.

private:
	struct Arrival {
		double at = 0.0;
		double delay = 0.0;
	};

	/// The client's time minus the server's at the quickest arrival, s.
	double _difference() const { return _quickest.delay_at(_last); }
	void _note_interval(uint32_t p_tick);
	void _note_delay(double p_delay, double p_now_s);

	static constexpr std::size_t KEPT = 256;
	static constexpr std::size_t GAPS = 9;

	clocks::QuickestArrivals _quickest;
	double _last = 0.0;
	std::array<Arrival, KEPT> _arrivals{};
	std::size_t _arrival_count = 0; // Of all; the newest KEPT are kept.
	std::array<uint32_t, GAPS> _gaps{};
	std::size_t _gap_count = 0;
	uint32_t _newest_tick = 0;
	uint32_t _strange_tick = 0;
	int _strange = 0;
};

} // namespace wire
