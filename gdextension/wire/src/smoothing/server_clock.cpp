// SPDX-License-Identifier: MIT
#include "smoothing/server_clock.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wire {

ServerClock::Verdict ServerClock::arrived(uint32_t p_tick, double p_now_s) {
	const double delay = p_now_s - time_of(p_tick);
	Verdict verdict = Verdict::USABLE;
	if (is_known() && std::fabs(delay - _difference()) > JUMP_S) {
		// The parts of one tick are one witness.
		_strange += _strange == 0 || p_tick != _strange_tick ? 1 : 0;
		_strange_tick = p_tick;
		if (_strange < CONFIRMATIONS) {
			return Verdict::OUTLANDISH;
		}
		clear();
		verdict = Verdict::NEW_SERVER;
	}
	_strange = 0;
	_note_interval(p_tick);
	_note_delay(delay, p_now_s);
	_quickest.note(p_now_s, delay);
	_last = p_now_s;
	return verdict;
}

void ServerClock::clear() {
	const double rate = tick_rate;
	*this = ServerClock();
	tick_rate = rate;
}

void ServerClock::_note_interval(uint32_t p_tick) {
	if (p_tick > _newest_tick && _newest_tick > 0) {
		_gaps[_gap_count++ % GAPS] = p_tick - _newest_tick;
	}
	_newest_tick = std::max(_newest_tick, p_tick);
}

void ServerClock::_note_delay(double p_delay, double p_now_s) {
	// Entities of one datagram count once.
	if (_arrival_count > 0) {
		const Arrival &before = _arrivals[(_arrival_count - 1) % KEPT];
		if (before.at == p_now_s && before.delay == p_delay) {
			return;
		}
	}
	_arrivals[_arrival_count++ % KEPT] = { p_now_s, p_delay };
}

double ServerClock::lately_now(double p_now_s) const {
	double quickest = std::numeric_limits<double>::infinity();
	for (std::size_t i = 0; i < std::min(_arrival_count, KEPT); i++) {
		if (_last - _arrivals[i].at <= LATELY_S) {
			quickest = std::min(quickest, _arrivals[i].delay);
		}
	}
	return p_now_s - std::max(quickest, _difference());
}

double ServerClock::lateness(double p_fraction) const {
	std::array<double, KEPT> delays;
	std::size_t count = 0;
	const std::size_t most = std::min(_arrival_count, KEPT);
	for (std::size_t i = 0; i < most; i++) {
		if (_last - _arrivals[i].at <= LATENESS_S) {
			delays[count++] = _arrivals[i].delay;
		}
	}
	if (count == 0) {
		return 0.0;
	}
	const double index = std::ceil(p_fraction * double(count)) - 1.0;
	const std::size_t rank = std::size_t(std::min(std::max(index, 0.0), double(count - 1)));
	std::nth_element(delays.begin(), delays.begin() + std::ptrdiff_t(rank), delays.begin() + std::ptrdiff_t(count));
	return std::max(delays[rank] - _difference(), 0.0);
}

double ServerClock::interval() const {
	std::array<uint32_t, GAPS> sorted = _gaps;
	const std::size_t count = std::min(_gap_count, GAPS);
	if (count == 0) {
		return 1.0 / tick_rate;
	}
	const auto middle = sorted.begin() + std::ptrdiff_t(count / 2);
	std::nth_element(sorted.begin(), middle, sorted.begin() + std::ptrdiff_t(count));
	return double(*middle) / tick_rate;
}

} // namespace wire
