// SPDX-License-Identifier: MIT
#include "fixtures.hpp"

#include <check.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace test_drivetrain {

using namespace vehicle;

TEST(it_speeds_up_through_its_gears) {
	OnRails rails;
	rails.run({ 1.0f, 0.0f, 0.0f, 0.0f, Selector::AUTOMATIC }, 40.0f);
	CHECK(rails.tank.gearbox.gear() == 4);
	// 2600 1/min in fourth gear, within the governor's band.
	CHECK_NEAR(rails.speed, 2600.0f * 0.10472f / 8.1f * 0.6f, 1.2f);
}

TEST(it_brakes_and_then_holds_itself) {
	OnRails rails;
	rails.run({ 1.0f, 0.0f, 0.0f, 0.0f, Selector::AUTOMATIC }, 10.0f);
	rails.run({ 0.0f, 0.0f, 1.0f, 0.0f, Selector::AUTOMATIC }, 10.0f);
	CHECK_NEAR(rails.speed, 0.0f, 1e-3f);
	rails.slope_force = 200e3f;
	rails.run({ 0.0f, 0.0f, 0.0f, 0.0f, Selector::AUTOMATIC }, 5.0f);
	CHECK_NEAR(rails.speed, 0.0f, 1e-3f);
	CHECK(rails.tank.is_at_rest());
}

TEST(a_pedal_drawn_back_brakes_first_and_then_drives_back) {
	OnRails rails;
	rails.run({ 1.0f, 0.0f, 0.0f, 0.0f, Selector::AUTOMATIC }, 6.0f);
	const float before = rails.speed;
	rails.run({ -1.0f, 0.0f, 0.0f, 0.0f, Selector::AUTOMATIC }, 0.5f);
	CHECK(rails.tank.gearbox.gear() > 0);
	CHECK(rails.speed < before - 1.0f);
	rails.run({ -1.0f, 0.0f, 0.0f, 0.0f, Selector::AUTOMATIC }, 10.0f);
	CHECK(rails.tank.gearbox.gear() < 0);
	CHECK(rails.speed < -2.0f);
}

TEST(the_selector_is_obeyed) {
	OnRails rails;
	rails.run({ 1.0f, 0.0f, 0.0f, 0.0f, Selector::NEUTRAL }, 5.0f);
	CHECK_NEAR(rails.speed, 0.0f, 1e-3f);
	rails.run({ 1.0f, 0.0f, 0.0f, 0.0f, Selector::REVERSE }, 5.0f);
	CHECK(rails.speed < -1.0f);
	rails.run({ 0.0f, 0.0f, 1.0f, 0.0f, Selector::REVERSE }, 5.0f);
	rails.run({ -1.0f, 0.0f, 0.0f, 0.0f, Selector::FORWARD }, 5.0f);
	CHECK_NEAR(rails.speed, 0.0f, 1e-3f);
}

TEST(it_climbs_what_first_gear_can_without_hunting) {
	OnRails rails;
	rails.slope_force = 280e3f; // 60 %.
	rails.run({ 1.0f, 0.0f, 0.0f, 0.0f, Selector::AUTOMATIC }, 15.0f);
	CHECK(rails.speed > 1.0f);
	int shifts = 0;
	for (int i = 0; i < 20; i++) {
		const int gear = rails.tank.gearbox.gear();
		rails.run({ 1.0f, 0.0f, 0.0f, 0.0f, Selector::AUTOMATIC }, 0.5f);
		shifts += rails.tank.gearbox.gear() != gear ? 1 : 0;
	}
	CHECK(shifts <= 1);
}

TEST(an_engine_that_is_off_drives_nothing) {
	OnRails rails;
	rails.tank.engine.set_running(false);
	rails.run({ 1.0f, 0.0f, 0.0f, 0.0f, Selector::AUTOMATIC }, 5.0f);
	CHECK_NEAR(rails.speed, 0.0f, 1e-2f);
}

TEST(what_is_not_a_number_counts_as_nothing) {
	const float nan = std::numeric_limits<float>::quiet_NaN();
	const float inf = std::numeric_limits<float>::infinity();
	OnRails rails;
	rails.run({ nan, inf, nan, -inf, Selector::AUTOMATIC }, 2.0f);
	CHECK_NEAR(rails.speed, 0.0f, 1e-3f);
	rails.run({ 1.0f, nan, 0.0f, 0.0f, Selector::AUTOMATIC }, 5.0f);
	CHECK(rails.speed > 1.0f);
	CHECK(std::isfinite(rails.tank.forces().left));
	rails.run({ 1e9f, 0.0f, 0.0f, 0.0f, Selector::AUTOMATIC }, 30.0f);
	CHECK(rails.speed < 25.0f);
}

TEST(steering_on_the_spot_does_not_stall_the_engine) {
	Drivetrain tank = make_tank();
	tank.tracks.settings = { 2.78f, 0.97f, 3.5f, 260e3f, 0.25f };
	float left = 0.0f;
	float right = 0.0f;
	for (int i = 0; i < 600; i++) {
		const SideForces &forces =
				tank.step({ 0.0f, 1.0f, 0.0f, 0.0f, Selector::AUTOMATIC }, { 0.0f, left, right, 0.0f, 0.0f }, STEP);
		// Each track has 25 t to move and 140 kN of friction against it.
		right += std::max(-0.5f, (forces.right - 140e3f) * STEP / 25e3f);
		right = std::max(0.0f, right);
		left = -right;
	}
	CHECK(tank.engine.rpm() > tank.engine.settings.idle_rpm);
	CHECK_NEAR(right - left, 2.0f * 0.97f, 0.1f);
}

} // namespace test_drivetrain
