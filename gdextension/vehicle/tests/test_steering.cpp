// SPDX-License-Identifier: MIT
#include "fixtures.hpp"

#include <check.hpp>

#include <cmath>

namespace test_steering {

using namespace vehicle;

TEST(wheels_of_an_axle_meet_in_one_point) {
	WheelSteering steering;
	steering.settings = { 0.6f, 10.0f, 1000.0f, 3.0f };
	for (int i = 0; i < 60; i++) {
		steering.step(1.0f, 0.0f, STEP);
	}
	CHECK_NEAR(steering.angle(), 0.6f, 1e-4f);
	// To the left: the left wheel is the inner one and turns more.
	const float left = steering.angle_at(3.0f, -0.8f);
	const float right = steering.angle_at(3.0f, 0.8f);
	CHECK(left > right);
	const float centre = 3.0f / std::tan(0.6f);
	CHECK_NEAR(3.0f / std::tan(left) + 0.8f, centre, 1e-3f);
	CHECK_NEAR(3.0f / std::tan(right) - 0.8f, centre, 1e-3f);
	// An axle behind the unsteered one turns the other way.
	CHECK(steering.angle_at(-1.0f, 0.0f) < 0.0f);
}

TEST(a_fast_vehicle_is_not_thrown_round) {
	WheelSteering steering;
	steering.settings = { 0.6f, 10.0f, 5.0f, 3.0f };
	for (int i = 0; i < 60; i++) {
		steering.step(1.0f, 20.0f, STEP);
	}
	const float sideways = 20.0f * 20.0f * std::tan(steering.angle()) / 3.0f;
	CHECK_NEAR(sideways, 5.0f, 0.05f);
}

TEST(tracks_are_brought_to_the_difference_that_is_wanted) {
	TrackSteering steering;
	steering.settings = { 2.8f, 1.0f, 3.5f, 260e3f, 0.25f };
	float left = 0.0f;
	float right = 0.0f;
	for (int i = 0; i < 300; i++) {
		const float force = steering.step(1.0f, 0.0f, left, right, 0.0f, 55e3f, 1e6f, STEP);
		right += force * STEP / 25e3f;
		left -= force * STEP / 25e3f;
	}
	CHECK_NEAR(right, 1.0f, 0.02f);
	CHECK_NEAR(left, -1.0f, 0.02f);
}

TEST(the_power_of_the_engine_limits_steering) {
	TrackSteering steering;
	steering.settings = { 2.8f, 1.0f, 3.5f, 260e3f, 0.25f };
	float force = 0.0f;
	for (int i = 0; i < 300; i++) {
		force = steering.step(1.0f, 0.0f, -0.5f, 0.5f, 0.0f, 55e3f, 50e3f, STEP);
	}
	CHECK_NEAR(force, 50e3f, 1.0f);
}

TEST(a_turn_that_nobody_wants_is_steered_against) {
	TrackSteering steering;
	steering.settings = { 2.8f, 1.0f, 3.5f, 260e3f, 0.25f };
	for (int i = 0; i < 60; i++) {
		steering.step(0.0f, 10.0f, 10.0f, 10.0f, 0.05f, 55e3f, 1e6f, STEP);
	}
	CHECK(steering.difference() < -0.1f);
}

} // namespace test_steering
