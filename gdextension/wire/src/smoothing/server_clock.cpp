// SPDX-License-Identifier: MIT
#include "server_clock.hpp"

#include <algorithm>
#include <cmath>

namespace wire {

ServerClock::Verdict ServerClock::arrived(uint32_t p_tick, double p_now_s) {
	const double delay = p_now_s - time_of(p_tick);
	Verdict verdict = Verdict::USABLE;
	if (is_known() && std::fabs(delay - difference) > JUMP_S) {
		// The parts of one tick are one witness.
		strange += strange == 0 || p_tick != strange_tick ? 1 : 0;
		strange_tick = p_tick;
		if (strange < CONFIRMATIONS) {
			return Verdict::OUTLANDISH;
		}
		clear();
		verdict = Verdict::NEW_SERVER;
	}
	strange = 0;
	note_interval(p_tick);
	note_delay(delay, p_now_s);
	if (p_now_s - window_begin > WINDOW_S) {
		// After a silence the arrivals before it tell nothing.
		quickest_before = p_now_s - last > SILENCE_S ? std::numeric_limits<double>::infinity() : quickest;
		window_begin = p_now_s;
		quickest = std::numeric_limits<double>::infinity();
	}
	quickest = std::min(quickest, delay);
	double rise = std::min(quickest, quickest_before) - difference;
	if (rise > 0.0 && rise <= PAUSE_S) {
		rise = std::min(rise, std::max(p_now_s - last, 0.0) * RISE);
	}
	difference = is_known() ? std::min(difference + std::max(rise, 0.0), delay) : delay;
	last = p_now_s;
	return verdict;
}

void ServerClock::clear() {
	const double rate = tick_rate;
	*this = ServerClock();
	tick_rate = rate;
}

void ServerClock::note_interval(uint32_t p_tick) {
	if (p_tick > newest_tick && newest_tick > 0) {
		gaps[gap_count++ % GAPS] = p_tick - newest_tick;
	}
	newest_tick = std::max(newest_tick, p_tick);
}

void ServerClock::note_delay(double p_delay, double p_now_s) {
	// Entities of one datagram count once.
	if (arrival_count > 0) {
		const Arrival &before = arrivals[(arrival_count - 1) % KEPT];
		if (before.at == p_now_s && before.delay == p_delay) {
			return;
		}
	}
	arrivals[arrival_count++ % KEPT] = { p_now_s, p_delay };
}

double ServerClock::lateness(double p_fraction) const {
	std::array<double, KEPT> delays;
	std::size_t count = 0;
	const std::size_t most = std::min(arrival_count, KEPT);
	for (std::size_t i = 0; i < most; i++) {
		if (last - arrivals[i].at <= LATENESS_S) {
			delays[count++] = arrivals[i].delay;
		}
	}
	if (count == 0) {
		return 0.0;
	}
	const double place = std::ceil(p_fraction * double(count)) - 1.0;
	const std::size_t rank = std::size_t(std::min(std::max(place, 0.0), double(count - 1)));
	std::nth_element(delays.begin(), delays.begin() + std::ptrdiff_t(rank), delays.begin() + std::ptrdiff_t(count));
	return std::max(delays[rank] - difference, 0.0);
}

double ServerClock::interval() const {
	std::array<uint32_t, GAPS> sorted = gaps;
	const std::size_t count = std::min(gap_count, GAPS);
	if (count == 0) {
		return 1.0 / tick_rate;
	}
	const auto middle = sorted.begin() + std::ptrdiff_t(count / 2);
	std::nth_element(sorted.begin(), middle, sorted.begin() + std::ptrdiff_t(count));
	return double(*middle) / tick_rate;
}

} // namespace wire
