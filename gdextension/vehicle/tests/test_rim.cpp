// SPDX-License-Identifier: MIT
#include "fixtures.hpp"

#include <rim.hpp>
#include <track.hpp>

#include <check.hpp>

#include <cmath>

namespace test_rim {

using namespace vehicle;

namespace {

/// A mass on one wheel that pulls it along a line.
struct Slider {
	float mass = 1000.0f;
	float speed = 0.0f;
	float across = 0.0f;
	float way = 0.0f;
	Rim rim{ 50.0f, 0.0f };
	std::vector<Patch> patches{ 1 };

	void run(float p_drive, float p_brake, float p_pull, float p_pull_across, float p_seconds) {
		for (int i = 0; i < int(p_seconds / STEP); i++) {
			Patch &patch = patches[0];
			patch.load = mass * 9.81f;
			patch.stiffness = 0.3e6f;
			patch.damping = 1e4f;
			patch.speed_along = speed;
			patch.speed_across = across;
			rim.step(p_drive, p_brake, patches, 0, 1, STEP);
			speed += (patch.force_along + p_pull) * STEP / mass;
			across += (patch.force_across + p_pull_across) * STEP / mass;
			way += speed * STEP;
		}
	}
};

} // namespace

TEST(a_driven_wheel_gives_its_force_to_the_ground) {
	Slider slider;
	slider.run(2000.0f, 0.0f, 0.0f, 0.0f, 2.0f);
	// The wheel's own mass takes its part.
	CHECK_NEAR(slider.speed, 2000.0f * 2.0f / 1050.0f, 0.1f);
	CHECK_NEAR(slider.rim.speed, slider.speed, 0.05f);
	CHECK(!slider.patches[0].slides);
}

TEST(friction_limits_what_can_be_driven) {
	Slider slider;
	slider.patches[0].grip_along = slider.patches[0].grip_across = 0.5f;
	slider.run(20000.0f, 0.0f, 0.0f, 0.0f, 1.0f);
	CHECK_NEAR(slider.speed, 0.5f * 9.81f, 0.2f);
	CHECK(slider.rim.speed > 3.0f * slider.speed);
	CHECK(slider.patches[0].slides);
}

TEST(a_braked_wheel_holds_on_a_slope_without_creeping) {
	Slider slider;
	slider.run(0.0f, 8000.0f, 5000.0f, 2000.0f, 5.0f);
	const float before = slider.way;
	slider.run(0.0f, 8000.0f, 5000.0f, 2000.0f, 60.0f);
	CHECK_NEAR(slider.way, before, 1e-3f);
	CHECK_NEAR(slider.across, 0.0f, 1e-3f);
	CHECK_NEAR(slider.rim.speed, 0.0f, 1e-6f);
}

TEST(a_brake_stops_and_does_not_drive_back) {
	Slider slider;
	slider.speed = slider.rim.speed = 10.0f;
	slider.run(0.0f, 5000.0f, 0.0f, 0.0f, 10.0f);
	CHECK_NEAR(slider.speed, 0.0f, 1e-3f);
	CHECK(slider.way > 8.0f);
	CHECK(slider.way < 12.0f);
}

TEST(a_wheel_in_the_air_spins_freely) {
	Rim rim{ 50.0f, 0.0f };
	std::vector<Patch> patches(1);
	for (int i = 0; i < 60; i++) {
		rim.step(100.0f, 0.0f, patches, 0, 1, STEP);
	}
	CHECK_NEAR(rim.speed, 2.0f, 0.01f);
	CHECK_NEAR(patches[0].force_along, 0.0f, 1e-6f);
}

TEST(a_track_is_shared_out_by_load) {
	std::vector<SphereMotor> spheres{ { 1000.0f, 2.0f, 0.0f }, { 3000.0f, 2.0f, 0.0f }, { 0.0f, 2.0f, 0.0f } };
	share_track(spheres, 0, 3, 8000.0f, 0.0f, 400.0f, STEP);
	CHECK_NEAR(spheres[1].force / spheres[0].force, 3.0, 0.3);
	CHECK(spheres[2].force < 0.08f * 8000.0f);
	CHECK_NEAR(spheres[0].force + spheres[1].force + spheres[2].force, 8000.0f, 1.0f);
	CHECK(spheres[0].target > 2.0f);
}

TEST(a_sphere_at_a_wall_gets_its_part) {
	std::vector<SphereMotor> spheres{ { 4000.0f, 0.0f, 0.0f }, { 0.0f, 0.0f, 1.0f } };
	share_track(spheres, 0, 2, 8000.0f, 0.0f, 400.0f, STEP);
	CHECK(spheres[1].force > 0.3f * 8000.0f);
}

TEST(brakes_of_a_track_hold_it_and_yield_to_more_drive) {
	std::vector<SphereMotor> spheres{ { 1000.0f, 0.0f, 0.0f } };
	share_track(spheres, 0, 1, 4000.0f, 5000.0f, 400.0f, STEP);
	CHECK_NEAR(spheres[0].target, 0.0f, 1e-6f);
	CHECK_NEAR(spheres[0].force, 5000.0f, 1.0f);
	share_track(spheres, 0, 1, 8000.0f, 5000.0f, 400.0f, STEP);
	CHECK(spheres[0].target > 0.1f);
	CHECK_NEAR(spheres[0].force, 3000.0f, 1.0f);
}

TEST(a_sphere_in_the_air_does_not_count_for_the_speed_of_its_track) {
	const std::vector<SphereMotor> spheres{ { 1000.0f, 2.0f, 0.0f }, { 0.0f, 9.0f, 0.0f } };
	CHECK_NEAR(track_speed(spheres, 0, 2), 2.0f, 1e-3f);
}

} // namespace test_rim
