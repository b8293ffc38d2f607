// SPDX-License-Identifier: MIT
// How far two clocks are apart, from arrivals that jitter, get lost, come in bursts or change for good.
#include "quickest_arrivals.hpp"

#include <check.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

namespace test_quickest_arrivals {

using clocks::QuickestArrivals;

namespace {

constexpr double APART_S = -1.7e6; // The other clock is ahead.
constexpr double MIN_DELAY_S = 0.02; // What the quickest are in transit.

QuickestArrivals::Options drifting() {
	QuickestArrivals::Options options;
	options.kept = QuickestArrivals::MAX_KEPT;
	options.drift_spans = 8;
	options.max_drift = 0.001;
	options.pause = 0.0;
	options.silence = 60.0;
	return options;
}

/// Messages at 60 Hz that wait for so long beyond the least, s (below 0: lost). Returns the worst error of the
/// estimate after a time, s.
double play(QuickestArrivals &r_arrivals, double p_length_s, double p_after_s, double p_drift,
		const std::function<double(double)> &p_waits) {
	double worst = 0.0;
	for (int number = 0; number < int(p_length_s * 60.0); ++number) {
		const double sent = number / 60.0;
		const double waits = p_waits(sent);
		if (waits < 0.0) {
			continue;
		}
		const double at = sent + MIN_DELAY_S + waits;
		r_arrivals.note(at, APART_S + MIN_DELAY_S + p_drift * sent + waits);
		if (sent > p_after_s) {
			worst = std::max(worst, std::fabs(r_arrivals.delay_at(at) - (APART_S + MIN_DELAY_S + p_drift * sent)));
		}
	}
	return worst;
}

} // namespace

TEST(nothing_is_known_before_the_first_arrival) {
	QuickestArrivals arrivals;
	CHECK(!arrivals.is_known());
	CHECK(std::isinf(arrivals.delay_at(5.0)));
	arrivals.note(5.0, 0.25);
	CHECK_NEAR(arrivals.delay_at(9.0), 0.25, 1e-12);
	arrivals.clear();
	CHECK(!arrivals.is_known());
}

TEST(jitter_and_loss_hardly_move_it) {
	for (const bool fits : { false, true }) {
		QuickestArrivals arrivals = fits ? QuickestArrivals(drifting()) : QuickestArrivals();
		std::mt19937 random(4);
		std::uniform_real_distribution<double> any(0.0, 1.0);
		const double off =
				play(arrivals, 120.0, 15.0, 0.0, [&](double) { return any(random) < 0.2 ? -1.0 : 0.03 * any(random); });
		CHECK(off < 0.004);
	}
}

TEST(drift_is_found) {
	for (const double drift : { -300e-6, -20e-6, 20e-6, 300e-6 }) {
		QuickestArrivals arrivals(drifting());
		std::mt19937 random(4);
		std::exponential_distribution<double> late(100.0);
		CHECK(play(arrivals, 60.0, 20.0, drift, [&](double) { return late(random); }) < 0.002);
		CHECK_NEAR(arrivals.drift(), drift, 20e-6);
	}
}

TEST(no_drift_is_beyond_the_maximum) {
	QuickestArrivals arrivals(drifting());
	play(arrivals, 60.0, 20.0, 0.05, [](double) { return 0.0; });
	CHECK_NEAR(arrivals.drift(), 0.001, 1e-9);
}

TEST(bursts_do_not_move_it) {
	// All of a quarter of a second come at once, with the last of them.
	QuickestArrivals arrivals(drifting());
	const double off = play(arrivals, 60.0, 2.0, 0.0,
			[](double p_sent) { return std::fmod(p_sent, 1.0) < 0.25 ? 0.25 - std::fmod(p_sent, 1.0) : 0.0; });
	CHECK(off < 1e-6);
}

TEST(it_falls_at_once_and_rises_slowly) {
	QuickestArrivals arrivals;
	play(arrivals, 5.0, 0.0, 0.0, [](double) { return 0.0; });
	// 0.1 s more for good: the first two seconds it counts as jitter, then the estimate rises by 0.1 s/s.
	double before = arrivals.delay_at(5.0);
	double steepest = 0.0;
	for (int number = 300; number < 540; ++number) {
		const double at = number / 60.0 + 0.1;
		arrivals.note(at, APART_S + MIN_DELAY_S + 0.1);
		steepest = std::max(steepest, arrivals.delay_at(at) - before);
		before = arrivals.delay_at(at);
	}
	CHECK_NEAR(before, APART_S + MIN_DELAY_S + 0.1, 1e-6);
	CHECK(steepest < 0.1 * (0.1 + 1.0 / 60.0) + 1e-6);
	arrivals.note(9.2, APART_S + MIN_DELAY_S);
	CHECK_NEAR(arrivals.delay_at(9.2), APART_S + MIN_DELAY_S, 1e-9);
}

TEST(a_long_step_is_a_pause_and_taken_over_at_once) {
	QuickestArrivals arrivals;
	play(arrivals, 5.0, 0.0, 0.0, [](double) { return 0.0; });
	for (int number = 300; number < 430; ++number) {
		arrivals.note(number / 60.0 + 0.3, APART_S + MIN_DELAY_S + 0.3);
	}
	CHECK_NEAR(arrivals.delay_at(8.0), APART_S + MIN_DELAY_S + 0.3, 1e-9);
}

TEST(what_came_before_a_silence_does_not_count) {
	QuickestArrivals arrivals;
	play(arrivals, 5.0, 0.0, 0.0, [](double) { return 0.0; });
	arrivals.note(25.0, APART_S + MIN_DELAY_S + 1.0);
	CHECK_NEAR(arrivals.delay_at(25.0), APART_S + MIN_DELAY_S + 1.0, 1e-9);
}

TEST(it_is_never_later_than_an_arrival) {
	std::mt19937 random(9);
	for (int round = 0; round < 200; ++round) {
		QuickestArrivals arrivals = round % 2 == 0 ? QuickestArrivals() : QuickestArrivals(drifting());
		std::uniform_real_distribution<double> step(0.0, round % 3 == 0 ? 3.0 : 0.05);
		std::uniform_real_distribution<double> delay(-1.0, 1.0);
		double at = 0.0;
		for (int number = 0; number < 500; ++number) {
			at += step(random);
			const double late = delay(random);
			arrivals.note(at, late);
			CHECK(arrivals.delay_at(at) <= late + 1e-9);
			CHECK(std::fabs(arrivals.drift()) <= 0.001);
		}
	}
}

} // namespace test_quickest_arrivals
