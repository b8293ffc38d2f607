// SPDX-License-Identifier: MIT
// Times of samples from a source's own time and jittering arrivals.
#include "source_clock.hpp"

#include <check.hpp>

#include <cmath>
#include <functional>
#include <random>

namespace test_source_clock {

using clocks::SourceClock;

namespace {

/// How exactly times come out of a stream: the worst step between two, off its period, and the greatest error.
struct Found {
	double step_ms = 0.0;
	double off_ms = 0.0;
	bool is_later_than_arrival = false;
};

/// Half a minute at 60 Hz, of which the second half is judged. `p_code` makes the source's time of a time, ms.
Found play(SourceClock &r_clock, double p_jitter_ms, const std::function<double(double)> &p_code) {
	std::mt19937 random(3);
	std::exponential_distribution<double> late(1.0 / p_jitter_ms);
	Found found;
	double before = 0.0;
	double arrival_before = 0.0;
	for (int number = 0; number < 1800; ++number) {
		const double sampled = 1e6 + number * 1e6 / 60.0;
		const double arrival = std::max(sampled + late(random) * 1000.0, arrival_before + 1.0);
		arrival_before = arrival;
		const auto source = int64_t(p_code(number / 60.0 * 1000.0) * 1000.0);
		const double time = double(r_clock.timestamp(source, uint64_t(arrival)));
		found.is_later_than_arrival = found.is_later_than_arrival || time > arrival;
		if (number > 900) {
			found.step_ms = std::max(found.step_ms, std::fabs(time - before - 1e6 / 60.0) / 1000.0);
			found.off_ms = std::max(found.off_ms, std::fabs(time - sampled) / 1000.0);
		}
		before = time;
	}
	return found;
}

} // namespace

TEST(a_running_time_takes_the_jitter_out) {
	SourceClock clock;
	const Found found = play(clock, 5.0, [](double p_ms) { return 70000.0 + p_ms; });
	CHECK(found.step_ms < 0.3);
	CHECK(found.off_ms < 0.5);
	CHECK(!found.is_later_than_arrival);
}

TEST(a_clock_that_drifts_is_followed) {
	for (const double rate : { 0.999, 0.9998, 1.0002, 1.001 }) {
		SourceClock clock(true);
		const Found found = play(clock, 5.0, [rate](double p_ms) { return p_ms * rate; });
		CHECK(found.off_ms < 1.5);
		CHECK(!found.is_later_than_arrival);
	}
}

TEST(whole_milliseconds_are_enough) {
	SourceClock clock;
	const Found found = play(clock, 2.0, [](double p_ms) { return std::floor(p_ms); });
	CHECK(found.off_ms < 1.5);
}

TEST(a_time_that_stands_is_not_believed) {
	SourceClock clock;
	const Found found = play(clock, 1.0, [](double) { return 0.0; });
	CHECK(!clock.runs());
	CHECK(found.off_ms < 15.0);
	CHECK(!found.is_later_than_arrival);
}

TEST(a_time_that_leaps_about_is_not_believed) {
	SourceClock clock;
	std::mt19937 random(5);
	std::uniform_real_distribution<double> any(0.0, 1e7);
	const Found found = play(clock, 1.0, [&](double) { return any(random); });
	CHECK(found.off_ms < 15.0);
	CHECK(!found.is_later_than_arrival);
}

TEST(another_rate_is_believed_once_it_lasts) {
	for (const double speed : { 0.5, 0.6, 1.25, 3.0 }) {
		SourceClock clock(true);
		const Found found = play(clock, 1.0, [speed](double p_ms) { return p_ms * speed; });
		CHECK(clock.runs());
		CHECK(found.off_ms < 2.0);
		CHECK(!found.is_later_than_arrival);
	}
}

TEST(a_hold_up_in_transit_is_no_other_rate) {
	SourceClock clock(true);
	for (int64_t counter = 1; counter < 3000; ++counter) {
		// Every half second all wait for a quarter of it.
		const int64_t sampled = 5000000 + counter * 10000;
		const int64_t phase = sampled % 500000;
		const int64_t arrival = phase < 120000 ? sampled - phase + 120000 : sampled;
		const auto stamped = int64_t(clock.timestamp(counter * 10000, uint64_t(arrival)));
		if (counter > 100) {
			CHECK(std::abs(stamped - sampled) < 200);
		}
	}
}

TEST(a_machine_that_is_late_for_seconds_does_not_move_the_line) {
	SourceClock clock(true);
	std::mt19937 random(7);
	std::uniform_real_distribution<double> late(4000.0, 30000.0);
	int64_t before = 0;
	for (int64_t counter = 1; counter < 6000; ++counter) {
		const int64_t sampled = 5000000 + counter * 10000;
		const bool is_busy = counter % 1000 > 500;
		before = std::max(before + 1, sampled + (is_busy ? int64_t(late(random)) : 100));
		const int64_t arrival = before;
		const auto stamped = int64_t(clock.timestamp(counter * 10000, uint64_t(arrival)));
		if (counter > 2000) {
			CHECK(std::abs(stamped - sampled) < 500);
		}
	}
}

TEST(a_hold_up_of_a_second_is_caught_up) {
	SourceClock clock(true);
	for (int64_t counter = 1; counter < 6000; ++counter) {
		const int64_t sampled = 5000000 + counter * 10000;
		const int64_t until = 5000000 + counter / 700 * 7000000 + 1000000;
		const int64_t arrival = std::max(sampled, until) + counter % 3;
		const auto stamped = int64_t(clock.timestamp(counter * 10000, uint64_t(arrival)));
		if (counter > 700) {
			CHECK(std::abs(stamped - sampled) < 500);
		}
	}
}

TEST(a_stream_that_pauses_goes_on) {
	SourceClock clock(true);
	for (int64_t counter = 1; counter < 6000; ++counter) {
		// The counter of a device goes on while nothing is sent, or stands.
		const bool stands = counter > 3000;
		const int64_t pause = counter > 1500 ? 8000000 : 0;
		const int64_t sampled = 5000000 + counter * 10000 + pause + (stands ? 4000000 : 0);
		const auto stamped = int64_t(clock.timestamp(counter * 10000 + pause, uint64_t(sampled + 50)));
		if (counter > 3000 + 200 || counter < 3000) {
			CHECK(std::abs(stamped - sampled) < 500);
		}
	}
}

TEST(a_source_that_begins_anew_is_followed) {
	for (const int64_t leap : { -3000000LL, 100000000LL }) {
		SourceClock clock(true);
		int64_t worst = 0;
		for (int64_t number = 0; number < 1000; ++number) {
			const int64_t arrival = 5000000 + number * 10000;
			const int64_t source = number * 10000 + (number < 500 ? 0 : leap);
			const auto time = int64_t(clock.timestamp(source, uint64_t(arrival)));
			CHECK(time <= arrival);
			worst = std::max(worst, arrival - time);
		}
		CHECK(worst < 1000);
	}
}

TEST(datagrams_that_overtake_one_another_keep_their_times) {
	SourceClock clock(true);
	for (int64_t number = 0; number < 1000; ++number) {
		const int64_t swapped = number % 10 == 3 ? number + 1 : number % 10 == 4 ? number - 1 : number;
		const int64_t arrival = 5000000 + number * 10000 + 10000;
		const auto time = int64_t(clock.timestamp(swapped * 10000, uint64_t(arrival)));
		if (number > 10) {
			CHECK(std::abs(time - (5000000 + swapped * 10000)) <= 10000);
		}
	}
}

} // namespace test_source_clock
