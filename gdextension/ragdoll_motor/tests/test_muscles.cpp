// SPDX-License-Identifier: MIT
#include "joint/muscles.hpp"

#include "check.hpp"

namespace test_muscles {

using namespace ragdoll;

namespace {

constexpr float DELTA = 1.0f / 60.0f;
constexpr float WHOLE = 100.0f;
constexpr float FAST = 8.0f;
const Vec3 INERTIA{ 0.5f, 0.5f, 0.5f };

/// The torque in the last of some steps at an even speed.
float torque_at(Muscles &r_muscles, float p_speed, int p_steps = 2) {
	float torque = 0.0f;
	for (int i = 0; i < p_steps; i++) {
		torque = r_muscles.get_torque(0, { p_speed, 0.0f, 0.0f }, {}, INERTIA, FAST, DELTA, WHOLE);
	}
	return torque;
}

} // namespace

TEST(a_joint_at_rest_has_its_whole_torque) {
	Muscles muscles(1);
	CHECK_NEAR(torque_at(muscles, 0.0f), WHOLE, 1e-4);
}

TEST(the_faster_the_less) {
	float before = WHOLE;
	for (const float speed : { 1.0f, 2.0f, 4.0f }) {
		Muscles muscles(1);
		const float torque = torque_at(muscles, speed);
		CHECK(torque < before);
		before = torque;
	}
	Muscles muscles(1);
	CHECK_NEAR(torque_at(muscles, 2.0f * FAST), Muscles::MIN * WHOLE, 1e-3);
}

TEST(what_the_motion_needs_is_there) {
	Muscles muscles(1);
	torque_at(muscles, 10.0f);
	const float accelerated = 11.0f;
	const float needed = 1.0f * INERTIA.x / DELTA;
	const float torque = muscles.get_torque(
			0, { accelerated, 0.0f, 0.0f }, { 1.0f, 0.0f, 0.0f }, INERTIA, FAST, DELTA, 10.0f * WHOLE);
	CHECK(torque > needed);
}

TEST(a_braking_motion_does_not_push_on) {
	Muscles pushing(1);
	Muscles braking(1);
	torque_at(pushing, 10.0f);
	torque_at(braking, 10.0f);
	const Vec3 slower{ 9.0f, 0.0f, 0.0f };
	// The limb is too fast, or something has stopped it.
	const float brake = braking.get_torque(0, slower, { -1.0f, 0.0f, 0.0f }, INERTIA, FAST, DELTA, WHOLE);
	const float push = pushing.get_torque(0, slower, { 5.0f, 0.0f, 0.0f }, INERTIA, FAST, DELTA, WHOLE);
	CHECK(push < brake);
}

TEST(torque_comes_back_at_rest) {
	Muscles muscles(1);
	torque_at(muscles, 20.0f);
	CHECK(torque_at(muscles, 0.0f) < 0.4f * WHOLE);
	CHECK_NEAR(torque_at(muscles, 0.0f, 30), WHOLE, 1e-4);
	torque_at(muscles, 20.0f);
	muscles.reset();
	CHECK_NEAR(torque_at(muscles, 0.0f, 1), WHOLE, 1e-4);
}

TEST(never_more_than_the_whole) {
	Muscles muscles(1);
	for (int i = 0; i < 100; i++) {
		const float speed = float((i * 37) % 50) - 25.0f;
		const float torque =
				muscles.get_torque(0, { speed, -speed, 1.0f }, { speed, 0.0f, 0.0f }, INERTIA, FAST, DELTA, 3.0f);
		CHECK(torque > 0.0f && torque <= 3.0f);
	}
}

TEST(the_torque_follows_the_speed_without_steps) {
	float before = WHOLE;
	float largest = 0.0f;
	Muscles muscles(1);
	for (int i = 0; i <= 400; i++) {
		const float speed = FAST * float(i) / 400.0f;
		// As slowly as here nothing is needed for the speeding-up itself.
		const float torque = muscles.get_torque(0, { speed, 0.0f, 0.0f }, {}, INERTIA * 0.0f, FAST, DELTA, WHOLE);
		CHECK(torque <= before);
		largest = std::max(largest, before - torque);
		before = torque;
	}
	CHECK_NEAR(before, Muscles::MIN * WHOLE, Muscles::DEAD_BAND * WHOLE);
	CHECK(largest < 2.0f * Muscles::DEAD_BAND * WHOLE);
}

TEST(a_torque_that_hardly_changes_stays_and_a_full_one_comes_at_once) {
	Muscles muscles(1);
	const float begin = torque_at(muscles, 1.0f);
	CHECK_NEAR(torque_at(muscles, 1.02f), begin, 0.0);
	CHECK(torque_at(muscles, 2.0f) < begin);
	// All the way back: the last hundredth is not held back.
	CHECK_NEAR(torque_at(muscles, 0.0f, 60), WHOLE, 0.0);
}

} // namespace test_muscles
