// SPDX-License-Identifier: MIT
// Times of samples that wait on their way for different times.
#include "stream_time.hpp"

#include <check.hpp>

#include <cmath>
#include <random>

namespace test_stream_time {

using clocks::StreamTime;

namespace {

/// How far off times are of a sender with so many samples a second, which wait for up to `p_jitter_usec`: the worst of
/// those of 2 to 60 s, µs. `p_counts`: it says its count; otherwise a clock that is a hundred parts in a million slow.
int64_t worst_of(bool p_counts, double p_rate_hz, double p_jitter_usec, uint32_t p_seed) {
	std::mt19937 random(p_seed);
	std::uniform_real_distribution<double> late(0.0, p_jitter_usec);
	std::uniform_real_distribution<double> chance(0.0, 1.0);
	StreamTime time;
	int64_t worst = 0;
	int64_t arrival = 0;
	for (int number = 0; number < int(60.0 * p_rate_hz); ++number) {
		const int64_t taken = 5000000000 + int64_t(number * 1e6 / p_rate_hz);
		if (chance(random) < 0.05) {
			continue; // Lost.
		}
		arrival = std::max(arrival + 1, taken + 2000 + int64_t(late(random)));
		const int64_t found = p_counts ? time.at_count(number, arrival)
									   : time.at(int64_t(number * 1e6 / p_rate_hz * 0.9999), arrival);
		CHECK(found <= arrival);
		if (number > 2 * p_rate_hz) {
			worst = std::max<int64_t>(worst, std::abs(found - taken - 2000));
		}
	}
	return worst;
}

} // namespace

TEST(a_sender_s_clock_is_free_of_the_network_s_jitter) {
	for (uint32_t seed = 0; seed < 10; ++seed) {
		CHECK(worst_of(false, 240.0, 3000.0, seed) < 600);
		CHECK(worst_of(false, 60.0, 3000.0, seed) < 900);
	}
}

TEST(a_sender_that_only_counts_is_taken_to_measure_evenly) {
	for (uint32_t seed = 0; seed < 10; ++seed) {
		CHECK(worst_of(true, 240.0, 3000.0, seed) < 400);
		CHECK(worst_of(true, 60.0, 3000.0, seed) < 1000);
		CHECK(worst_of(true, 60.0, 0.0, seed) < 10);
	}
}

TEST(a_clock_that_stands_still_is_not_believed) {
	StreamTime time;
	for (int number = 0; number < 400; ++number) {
		const int64_t arrival = 1000000000 + number * 10000;
		CHECK(time.at(7, arrival) == arrival);
	}
}

TEST(times_never_go_back) {
	StreamTime time;
	std::mt19937 random(2);
	int64_t last = 0;
	for (int number = 0; number < 1000; ++number) {
		const int64_t found = time.at(number * 5000, 1000000000 + number * 5000 + int64_t(random() % 4000));
		CHECK(found > last);
		last = found;
	}
}

TEST(a_count_that_begins_anew_after_a_pause_is_followed) {
	for (const bool counts : { false, true }) {
		StreamTime time;
		for (int number = 0; number < 3000; ++number) {
			const int64_t pause = number >= 1500 ? 3000000 : 0;
			const int64_t count = number >= 1500 ? number - 1500 : number;
			const int64_t arrival = 1000000000 + number * 5000 + pause + number % 3 * 100;
			const int64_t found = counts ? time.at_count(count, arrival) : time.at(count * 5000, arrival);
			CHECK(std::abs(found - arrival) < 1000);
		}
	}
}

} // namespace test_stream_time
