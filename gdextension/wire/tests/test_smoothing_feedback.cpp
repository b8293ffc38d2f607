// SPDX-License-Identifier: MIT
#include "smoothing_fixtures.hpp"

#include <smoothing/local_feedback.hpp>

#include <check.hpp>

#include <deque>
#include <functional>
#include <limits>

namespace test_smoothing_feedback {

using namespace fixtures;

namespace {

constexpr float DEGREE = 0.0174533f;

struct Truth {
	double arrival;
	double moment;
	PersonPose pose;
};

/// The wearer's arm at an angle about the vertical.
PersonPose armed(float p_angle) {
	PersonPose pose;
	pose.root = { 0.0f, 1.0f, 0.0f };
	pose.orientations[1] = kinematics::exp({ 0.0f, p_angle, 0.0f });
	pose.orientations[2] = pose.orientations[1];
	return pose;
}

/// What the wearer sees, frame by frame at 60 Hz: the angle of the arm. The server answers within 50 ms,
/// give or take.
std::vector<float> see(
		double p_seconds, const std::function<float(double)> &p_local, const std::function<float(double)> &p_server) {
	LocalFeedback feedback;
	feedback.set_skeleton(arm());
	std::mt19937 random(5);
	std::deque<Truth> in_flight;
	std::vector<float> seen;
	for (int frame = 0; double(frame) / 60.0 < p_seconds; frame++) {
		const double now = double(frame) / 60.0;
		feedback.push_local(now, armed(p_local(now)));
		in_flight.push_back({ now + 0.04 + 0.02 * double(random() % 100) / 100.0, now, armed(p_server(now)) });
		while (!in_flight.empty() && in_flight.front().arrival <= now) {
			feedback.push_truth(in_flight.front().moment, in_flight.front().pose);
			in_flight.pop_front();
		}
		feedback.evaluate(now, now);
		seen.push_back(kinematics::log(feedback.get_pose().orientations[1]).y);
	}
	return seen;
}

double jerk(const std::vector<float> &p_angles) {
	double sum = 0.0;
	for (std::size_t i = 30; i + 3 < p_angles.size(); i++) {
		const double third = p_angles[i + 3] - 3.0 * p_angles[i + 2] + 3.0 * p_angles[i + 1] - p_angles[i];
		sum += third * third;
	}
	return std::sqrt(sum);
}

float waving(double p_time) {
	return float(1.0 * std::sin(6.0 * p_time) + 0.2 * std::sin(17.0 * p_time));
}

} // namespace

TEST(a_wearer_whose_frame_is_turned_is_seen_as_the_server_has_him) {
	LocalFeedback feedback;
	feedback.set_skeleton(arm());
	const kinematics::Quat turn = kinematics::exp({ 0.0f, 2.0f, 0.0f });
	for (const float heading : { 0.0f, 2.0f }) {
		feedback.set_heading(heading);
		CHECK(!feedback.evaluate(0.0, 0.0)); // What was pushed before is forgotten.
		for (int frame = 0; frame < 60; frame++) {
			const double now = double(frame) / 60.0;
			const PersonPose local = armed(0.3f);
			PersonPose truth = local;
			for (kinematics::Quat &limb : truth.orientations) {
				limb = turn * limb;
			}
			CHECK(feedback.push_local(now, local));
			feedback.push_truth(now, truth);
			CHECK(feedback.evaluate(now, now));
		}
		// By another frame than the server's the whole body is off.
		CHECK((feedback.deviation(0) < 0.01f) == (heading == 2.0f));
	}
	const kinematics::Quat shown = feedback.get_pose().orientations[1];
	CHECK(std::abs(shown.dot(turn * armed(0.3f).orientations[1])) > 0.9999f);
}

TEST(the_own_body_is_shown_at_once) {
	const std::vector<float> seen = see(3.0, waving, waving);
	float worst = 0.0f;
	for (std::size_t i = 0; i < seen.size(); i++) {
		worst = std::max(worst, std::fabs(seen[i] - waving(double(i) / 60.0)));
	}
	CHECK(worst < 0.1f * DEGREE);
}

TEST(a_wall_stops_the_arm) {
	// The arm swings to 60 degrees and stays; a wall at 30 degrees holds the server's.
	const auto local = [](double p_time) { return 60.0f * DEGREE * float(std::min(p_time / 0.5, 1.0)); };
	const auto server = [&local](double p_time) { return std::min(local(p_time), 30.0f * DEGREE); };
	const std::vector<float> seen = see(1.5, local, server);
	// 0.2 s after the arm has come to rest it is seen at the wall.
	for (std::size_t i = 42; i < seen.size(); i++) {
		CHECK_NEAR(seen[i], 30.0 * double(DEGREE), 1.5 * double(DEGREE));
	}
	CHECK_NEAR(seen.back(), 30.0 * double(DEGREE), 0.05 * double(DEGREE));
}

TEST(a_wall_that_is_left_lets_go) {
	const auto local = [](double p_time) { return p_time < 1.0 ? 60.0f * DEGREE : 10.0f * DEGREE; };
	const auto server = [&local](double p_time) { return std::min(local(p_time), 30.0f * DEGREE); };
	const std::vector<float> seen = see(2.0, local, server);
	for (std::size_t i = 60 + 15; i < seen.size(); i++) {
		CHECK_NEAR(seen[i], 10.0 * double(DEGREE), 1.0 * double(DEGREE));
	}
}

TEST(free_motion_does_not_jitter) {
	// The server's body follows 8 ms late and trembles by up to a degree.
	std::mt19937 random(9);
	const auto server = [&random](double p_time) {
		return waving(p_time - 0.008) + DEGREE * (float(random() % 200) / 100.0f - 1.0f);
	};
	const std::vector<float> seen = see(10.0, waving, server);
	std::vector<float> local;
	local.reserve(seen.size());
	for (std::size_t i = 0; i < seen.size(); i++) {
		local.push_back(waving(double(i) / 60.0));
	}
	CHECK(jerk(seen) <= 1.1 * jerk(local));
}

TEST(the_root_goes_where_the_server_has_it) {
	LocalFeedback feedback;
	feedback.set_skeleton(arm());
	for (int frame = 0; frame < 120; frame++) {
		const double now = double(frame) / 60.0;
		PersonPose pose = armed(0.0f);
		pose.root.x = float(now);
		feedback.push_local(now, pose);
		// The server's world has another origin; then a wall stops the walk.
		pose.root.x = std::min(float(now), 1.0f);
		pose.root.z = 4.5f;
		feedback.push_truth(now, pose);
		CHECK(feedback.evaluate(now, now));
		CHECK_NEAR(feedback.get_pose().root.z, 4.5, 1e-4);
		CHECK(feedback.get_pose().root.x < 1.06f);
	}
}

TEST(without_word_from_the_server_the_wearer_is_shown) {
	LocalFeedback feedback;
	feedback.set_skeleton(arm());
	for (int frame = 0; frame < 180; frame++) {
		const double now = double(frame) / 60.0;
		feedback.push_local(now, armed(1.0f));
		if (now < 1.0) {
			feedback.push_truth(now, armed(0.5f));
		}
		feedback.evaluate(now, now);
		if (frame == 59) {
			CHECK_NEAR(feedback.deviation(1), 0.5, 0.01);
		}
	}
	CHECK_NEAR(feedback.deviation(1), 0.0, 1e-3);
}

TEST(a_body_that_is_turned_around_does_not_flip) {
	LocalFeedback feedback;
	feedback.set_skeleton(arm());
	float roughest = 0.0f;
	float before = 0.0f;
	for (int frame = 0; frame < 240; frame++) {
		const double now = double(frame) / 60.0;
		feedback.push_local(now, armed(0.0f));
		// It turns by more than half a circle and back again.
		feedback.push_truth(now, armed(3.6f * std::sin(1.5f * float(now))));
		feedback.evaluate(now, now);
		const Quat turn = feedback.get_pose().orientations[1];
		const float angle = 2.0f * std::atan2(turn.y, turn.w);
		const float step = std::fabs(std::remainder(angle - before, 6.2831853f));
		roughest = frame > 10 ? std::max(roughest, step) : 0.0f;
		before = angle;
	}
	CHECK(roughest < 0.15f);
}

TEST(what_is_broken_is_refused) {
	LocalFeedback feedback;
	CHECK(!feedback.push_local(0.0, armed(0.0f)));
	CHECK(!feedback.evaluate(0.0, 0.0));
	kinematics::Skeleton wrong = arm();
	wrong.limb_count = 0;
	CHECK(!feedback.set_skeleton(wrong));
	CHECK(feedback.set_skeleton(arm()));
	CHECK(!feedback.push_truth(0.0, armed(0.0f)));
	PersonPose broken = armed(0.0f);
	broken.orientations[2] = { 0.0f, 0.0f, 0.0f, 0.0f };
	CHECK(!feedback.push_local(0.0, broken));
	broken = armed(0.0f);
	broken.root.y = std::numeric_limits<float>::quiet_NaN();
	CHECK(!feedback.push_local(0.0, broken));
	CHECK(!feedback.push_local(std::numeric_limits<double>::infinity(), armed(0.0f)));
	CHECK(feedback.push_local(10.0, armed(0.0f)));
	CHECK(!feedback.push_local(10.0, armed(0.0f)));
	CHECK(!feedback.push_truth(9.0, armed(0.0f)));
	CHECK(!feedback.push_truth(10.0, broken));
	CHECK(feedback.push_truth(10.0, armed(0.1f)));
	CHECK(!feedback.push_truth(10.0, armed(0.1f)));
	CHECK(!feedback.evaluate(std::numeric_limits<double>::quiet_NaN(), 10.0));
	CHECK(feedback.evaluate(-5.0, 1e300));
	CHECK(feedback.get_positions()[2].is_finite());
}

} // namespace test_smoothing_feedback
