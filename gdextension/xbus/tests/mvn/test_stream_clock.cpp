// SPDX-License-Identifier: MIT
// Times of samples from a time code and jittering arrivals.
#include "mvn/stream_clock.hpp"

#include <check.hpp>

#include <cmath>
#include <random>

using namespace mvn;

namespace {

/// How exactly times come out of a stream: the worst step between two, off its period, and the greatest delay.
struct Found {
	double step_ms = 0.0;
	double late_ms = 0.0;
	bool is_later_than_arrival = false;
};

/// Ten seconds at 60 Hz, of which the last five are judged. `p_code` makes the time code of a time, ms.
template <class Code>
Found play(StreamClock &r_clock, double p_jitter_ms, Code &&p_code) {
	std::mt19937 random(3);
	std::exponential_distribution<double> late(1.0 / p_jitter_ms);
	Found found;
	double before = 0.0;
	double arrival_before = 0.0;
	for (int number = 0; number < 600; ++number) {
		const double sampled = 1e6 + number * 1e6 / 60.0;
		const double arrival = std::max(sampled + 2000.0 + late(random) * 1000.0, arrival_before + 1.0);
		arrival_before = arrival;
		const double time = double(r_clock.timestamp(uint32_t(p_code(number / 60.0 * 1000.0)), uint64_t(arrival)));
		found.is_later_than_arrival = found.is_later_than_arrival || time > arrival;
		if (number > 300) {
			found.step_ms = std::max(found.step_ms, std::fabs(time - before - 1e6 / 60.0) / 1000.0);
			found.late_ms = std::max(found.late_ms, std::fabs(time - sampled) / 1000.0);
		}
		before = time;
	}
	return found;
}

} // namespace

TEST(a_running_time_code_takes_the_jitter_out) {
	StreamClock clock;
	const Found found = play(clock, 5.0, [](double p_ms) { return 70000.0 + p_ms; });
	CHECK(found.step_ms < 2.0);
	CHECK(found.late_ms < 4.0);
	CHECK(!found.is_later_than_arrival);
}

TEST(a_time_code_of_another_clock_is_followed) {
	StreamClock clock;
	const Found found = play(clock, 1.0, [](double p_ms) { return p_ms * 1.001; });
	CHECK(found.late_ms < 8.0);
	CHECK(!found.is_later_than_arrival);
}

TEST(a_time_code_that_does_not_run_is_not_believed) {
	for (const double speed : { 0.0, 0.5, 3.0 }) {
		StreamClock clock;
		const Found found = play(clock, 1.0, [speed](double p_ms) { return p_ms * speed; });
		CHECK(found.late_ms < 15.0);
		CHECK(!found.is_later_than_arrival);
	}
}

TEST(a_time_code_that_begins_anew_or_wraps_is_followed) {
	for (const uint32_t first : { 100000U, 0xFFFFFF00U }) {
		StreamClock clock;
		uint64_t worst = 0;
		for (uint32_t number = 0; number < 1000; ++number) {
			const uint64_t arrival = 5000000 + number * 10000ULL;
			const uint32_t code =
					number < 500 ? first + number * 10 : (first == 100000U ? number * 10 : first + number * 10);
			const uint64_t time = clock.timestamp(code, arrival);
			CHECK(time <= arrival);
			worst = std::max(worst, arrival - time);
		}
		CHECK(worst < 1000);
	}
}

TEST_MAIN()
