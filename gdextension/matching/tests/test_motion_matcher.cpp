// SPDX-License-Identifier: MIT
#include "walker_fixture.hpp"

#include <motion_matcher.hpp>

#include <check.hpp>

#include <cmath>
#include <random>

using namespace matching;

namespace {

constexpr float DELTA = 1.0f / 60.0f;

/// A mover on level ground that gets to its wish with a limited acceleration.
struct Mover {
	Wish wish;

	void advance(float p_delta) {
		const Vec3 wanted = wish.wished_velocity - wish.velocity;
		wish.velocity = wish.velocity + wanted.limited(14.0f * p_delta);
		wish.position = wish.position + wish.velocity * p_delta;
		const float turn = wrapped(wish.wished_heading - wish.heading);
		wish.heading = wrapped(wish.heading + std::fmax(-0.1f, std::fmin(0.1f, turn)));
	}
	void want(float p_speed, float p_direction) {
		wish.wished_velocity = turn_of(wish.wished_heading + p_direction).rotate({ 0.0f, 0.0f, p_speed });
	}
};

MotionMatcher matcher() {
	MotionMatcher made;
	made.set_motion_set(walker_fixture::motion_set());
	made.set_body(Body::of(0.95f));
	made.reset({ 0.0f, 0.0f, 0.0f }, 0.0f);
	return made;
}

Vec3 ball(const MotionMatcher &p_matcher, std::size_t p_side) {
	return ankle_of(p_matcher.body(), p_matcher.pose(), p_side) +
			p_matcher.pose().limbs[foot_of(p_side)].rotate(p_matcher.body().ball());
}

bool is_same(const Pose &p_a, const Pose &p_b) {
	bool same = p_a.hips.x == p_b.hips.x && p_a.hips.y == p_b.hips.y && p_a.hips.z == p_b.hips.z;
	for (std::size_t i = 0; i < LIMBS; i++) {
		const Quat &a = p_a.limbs[i];
		const Quat &b = p_b.limbs[i];
		same = same && a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w;
	}
	return same;
}

bool is_pose(const Pose &p_pose) {
	bool is_sound = p_pose.hips.is_finite();
	for (const Quat &limb : p_pose.limbs) {
		is_sound = is_sound && limb.is_finite() && std::fabs(limb.dot(limb) - 1.0f) < 1e-3f;
	}
	return is_sound;
}

} // namespace

TEST(who_stands_stands_where_he_is_put) {
	MotionMatcher made = matcher();
	Mover mover;
	const Vec3 before = ball(made, 0);
	for (int i = 0; i < 120; i++) {
		made.advance(DELTA, mover.wish);
	}
	CHECK_NEAR((ball(made, 0) - before).length(), 0.0, 1e-3);
	CHECK_NEAR(ball(made, 0).y, 0.0, 1e-3);
	CHECK(made.is_planted(0) && made.is_planted(1));
	CHECK_NEAR(made.pose().hips.y, 0.95 * 0.97, 0.03);
}

TEST(planted_feet_stay_whatever_is_wished) {
	MotionMatcher made = matcher();
	Mover mover;
	std::mt19937 random(7);
	std::array<Vec3, 2> last{};
	std::array<bool, 2> was{};
	int planted = 0;
	int ticks = 0;
	for (int i = 0; i < 3000; i++) {
		if (random() % 80 == 0) {
			mover.wish.wished_heading = float(random() % 628) * 0.01f - PI;
			mover.want(float(random() % 4), float(random() % 8) * PI / 4.0f);
		}
		mover.advance(DELTA);
		made.advance(DELTA, mover.wish);
		CHECK(is_pose(made.pose()));
		const Vec3 apart = made.pose().hips - mover.wish.position;
		CHECK(std::hypot(apart.x, apart.z) < 0.1f);
		for (std::size_t side = 0; side < 2; side++) {
			const Vec3 now = ball(made, side);
			if (made.is_planted(side) && was[side]) {
				CHECK(std::hypot(now.x - last[side].x, now.z - last[side].z) < 0.03f);
				planted++;
			}
			ticks++;
			was[side] = made.is_planted(side);
			last[side] = now;
		}
	}
	CHECK(planted > ticks / 4);
}

TEST(the_same_wishes_give_the_same_bits_and_a_copy_goes_on_alike) {
	MotionMatcher first = matcher();
	MotionMatcher second = matcher();
	Mover mover;
	for (int i = 0; i < 300; i++) {
		if (i % 70 == 0) {
			mover.want(float(i % 3) * 1.2f, 0.3f * float(i % 5));
		}
		mover.advance(DELTA);
		if (i == 150) {
			second = first;
		}
		first.advance(DELTA, mover.wish);
		second.advance(DELTA, mover.wish);
		CHECK(is_same(first.pose(), second.pose()));
	}
}

TEST(a_start_is_seen_within_a_tenth_of_a_second) {
	MotionMatcher made = matcher();
	Mover mover;
	for (int i = 0; i < 60; i++) {
		made.advance(DELTA, mover.wish);
	}
	const Pose before = made.pose();
	mover.want(1.4f, 0.0f);
	float largest = 0.0f;
	for (int i = 0; i < 6; i++) {
		mover.advance(DELTA);
		made.advance(DELTA, mover.wish);
		for (std::size_t limb = 0; limb < LIMBS; limb++) {
			largest = std::max(largest, kinematics::angle_between(before.limbs[limb], made.pose().limbs[limb]));
		}
	}
	CHECK(largest > 0.15f);
}

TEST(nothing_jumps_when_the_motion_changes) {
	MotionMatcher made = matcher();
	Mover mover;
	std::mt19937 random(3);
	Pose last = made.pose();
	for (int i = 0; i < 1500; i++) {
		if (random() % 50 == 0) {
			mover.want(float(random() % 4), float(int(random() % 3) - 1) * PI / 4.0f);
		}
		mover.advance(DELTA);
		made.advance(DELTA, mover.wish);
		for (std::size_t limb = HIPS; limb < LEFT_UPPER_LEG; limb++) {
			CHECK(kinematics::angle_between(last.limbs[limb], made.pose().limbs[limb]) < 0.25f);
		}
		last = made.pose();
	}
}

TEST(another_set_is_taken_up_without_a_jump) {
	std::vector<Clip> clips = walker_fixture::clips();
	const Quat turn = exp({ 0.0f, 0.0f, 1.2f });
	for (Clip &clip : clips) {
		for (ClipFrame &frame : clip.frames) {
			// As the mirrored twin has it, too.
			frame.pose.limbs[LEFT_UPPER_ARM] = turn * frame.pose.limbs[LEFT_UPPER_ARM];
			frame.pose.limbs[RIGHT_UPPER_ARM] = turn.inverse() * frame.pose.limbs[RIGHT_UPPER_ARM];
		}
	}
	clips.erase(clips.begin() + 1);
	const auto other = std::make_shared<const MotionSet>(std::move(clips));
	for (const float speed : { 0.0f, 1.4f, 3.0f }) {
		MotionMatcher made = matcher();
		MotionMatcher stays = matcher();
		Mover mover;
		mover.want(speed, 0.0f);
		Pose last = made.pose();
		for (int i = 0; i < 200; i++) {
			mover.advance(DELTA);
			if (i == 100) {
				made.change_motion_set(walker_fixture::motion_set());
				// The last of two that come within a tick counts.
				made.change_motion_set(other);
				CHECK(made.clip_name() == std::string("stand"));
			}
			made.advance(DELTA, mover.wish);
			stays.advance(DELTA, mover.wish);
			CHECK(is_pose(made.pose()));
			if (i >= 90) {
				const Vec3 step = made.pose().hips - last.hips - mover.wish.velocity * DELTA;
				CHECK(step.length() < 0.02f);
				CHECK(kinematics::angle_between(last.limbs[LEFT_UPPER_ARM], made.pose().limbs[LEFT_UPPER_ARM]) < 0.25f);
			}
			last = made.pose();
		}
		CHECK(kinematics::angle_between(last.limbs[LEFT_UPPER_ARM], stays.pose().limbs[LEFT_UPPER_ARM]) > 0.9f);
	}
	MotionMatcher empty;
	empty.change_motion_set(other);
	empty.advance(DELTA, Wish());
	CHECK(is_pose(empty.pose()));
}

TEST(every_stance_is_a_pose_and_has_its_height) {
	const std::array<float, STANCES> least{ 0.8f, 0.45f, 0.05f, 0.7f, 0.6f };
	const std::array<float, STANCES> most{ 1.0f, 0.75f, 0.3f, 1.1f, 1.1f };
	for (int stance = 0; stance < STANCES; stance++) {
		MotionMatcher made = matcher();
		Mover mover;
		mover.wish.stance = Stance(stance);
		for (int i = 0; i < 90; i++) {
			made.advance(DELTA, mover.wish);
			CHECK(is_pose(made.pose()));
		}
		CHECK(made.pose().hips.y > least[std::size_t(stance)] && made.pose().hips.y < most[std::size_t(stance)]);
	}
}

TEST(bad_wishes_change_nothing) {
	MotionMatcher made = matcher();
	const Pose before = made.pose();
	Wish wish;
	wish.velocity.x = std::numeric_limits<float>::quiet_NaN();
	made.advance(DELTA, wish);
	wish = Wish();
	wish.wished_heading = std::numeric_limits<float>::infinity();
	made.advance(DELTA, wish);
	wish = Wish();
	wish.velocity.z = 1e30f;
	made.advance(DELTA, wish);
	made.advance(-1.0f, Wish());
	made.advance(std::numeric_limits<float>::quiet_NaN(), Wish());
	CHECK(is_same(made.pose(), before));
	MotionMatcher empty;
	empty.advance(DELTA, Wish());
	CHECK(is_pose(empty.pose()));
}

TEST(feet_stand_on_ground_that_is_given) {
	MotionMatcher made = matcher();
	Wish wish;
	wish.ground = { 0.12f, 0.0f };
	for (int i = 0; i < 60; i++) {
		made.advance(DELTA, wish);
	}
	CHECK_NEAR(ball(made, 0).y, 0.12, 0.01);
	CHECK_NEAR(ball(made, 1).y, 0.0, 0.01);
}

TEST(who_goes_sideways_does_not_cross_his_legs) {
	MotionMatcher made = matcher();
	Mover mover;
	mover.want(1.0f, 0.5f * PI);
	for (int i = 0; i < 360; i++) {
		mover.advance(DELTA);
		made.advance(DELTA, mover.wish);
		// He faces +Z, so that his left is +X.
		CHECK(i < 120 || ball(made, 0).x - ball(made, 1).x > 0.0f);
	}
}

TEST(hips_do_not_drop_at_once) {
	MotionMatcher made = matcher();
	Mover mover;
	float last = made.pose().hips.y;
	for (int i = 0; i < 600; i++) {
		mover.want(i < 300 ? 1.9f : 2.6f, 0.0f);
		mover.advance(DELTA);
		made.advance(DELTA, mover.wish);
		CHECK(std::fabs(made.pose().hips.y - last) < 0.05f);
		last = made.pose().hips.y;
	}
}
