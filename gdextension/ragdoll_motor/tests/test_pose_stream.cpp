// SPDX-License-Identifier: MIT
#include "motion/pose_stream.hpp"

#include "check.hpp"

#include <limits>
#include <random>

namespace test_pose_stream {

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

TEST(interpolates_between_and_goes_on_beyond) {
	PoseStream stream(1);
	for (int i = 0; i < 10; i++) {
		CHECK(push(stream, i * 0.02, 0.1f * float(i), 0.1f * float(i)));
	}
	CHECK_NEAR(angle_at(stream, 0.05), 0.25, 1e-5);
	CHECK_NEAR(angle_at(stream, 0.18), 0.9, 1e-5);
	// 5 rad/s that fade: a little less than 0.1 further.
	const double ahead = 5.0 * PoseStream::RATE_FADE * (1.0 - std::exp(-0.02 / PoseStream::RATE_FADE));
	CHECK(ahead < 0.1 && ahead > 0.08);
	CHECK_NEAR(angle_at(stream, 0.20), 0.9 + ahead, 1e-4);
	Pose pose;
	stream.predict(0.2, pose);
	CHECK_NEAR(pose.root.x, 0.9 + ahead, 1e-4);
}

TEST(begins_anew_when_the_clock_was_set_back) {
	PoseStream stream(1);
	push(stream, 0.0, 0.0f);
	push(stream, 1e6, 1.0f); // One wrong time must not end the stream for good.
	int refused = 0;
	for (int i = 1; i < 100; i++) {
		refused += push(stream, i * 0.02, 0.01f * float(i)) ? 0 : 1;
	}
	CHECK(refused == PoseStream::CLOCK_SET_BACK - 1);
	CHECK_NEAR(stream.newest(), 99 * 0.02, 1e-9);
	CHECK_NEAR(angle_at(stream, 99 * 0.02), 0.99, 1e-5);
	// The same old sample over and over is none of that.
	for (int i = 0; i < 100; i++) {
		CHECK(!push(stream, 0.5, 2.0f));
	}
	CHECK_NEAR(angle_at(stream, 99 * 0.02), 0.99, 1e-5);
}

TEST(impossible_rates_of_a_gyroscope_are_estimated_instead) {
	PoseStream stream(1);
	for (int i = 0; i < 10; i++) {
		const Quat turn = exp({ 0.0f, 0.1f * float(i), 0.0f });
		const float values[4] = { turn.x, turn.y, turn.z, turn.w };
		const float rates[3] = { 3e38f, 3e38f, -3e38f };
		CHECK(stream.push(i * 0.02, values, {}, rates));
	}
	CHECK_NEAR(angle_at(stream, 0.2), 1.0, 0.02);
}

TEST(goes_back_to_the_last_pose_when_the_stream_stalls) {
	PoseStream stream(1);
	push(stream, 0.0, 0.0f);
	push(stream, 0.02, 0.1f);
	CHECK(!stream.is_stalled(0.1));
	CHECK(stream.is_stalled(0.13));
	CHECK(angle_at(stream, 0.12) > 0.2f);
	float before = angle_at(stream, 0.12);
	for (int step = 12; step < 33; step++) {
		const float angle = angle_at(stream, step * 0.01);
		CHECK(angle <= before + 1e-6f && before - angle < 0.05f); // No jump.
		before = angle;
	}
	CHECK_NEAR(angle_at(stream, 0.33), 0.1, 1e-6);
	CHECK_NEAR(angle_at(stream, 100.0), 0.1, 1e-6);
}

TEST(a_gyroscope_is_believed) {
	PoseStream stream(1);
	const float still[4] = { 0, 0, 0, 1 };
	const float rates[3] = { 0.0f, 2.0f, 0.0f };
	CHECK(stream.push(0.0, still, {}, rates));
	CHECK(stream.push(0.02, still, {}, rates));
	CHECK_NEAR(angle_at(stream, 0.03), 0.02, 2e-3);
	const float bad[3] = { std::numeric_limits<float>::infinity(), 0.0f, 0.0f };
	CHECK(!stream.push(0.04, still, {}, bad));
}

namespace {

/// How far the predictions of the next sample are off on average over the second half of a motion, by
/// the angle at each step of 1/60 s.
template <class Angle>
float mean_miss(Angle p_angle, bool p_with_gyroscope) {
	PoseStream stream(1);
	float sum = 0.0f;
	const int count = 240;
	for (int i = 0; i < count; i++) {
		const double time = i / 60.0;
		const Quat turn = exp({ 0.0f, p_angle(time), 0.0f });
		const float values[4] = { turn.x, turn.y, turn.z, turn.w };
		const float rates[3] = { 0.0f, (p_angle(time + 1e-3) - p_angle(time - 1e-3)) / 2e-3f, 0.0f };
		stream.push(time, values, {}, p_with_gyroscope ? rates : nullptr);
		sum += i < count / 2 ? 0.0f : std::abs(angle_at(stream, time + 1.0 / 60.0) - p_angle(time + 1.0 / 60.0));
	}
	const int half = count / 2;
	return sum / float(half);
}

float swing(double p_time) {
	return 0.8f * float(std::sin(2.0 * 3.14159265 * 1.5 * p_time));
}

} // namespace

TEST(smooth_motion_is_foreseen_by_its_acceleration) {
	// Without, the error is half a span's change of rate more: a dt^2, with a gyroscope a dt^2 / 2.
	const float acceleration = 0.8f * 9.42f * 9.42f * 2.0f / 3.14159f; // Its mean magnitude.
	const float plain = acceleration / 3600.0f;
	CHECK(mean_miss(swing, false) < 0.35f * plain);
	CHECK(mean_miss(swing, true) < 0.2f * plain);
}

TEST(what_turns_back_each_time_is_not_gone_on_with) {
	// White noise at rest: half of what the last difference says is noise of the sample before.
	std::mt19937 random(3);
	std::normal_distribution<float> noise(0.0f, 0.01f);
	PoseStream stream(1);
	float plain = 0.0f;
	float missed = 0.0f;
	float before = 0.0f;
	for (int i = 0; i < 600; i++) {
		const float angle = noise(random);
		push(stream, i / 60.0, angle);
		const float ahead = angle_at(stream, (i + 1) / 60.0);
		missed += i < 100 ? 0.0f : ahead * ahead;
		plain += i < 100 ? 0.0f : (2.0f * angle - before) * (2.0f * angle - before);
		before = angle;
	}
	CHECK(missed < 0.8f * plain);
}

TEST(a_sudden_change_is_not_taken_for_an_acceleration) {
	PoseStream stream(1);
	float angle = 0.0f;
	for (int i = 0; i < 120; i++) {
		angle = 0.3f * float(std::sin(i * 0.1));
		push(stream, i / 60.0, angle);
	}
	push(stream, 2.0, angle + 0.4f);
	// The turn of 0.4 goes on for the next step, but does not become 0.8.
	CHECK(angle_at(stream, 2.0 + 1.0 / 60.0) < angle + 0.4f + 0.45f);
}

TEST(a_glitch_is_no_speed) {
	PoseStream stream(1);
	for (int i = 0; i < 5; i++) {
		push(stream, i * 0.01, 0.0f);
	}
	push(stream, 0.05, 3.0f); // Half a turn in 10 ms: 300 rad/s.
	CHECK(angle_at(stream, 0.06) < 3.0f + 0.01f * PoseStream::FASTEST_TURN);
}

TEST(a_teleport_is_reported_once_and_is_no_speed) {
	PoseStream stream(1);
	push(stream, 0.0, 0.0f, 0.0f);
	push(stream, 0.02, 0.1f, 0.1f);
	CHECK(!stream.take_teleport());
	push(stream, 0.04, 0.2f, 30.0f);
	Pose pose;
	stream.predict(0.06, pose);
	CHECK_NEAR(pose.root.x, 30.0, 1e-6);
	stream.predict(0.03, pose); // Nothing lies between here and there.
	CHECK_NEAR(pose.root.x, 30.0, 1e-6);
	CHECK(stream.take_teleport());
	CHECK(!stream.take_teleport());
}

TEST(is_saved_and_restored_to_the_bit) {
	PoseStream stream(1);
	for (int i = 0; i < 50; i++) {
		push(stream, i * 0.02, 0.1f * float(i), 0.1f * float(i));
	}
	ArchiveWriter archive;
	stream.save(archive);
	PoseStream copy(1);
	ArchiveReader reader(archive.get_bytes().data(), archive.get_bytes().size());
	CHECK(copy.restore(reader) && reader.is_at_end());
	for (int step = 0; step < 85; step++) {
		const double time = 0.3 + 0.013 * step;
		CHECK(angle_at(copy, time) == angle_at(stream, time));
	}
	for (std::size_t size = 0; size < archive.get_bytes().size(); size += 7) {
		ArchiveReader cut(archive.get_bytes().data(), size);
		CHECK(!copy.restore(cut));
	}
	PoseStream other(2);
	ArchiveReader again(archive.get_bytes().data(), archive.get_bytes().size());
	CHECK(!other.restore(again));
}

TEST(a_gap_gives_no_velocity) {
	PoseStream stream(1);
	push(stream, 0.0, 0.0f);
	push(stream, 5.0, 2.0f);
	CHECK_NEAR(angle_at(stream, 5.02), 2.0, 1e-6);
}

TEST(a_pose_that_ends_a_pause_is_not_shown_before_its_time) {
	PoseStream stream(1);
	push(stream, 0.0, 0.0f);
	push(stream, 0.02, 0.0f);
	push(stream, 3.0, 1.0f);
	push(stream, 3.02, 1.0f);
	CHECK(!stream.is_stalled(0.1));
	CHECK(stream.is_stalled(1.0) && stream.is_stalled(2.995));
	CHECK_NEAR(angle_at(stream, 2.995), 0.0, 1e-6);
	// A clock that is a little behind shows what is there already.
	CHECK(!stream.is_stalled(3.0 - 1e-9) && !stream.is_stalled(3.01));
	CHECK_NEAR(angle_at(stream, 3.0 - 1e-9), 1.0, 1e-5);
}

TEST(the_first_samples_tell_velocity_and_acceleration_and_a_pause_forgets_no_habit) {
	PoseStream stream(1);
	const auto angle = [](double p_time_s) { return float(10.0 * (p_time_s - 0.9) * (p_time_s - 0.9)); };
	push(stream, 1.0, angle(1.0));
	CHECK(!stream.knows_rates());
	push(stream, 1.02, angle(1.02));
	CHECK(stream.knows_rates());
	push(stream, 1.04, angle(1.04));
	// Gone on with at the last rate it would be this far behind; a quarter of the change is believed at first.
	const double ahead = PoseStream::RATE_FADE * (1.0 - std::exp(-0.02 / PoseStream::RATE_FADE));
	const double behind = double(angle(1.06) - angle(1.04)) - double(angle(1.04) - angle(1.02)) / 0.02 * ahead;
	const float first = angle(1.06) - angle_at(stream, 1.06);
	CHECK(first > 0.0f && double(first) < behind - 0.001);
	for (int i = 3; i < 22; i++) {
		push(stream, 1.0 + 0.02 * i, angle(1.0 + 0.02 * i));
	}
	for (int i = 0; i < 3; i++) {
		push(stream, 5.0 + 0.02 * i, angle(1.0 + 0.02 * i));
	}
	CHECK(std::fabs(angle(1.06) - angle_at(stream, 5.06)) < first - 0.002f);
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

TEST(noise_is_taken_out_where_asked_for) {
	for (const bool calms : { false, true }) {
		PoseStream stream(1);
		stream.set_calms(calms);
		std::mt19937 random(5);
		std::normal_distribution<float> noise(0.0f, 0.02f);
		Pose pose;
		float off = 0.0f;
		for (int i = 0; i < 240; i++) {
			const Quat sampled = exp({ noise(random), noise(random), noise(random) });
			const float values[4] = { sampled.x, sampled.y, sampled.z, sampled.w };
			CHECK(stream.push(i / 60.0, values, {}));
			stream.predict(i / 60.0, pose);
			off += i < 120 ? 0.0f : angle_between(pose.orientations[0], Quat()) / 120.0f;
			stream.recall(i / 60.0, pose);
			CHECK_NEAR(angle_between(pose.orientations[0], sampled), 0.0, 1e-3);
		}
		CHECK(calms ? off < 0.015f : off > 0.025f);
		CHECK((stream.get_filter().get_noise() > 0.0f) == calms);
	}
}

} // namespace test_pose_stream
