// SPDX-License-Identifier: MIT
#include "fixtures.hpp"

#include <check.hpp>
#include <turret.hpp>

#include <cmath>
#include <limits>

namespace test_turret {

using namespace vehicle;
using kinematics::Quat;
using kinematics::Vec3;

namespace {

Vec3 gun_in_world(const TurretDrive &p_drive, const Quat &p_hull) {
	const float level = std::cos(p_drive.pitch());
	return p_hull.rotate(
			{ -level * std::sin(p_drive.yaw()), std::sin(p_drive.pitch()), -level * std::cos(p_drive.yaw()) });
}

} // namespace

TEST(a_turret_turns_no_faster_than_it_can) {
	for (const bool is_stabilised : { true, false }) {
		TurretDrive drive;
		drive.set_stabilised(is_stabilised);
		float last = 0.0f;
		float last_speed = 0.0f;
		for (int i = 0; i < 300; i++) {
			drive.step({}, {}, i < 200 ? 5.0f : 0.0f, 0.0f, STEP);
			const float speed = std::remainder(drive.yaw() - last, 6.2831853f) / STEP;
			CHECK(std::abs(speed) <= 0.7f + 1e-3f);
			CHECK(std::abs(speed - last_speed) <= 2.0f * STEP + 2e-3f);
			last = drive.yaw();
			last_speed = speed;
		}
		CHECK_NEAR(last_speed, 0.0f, 1e-3f);
		// 200 steps at 0.7 rad/s, less and more what it takes to start and to stop.
		CHECK_NEAR(std::remainder(drive.yaw() - 200.0f * STEP * 0.7f, 6.2831853f), 0.0f, 0.02f);
	}
}

TEST(a_gun_stays_within_its_limits_and_comes_back_at_once) {
	for (const bool is_stabilised : { true, false }) {
		TurretDrive drive;
		drive.set_stabilised(is_stabilised);
		for (int i = 0; i < 300; i++) {
			drive.step({}, {}, 0.0f, 1.0f, STEP);
		}
		CHECK_NEAR(drive.pitch(), drive.settings.pitch_max, 1e-3f);
		for (int i = 0; i < 30; i++) {
			drive.step({}, {}, 0.0f, -1.0f, STEP);
		}
		CHECK(drive.pitch() < drive.settings.pitch_max - 0.15f);
		for (int i = 0; i < 300; i++) {
			drive.step({}, {}, 0.0f, -1.0f, STEP);
		}
		CHECK_NEAR(drive.pitch(), drive.settings.pitch_min, 1e-3f);
	}
}

TEST(a_stabilised_gun_holds_its_aim_while_the_hull_pitches_and_turns) {
	TurretDrive drive;
	drive.place(0.8f, 0.05f);
	Quat hull;
	drive.step(hull, {}, 0.0f, 0.0f, STEP);
	const Vec3 aim = drive.aim();
	double squares = 0.0;
	constexpr int STEPS = 600;
	for (int i = 0; i < STEPS; i++) {
		const float time = float(i) * STEP;
		// 4 degrees at 1 Hz, and a slow turn: as a hull moves over bumps.
		const Vec3 rate{ 0.07f * 6.28f * std::cos(6.28f * time), 0.2f, 0.03f * 9.0f * std::cos(9.0f * time) };
		drive.step(hull, rate, 0.0f, 0.0f, STEP);
		hull = (kinematics::exp(rate * STEP) * hull).normalized();
		const Vec3 gun = gun_in_world(drive, hull);
		// The hull starts with a jerk, which takes the drives some steps.
		squares += i < 60 ? 0.0 : double((gun - aim).dot(gun - aim));
	}
	CHECK(std::sqrt(squares / (STEPS - 60)) < 1e-3);
	// Without it the gun goes where the hull goes.
	drive.set_stabilised(false);
	const float yaw = drive.yaw();
	drive.step(hull, { 0.5f, 0.5f, 0.0f }, 0.0f, 0.0f, STEP);
	CHECK_NEAR(drive.yaw(), yaw, 1e-4f);
}

TEST(a_turret_with_stops_does_not_pass_them) {
	TurretDrive drive;
	drive.settings.yaw_limit = 0.5f;
	for (int i = 0; i < 300; i++) {
		drive.step({}, { 0.0f, 1.0f, 0.0f }, 1.0f, 0.0f, STEP);
		CHECK(std::abs(drive.yaw()) <= 0.5f + 1e-5f);
	}
}

TEST(what_is_not_finite_moves_nothing) {
	const float nan = std::numeric_limits<float>::quiet_NaN();
	TurretDrive drive;
	drive.step({}, { nan, 0.0f, 0.0f }, 1.0f, 1.0f, STEP);
	drive.step({ nan, 0.0f, 0.0f, 1.0f }, {}, 1.0f, 1.0f, STEP);
	drive.step({}, {}, nan, nan, STEP);
	drive.step({}, {}, 1.0f, 1.0f, nan);
	CHECK_NEAR(drive.yaw(), 0.0f, 1e-6f);
	CHECK_NEAR(drive.pitch(), 0.0f, 1e-6f);
}

} // namespace test_turret
