// SPDX-License-Identifier: MIT
#include "../src/pose_stream.hpp"

#include "../../testing/check.hpp"

#include <limits>

using namespace ragdoll;

namespace {

/// A sample of one limb that is turned about Y by an angle (rad).
bool push(PoseStream &p_stream, double p_time, float p_angle, float p_x = 0.0f) {
	const Quat turn = exp({ 0.0f, p_angle, 0.0f });
	const float values[4] = { turn.x, turn.y, turn.z, turn.w };
	return p_stream.push(p_time, values, { p_x, 0.0f, 0.0f });
}

float angle_at(const PoseStream &p_stream, double p_time) {
	Pose pose;
	p_stream.predict(p_time, pose);
	return log(pose.orientations[0]).y;
}

} // namespace

TEST(interpolates_between_and_extrapolates_beyond) {
	PoseStream stream(1);
	for (int i = 0; i < 10; i++) {
		CHECK(push(stream, i * 0.02, 0.1f * float(i), float(i)));
	}
	CHECK_NEAR(angle_at(stream, 0.05), 0.25, 1e-5);
	CHECK_NEAR(angle_at(stream, 0.18), 0.9, 1e-5);
	CHECK_NEAR(angle_at(stream, 0.20), 1.0, 1e-5);
	Pose pose;
	stream.predict(0.2, pose);
	CHECK_NEAR(pose.root.x, 10.0, 1e-4);
}

TEST(holds_the_last_pose_when_the_stream_stalls) {
	PoseStream stream(1);
	push(stream, 0.0, 0.0f);
	push(stream, 0.02, 0.1f);
	CHECK(!stream.is_stalled(0.1));
	CHECK(stream.is_stalled(0.13));
	CHECK_NEAR(angle_at(stream, 0.13), 0.1, 1e-6);
	CHECK_NEAR(angle_at(stream, 100.0), 0.1, 1e-6);
}

TEST(a_gap_gives_no_velocity) {
	PoseStream stream(1);
	push(stream, 0.0, 0.0f);
	push(stream, 5.0, 2.0f);
	CHECK_NEAR(angle_at(stream, 5.02), 2.0, 1e-6);
}

TEST(refuses_what_is_no_pose) {
	PoseStream stream(1);
	const float nan = std::numeric_limits<float>::quiet_NaN();
	const float infinite = std::numeric_limits<float>::infinity();
	const float bad[4][4] = { { nan, 0, 0, 1 }, { 0, 0, 0, 0 }, { infinite, 0, 0, 0 }, { 2, 0, 0, 2 } };
	for (const auto &values : bad) {
		CHECK(!stream.push(0.0, values, {}));
	}
	const float fine[4] = { 0, 0, 0, 1 };
	CHECK(!stream.push(double(nan), fine, {}));
	CHECK(!stream.push(0.0, fine, { nan, 0, 0 }));
	CHECK(stream.is_empty());
	CHECK(stream.push(1.0, fine, {}));
	CHECK(!stream.push(1.0, fine, {})); // Not newer.
	CHECK(!stream.push(0.5, fine, {}));
	CHECK(stream.push(1.1, fine, {}));
}

TEST(normalises_and_is_indifferent_to_the_sign) {
	PoseStream stream(1);
	const float almost[4] = { 0, 0, 0, 1.05f };
	const float opposite[4] = { 0, 0, 0, -1 };
	stream.push(0.0, almost, {});
	stream.push(0.02, opposite, {});
	Pose pose;
	stream.predict(0.03, pose);
	CHECK_NEAR(angle_between(pose.orientations[0], Quat()), 0.0, 1e-5);
	CHECK_NEAR(pose.orientations[0].dot(pose.orientations[0]), 1.0, 1e-5);
}

TEST(keeps_a_bounded_history) {
	PoseStream stream(1);
	for (int i = 0; i < 1000; i++) {
		push(stream, i * 0.01, 0.0f);
	}
	CHECK_NEAR(stream.newest(), 9.99, 1e-9);
	CHECK_NEAR(stream.newest() - stream.oldest(), 0.31, 1e-9);
	CHECK_NEAR(angle_at(stream, -100.0), 0.0, 1e-6); // Older than all: the oldest known.
}

TEST_MAIN()
