// SPDX-License-Identifier: MIT
#include "whole_body.hpp"

#include "driver.hpp"

#include "check.hpp"

#include <random>

namespace test_self_clearance {

using namespace ragdoll;
using namespace whole_body;

namespace {

constexpr float DELTA = 1.0f / 60.0f;

/// Somebody whose arms go from standing to a pose within a second and stay there.
struct Mover {
	Rig rig{ limbs() };
	SelfClearance clearance{ rig };
	Pose from = standing(rig);
	Pose to = from;
	Pose now;
	Pose next;
	Pose asked; // What next was moved from.
	float fastest = 0.0f; // Of any limb in a tick, rad.
	float deepest = 0.0f; // On the way, m.

	explicit Mover(float p_scale = 1.0f) : rig(limbs(p_scale)), clearance(rig), from(standing(rig)), to(from) {}

	Pose wanted(float p_time_s) const {
		const float share = std::clamp(p_time_s, 0.0f, 1.0f);
		Pose pose = from;
		for (int i = 0; i < COUNT; i++) {
			const float eased = share * share * (3.0f - 2.0f * share);
			pose.orientations[i] = slerp(from.orientations[i], to.orientations[i], eased);
		}
		return pose;
	}

	void run(float p_from_s, float p_to_s) {
		for (int tick = int(p_from_s / DELTA); tick < int(p_to_s / DELTA); tick++) {
			now = wanted(float(tick) * DELTA);
			next = wanted(float(tick + 1) * DELTA);
			asked = next;
			clearance.advance(rig, tick == 0, DELTA, now, next);
			for (int i = 0; i < COUNT; i++) {
				fastest = std::max(fastest, angle_between(now.orientations[i], next.orientations[i]));
			}
			deepest = std::max(deepest, find_depth(rig, next));
		}
	}
};

/// Arms anywhere before the body, in it, and beside it.
void draw_arms(std::mt19937 &r_random, Mover &r_mover) {
	std::uniform_real_distribution<float> draw(-1.0f, 1.0f);
	for (const bool left : { true, false }) {
		const Vec3 wrist{ -0.35f + 0.4f * draw(r_random), -0.25f + 0.45f * draw(r_random),
			0.3f + 0.25f * draw(r_random) };
		const Vec3 elbow{ 0.8f, -0.6f + 0.3f * draw(r_random), -0.2f + 0.3f * draw(r_random) };
		bend_arm(r_mover.rig, left, wrist, elbow, { -0.6f, 0.5f * draw(r_random), 0.4f }, r_mover.to);
	}
}

/// Crossed arms: deep in the chest.
void cross_arms(Mover &r_mover) {
	bend_arm(r_mover.rig, true, { -0.75f, -0.35f, 0.42f }, { 1.0f, -0.6f, -0.3f }, { -1.0f, 0.0f, 0.1f }, r_mover.to);
	bend_arm(r_mover.rig, false, { -0.75f, -0.25f, 0.5f }, { 1.0f, -0.6f, -0.3f }, { -1.0f, 0.0f, 0.1f }, r_mover.to);
}

float find_change(const Pose &p_from, const Pose &p_to) {
	float most = 0.0f;
	for (std::size_t i = 0; i < p_from.orientations.size(); i++) {
		most = std::max(most, angle_between(p_from.orientations[i], p_to.orientations[i]));
	}
	return most;
}

} // namespace

TEST(arms_that_go_into_the_body_end_on_its_surface) {
	std::mt19937 random(1);
	int inside = 0;
	// Where contacts contradict each other a limb may be left in another: one pose in a hundred.
	int left = 0;
	for (int number = 0; number < 100; number++) {
		Mover mover;
		draw_arms(random, mover);
		inside += find_depth(mover.rig, mover.to) > 0.03f ? 1 : 0;
		mover.run(0.0f, 2.0f);
		left += find_depth(mover.rig, mover.next) > 0.015f ? 1 : 0;
		// As people who begin in the pose do.
		Pose pose = mover.to;
		mover.clearance.clear(mover.rig, pose);
		left += find_depth(mover.rig, pose) > 0.015f ? 1 : 0;
	}
	CHECK(left <= 4);
	CHECK(inside > 50); // Otherwise there was nothing to do.
}

TEST(a_pose_beside_the_body_stays_as_it_is) {
	Mover mover;
	bend_arm(mover.rig, true, { 0.2f, 0.3f, 0.8f }, { 1.0f, -0.6f, 0.0f }, { 0.0f, 0.0f, 1.0f }, mover.to);
	mover.run(0.0f, 1.5f);
	CHECK(find_change(mover.next, mover.asked) == 0.0f);
	for (const float turn : mover.clearance.find_turns()) {
		CHECK(turn == 0.0f);
	}
}

TEST(arms_that_hang_clear_are_as_before_they_were_crossed) {
	Mover mover;
	cross_arms(mover);
	mover.run(0.0f, 2.0f);
	CHECK(find_change(mover.next, mover.to) > 0.2f);
	std::swap(mover.from, mover.to);
	mover.run(DELTA * 1.5f, 2.0f);
	CHECK(find_change(mover.next, mover.to) < 1e-4f);
}

TEST(hands_keep_their_orientation) {
	Mover mover;
	cross_arms(mover);
	mover.run(0.0f, 2.0f);
	for (const Part hand : { LEFT_HAND, RIGHT_HAND }) {
		CHECK(angle_between(mover.next.orientations[hand], mover.to.orientations[hand]) < 1e-3f);
	}
}

TEST(nothing_jumps_on_the_way_into_the_body) {
	std::mt19937 random(2);
	for (int number = 0; number < 50; number++) {
		Mover mover;
		draw_arms(random, mover);
		mover.run(0.0f, 1.5f);
		CHECK(mover.fastest < 0.7f); // The motion itself turns by up to 0.08 rad in a tick.
	}
}

TEST(an_arm_that_is_pulled_through_the_chest_stays_before_it_until_it_is_out) {
	Mover mover;
	bend_arm(mover.rig, true, { -0.3f, -0.3f, 0.75f }, { 1.0f, -0.6f, 0.0f }, { -0.6f, 0.0f, 0.8f }, mover.from);
	bend_arm(mover.rig, true, { -0.3f, -0.3f, -0.2f }, { 1.0f, -0.3f, -0.4f }, { -0.6f, 0.0f, 0.2f }, mover.to);
	std::vector<Vec3> joints;
	for (int tick = 0; tick < 60; tick++) {
		mover.run(float(tick) * DELTA + 0.001f, float(tick + 1) * DELTA + 0.001f);
		mover.rig.joint_positions(mover.next, joints);
		const float ahead = joints[LEFT_HAND].z - joints[CHEST].z;
		Pose wanted = mover.wanted(float(tick + 1) * DELTA);
		mover.rig.joint_positions(wanted, joints);
		// In the chest the wrist is wanted on either side of its middle.
		CHECK(ahead > 0.1f || find_depth(mover.rig, wanted) < 0.02f || joints[LEFT_HAND].z - joints[CHEST].z < -0.1f);
	}
	CHECK(mover.fastest < 0.7f);
}

TEST(a_small_change_of_the_pose_is_a_small_change_of_the_target) {
	std::mt19937 random(3);
	for (int number = 0; number < 30; number++) {
		Mover mover;
		draw_arms(random, mover);
		mover.run(0.0f, 3.0f);
		const Pose before = mover.next;
		for (const Part limb : { LEFT_UPPER_ARM, RIGHT_LOWER_ARM }) {
			mover.to.orientations[limb] = exp({ 0.0f, 0.001f, 0.0f }) * mover.to.orientations[limb];
		}
		mover.run(3.0f, 3.0f + 1.5f * DELTA);
		CHECK(find_change(before, mover.next) < 0.02f);
	}
}

TEST(a_pose_that_is_held_is_calm) {
	std::mt19937 random(4);
	for (int number = 0; number < 50; number++) {
		Mover mover;
		draw_arms(random, mover);
		mover.run(0.0f, 4.0f);
		mover.fastest = 0.0f;
		mover.run(4.0f, 4.5f);
		CHECK(mover.fastest < 0.0006f); // 2 deg/s
	}
}

TEST(bodies_of_other_sizes_are_cleared_too) {
	for (const float scale : { 0.6f, 0.8f, 1.2f }) {
		Mover mover(scale);
		cross_arms(mover);
		CHECK(find_depth(mover.rig, mover.to) > 0.05f * scale);
		mover.run(0.0f, 2.0f);
		CHECK(find_depth(mover.rig, mover.next) < 0.015f);
	}
}

TEST(what_overlaps_by_build_may_go_on) {
	std::vector<Segment> body = limbs();
	body[HEAD].shape.half.x = 0.75f; // A helmet that goes beyond the elbows.
	const Rig rig(body);
	SelfClearance clearance(rig);
	Pose now = rest();
	Pose next = now;
	clearance.advance(rig, true, DELTA, now, next);
	CHECK(find_change(next, rest()) == 0.0f);
}

TEST(crossed_legs_come_apart) {
	Mover mover;
	for (const bool left : { true, false }) {
		const Quat turn = exp({ left ? 0.1f : -0.1f, 0.0f, left ? -0.3f : 0.3f });
		const int upper = left ? LEFT_UPPER_LEG : RIGHT_UPPER_LEG;
		mover.to.orientations[upper] = mover.to.orientations[upper + 1] = turn;
	}
	CHECK(find_depth(mover.rig, mover.to, LEFT_LOWER_LEG, RIGHT_LOWER_LEG) > 0.05f);
	mover.run(0.0f, 3.0f);
	CHECK(find_depth(mover.rig, mover.next, LEFT_LOWER_LEG, RIGHT_LOWER_LEG) < 0.015f);
	CHECK(angle_between(mover.next.orientations[LEFT_FOOT], mover.to.orientations[LEFT_FOOT]) < 1e-3f);
}

TEST(a_restored_state_goes_on_the_same) {
	Mover mover;
	cross_arms(mover);
	mover.run(0.0f, 0.5f);
	ArchiveWriter archive;
	mover.clearance.save(archive);
	mover.run(0.5f, 1.0f);
	Mover other;
	cross_arms(other);
	ArchiveReader reader(archive.get_bytes().data(), archive.get_bytes().size());
	CHECK(other.clearance.restore(reader) && reader.is_at_end());
	other.run(0.5f, 1.0f);
	CHECK(find_change(mover.next, other.next) == 0.0f);
}

TEST(without_shapes_or_with_no_limit_nothing_is_moved) {
	std::vector<Segment> body = limbs();
	for (Segment &limb : body) {
		limb.shape = {};
	}
	Mover bare;
	bare.rig = Rig(body);
	bare.clearance = SelfClearance(bare.rig);
	cross_arms(bare);
	bare.run(0.0f, 1.5f);
	CHECK(find_change(bare.next, bare.asked) == 0.0f);
	Mover unlimited;
	unlimited.clearance.overlap = SelfClearance::NO_LIMIT;
	cross_arms(unlimited);
	unlimited.run(0.0f, 1.5f);
	CHECK(find_change(unlimited.next, unlimited.asked) == 0.0f);
}

TEST(a_driver_drives_to_where_the_limbs_are_clear) {
	Mover mover;
	cross_arms(mover);
	std::vector<int> groups;
	groups.reserve(mover.rig.size());
	for (std::size_t i = 0; i < mover.rig.size(); i++) {
		groups.push_back(mover.rig[i].group);
	}
	Driver driver(Rig(limbs()), groups, 6, {});
	std::vector<float> sample;
	for (const Quat &turn : mover.to.orientations) {
		sample.insert(sample.end(), { turn.x, turn.y, turn.z, turn.w });
	}
	driver.push(0.0, sample.data(), {}, nullptr);
	RigState state;
	state.resize(mover.rig.size());
	// The body is put into the pose that it begins with.
	CHECK(driver.step(state, 0.0, DELTA).must_put);
	Pose put = mover.to;
	put.orientations = state.orientations;
	CHECK(find_depth(mover.rig, put) < 0.015f);
	for (const float error : driver.find_errors(state)) {
		CHECK(error < 1e-3f);
	}
	CHECK(driver.get_clearance().find_turns()[LEFT_LOWER_ARM] > 0.2f);
}

} // namespace test_self_clearance
