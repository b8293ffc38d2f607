// SPDX-License-Identifier: MIT
#include "batch_pause.hpp"
#include "check.hpp"

namespace test_batch_pause {

using transport::BatchPause;

namespace {

constexpr int64_t TICK_USEC = 16667;

BatchPause in_step() {
	BatchPause pause;
	for (int64_t tick = 100; tick <= 102; tick++) {
		pause.handed_over(tick * TICK_USEC);
	}
	return pause;
}

} // namespace

TEST(pauses_are_long_between_ticks_and_short_near_them) {
	const BatchPause pause = in_step();
	const int64_t last = 102 * TICK_USEC;
	CHECK(pause.usec(last) == BatchPause::LONG_USEC);
	CHECK(pause.usec(last + 10000) == BatchPause::LONG_USEC);
	// Never past the moment at which the snapshots are near.
	CHECK(pause.usec(last + 14000) == TICK_USEC - BatchPause::NEAR_USEC - 14000);
	CHECK(pause.usec(last + TICK_USEC) == BatchPause::SHORT_USEC);
	CHECK(pause.usec(last + TICK_USEC + 1500) == BatchPause::SHORT_USEC);
}

TEST(a_main_thread_that_stands_still_gets_even_pauses) {
	const BatchPause pause = in_step();
	CHECK(pause.usec(200 * TICK_USEC) == 2 * BatchPause::SHORT_USEC);
	CHECK(BatchPause().usec(1000000) == 2 * BatchPause::SHORT_USEC);
}

} // namespace test_batch_pause
