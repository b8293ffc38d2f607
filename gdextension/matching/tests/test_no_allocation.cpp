// SPDX-License-Identifier: MIT
// A tick allocates nothing.
#include "walker_fixture.hpp"

#include <motion_matcher.hpp>

#include <check.hpp>
#include <count_allocations.hpp>

using namespace matching;

TEST(a_tick_allocates_nothing) {
	MotionMatcher made;
	made.set_motion_set(walker_fixture::motion_set());
	made.reset({ 1.0f, 0.0f, 2.0f }, 0.5f);
	Wish wish;
	const int before = allocations;
	for (int i = 0; i < 600; i++) {
		wish.wished_velocity.z = i % 100 < 60 ? 2.0f : 0.0f;
		wish.velocity = wish.velocity + (wish.wished_velocity - wish.velocity) * 0.1f;
		wish.position = wish.position + wish.velocity * (1.0f / 60.0f);
		wish.stance = i > 500 ? PRONE : (i > 400 ? CROUCH : STAND);
		made.advance(1.0f / 60.0f, wish);
	}
	CHECK(made.searches() > 20);
	CHECK(allocations == before);
}

TEST_MAIN()
