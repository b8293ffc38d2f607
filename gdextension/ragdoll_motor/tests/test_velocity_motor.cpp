// SPDX-License-Identifier: MIT
#include "../src/tracking_meter.hpp"
#include "../src/velocity_motor.hpp"

#include "../../testing/check.hpp"

#include <random>

using namespace ragdoll;

namespace {

const std::vector<int> CHAIN = { -1, 0, 1, 1 };

Pose random_pose(std::mt19937 &p_random) {
	std::normal_distribution<float> normal(0.0f, 0.7f);
	Pose pose;
	for (std::size_t i = 0; i < CHAIN.size(); i++) {
		pose.orientations.push_back(exp({ normal(p_random), normal(p_random), normal(p_random) }));
	}
	return pose;
}

/// What an ideal joint would do with the velocities in one step.
std::vector<Quat> step(const std::vector<Quat> &p_actual, const std::vector<Vec3> &p_velocities, float p_delta) {
	std::vector<Quat> moved(p_actual.size());
	for (std::size_t i = 0; i < p_actual.size(); i++) {
		const Quat relative = CHAIN[i] < 0 ? p_actual[i] : p_actual[CHAIN[i]].inverse() * p_actual[i];
		const Quat turned = relative * exp(p_velocities[i] * p_delta);
		moved[i] = CHAIN[i] < 0 ? turned : moved[CHAIN[i]] * turned;
	}
	return moved;
}

} // namespace

TEST(feed_forward_alone_follows_exactly) {
	std::mt19937 random(3);
	const VelocityMotor motor(CHAIN);
	std::vector<Vec3> velocities;
	for (int i = 0; i < 200; i++) {
		const Pose now = random_pose(random);
		Pose next = now;
		for (Quat &orientation : next.orientations) {
			orientation = orientation * exp({ 0.05f, -0.02f, 0.03f });
		}
		motor.compute(now.orientations, now, next, 1.0f / 60.0f, 30.0f, velocities);
		const std::vector<Quat> moved = step(now.orientations, velocities, 1.0f / 60.0f);
		for (std::size_t limb = 0; limb < CHAIN.size(); limb++) {
			CHECK_NEAR(angle_between(moved[limb], next.orientations[limb]), 0.0, 1e-3);
		}
	}
}

TEST(errors_decay_with_the_gain) {
	std::mt19937 random(4);
	const VelocityMotor motor(CHAIN);
	std::vector<Vec3> velocities;
	const Pose target = random_pose(random);
	std::vector<Quat> actual(CHAIN.size());
	for (int i = 0; i < 60; i++) {
		motor.compute(actual, target, target, 1.0f / 60.0f, 30.0f, velocities);
		actual = step(actual, velocities, 1.0f / 60.0f);
	}
	for (std::size_t limb = 0; limb < CHAIN.size(); limb++) {
		CHECK_NEAR(angle_between(actual[limb], target.orientations[limb]), 0.0, 1e-3);
	}
}

TEST(the_gain_never_overshoots_a_step) {
	const VelocityMotor motor({ -1 });
	Pose target;
	target.orientations = { exp({ 1.0f, 0.0f, 0.0f }) };
	std::vector<Vec3> velocities;
	motor.compute({ Quat() }, target, target, 0.1f, 1e9f, velocities);
	CHECK_NEAR(velocities[0].x, 10.0, 1e-3);
	CHECK_NEAR(root_velocity({}, { 1, 0, 0 }, { 2, 0, 0 }, 0.5f, 100.0f).x, 4.0, 1e-5);
}

TEST(joint_positions_follow_the_anchors) {
	const VelocityMotor motor({ -1, 0, 1 });
	Pose pose;
	pose.root = { 0.0f, 1.0f, 0.0f };
	pose.orientations = { exp({ 0.0f, 0.0f, 3.14159265f / 2 }), Quat(), Quat() };
	std::vector<Vec3> positions;
	motor.joint_positions(pose, { {}, { 1.0f, 0.0f, 0.0f }, { 1.0f, 0.0f, 0.0f } }, positions);
	CHECK_NEAR(positions[1].y, 2.0, 1e-5);
	CHECK_NEAR(positions[2].x, 1.0, 1e-5);
}

TEST(the_meter_compares_with_the_later_truth) {
	PoseStream stream(1);
	TrackingMeter meter;
	const auto push = [&](double p_time, float p_angle) {
		const Quat turn = exp({ 0.0f, p_angle, 0.0f });
		const float values[4] = { turn.x, turn.y, turn.z, turn.w };
		stream.push(p_time, values, {});
		meter.settle(stream);
	};
	push(0.0, 0.0f);
	meter.note(0.01, { exp({ 0.0f, 0.15f, 0.0f }) });
	CHECK(meter.get_count() == 0); // Not known yet.
	push(0.02, 0.2f);
	CHECK(meter.get_count() == 1);
	CHECK_NEAR(meter.mean(), 0.05, 1e-4); // 0.15 against 0.1 half-way.
	CHECK_NEAR(meter.percentile(0.95), 0.05, 1.1e-3);
	CHECK_NEAR(meter.latest(), 0.05, 1e-4);
}

TEST(percentiles_of_a_known_spread) {
	PoseStream stream(1);
	TrackingMeter meter;
	const float still[4] = { 0, 0, 0, 1 };
	stream.push(0.0, still, {});
	for (int i = 1; i <= 100; i++) {
		meter.note(i * 0.001, { exp({ 0.01f * float(i), 0.0f, 0.0f }) });
		stream.push(i * 0.001, still, {});
		meter.settle(stream);
	}
	CHECK(meter.get_count() == 100);
	CHECK_NEAR(meter.percentile(0.95), 0.95, 0.011);
	CHECK_NEAR(meter.mean(), 0.505, 1e-3);
	meter.clear();
	CHECK(meter.get_count() == 0);
	CHECK_NEAR(meter.percentile(0.95), 0.0, 0.0);
}

TEST_MAIN()
