// SPDX-License-Identifier: MIT
#include "walker_fixture.hpp"

#include <check.hpp>

#include <cmath>

using namespace matching;

TEST(a_leg_reaches_where_it_can_and_keeps_its_lengths) {
	const Body body = Body::of(1.0f);
	for (const Vec3 ankle : { Vec3{ 0.0f, 0.2f, 0.1f }, Vec3{ 0.1f, 0.3f, -0.2f }, Vec3{ 0.0f, -3.0f, 0.0f } }) {
		Quat thigh;
		Quat shank;
		const Vec3 joint{ 0.0f, 1.0f, 0.0f };
		const Vec3 found = reach(joint, ankle, body.thigh, body.shank, { 0.0f, 0.0f, 1.0f }, thigh, shank);
		const Vec3 knee = joint + thigh.rotate({ 0.0f, -body.thigh, 0.0f });
		const Vec3 end = knee + shank.rotate({ 0.0f, -body.shank, 0.0f });
		CHECK_NEAR((end - found).length(), 0.0, 1e-4);
		const bool is_near = (ankle - joint).length() < body.leg();
		CHECK(is_near ? (found - ankle).length() < 1e-3f : found.y > joint.y - body.leg());
		// Knees bend forward.
		CHECK(knee.z >= std::min(joint.z, found.z) - 1e-4f);
	}
}

TEST(a_clip_has_the_way_speed_and_feet_of_the_recording) {
	const Clip walk = walker_fixture::clip("walk", 1.4f);
	int stands = 0;
	for (const ClipFrame &frame : walk.frames) {
		CHECK_NEAR(frame.velocity_z, 1.4, 0.05);
		CHECK_NEAR(frame.velocity_x, 0.0, 0.01);
		CHECK_NEAR(frame.pose.hips.x, 0.0, 0.01);
		stands += (frame.contacts & 1U) != 0 ? 1 : 0;
	}
	const double share = double(stands) / double(walk.frames.size());
	CHECK(share > 0.45 && share < 0.65);
	for (const ClipFrame &frame : walk.frames) {
		for (std::size_t side = 0; side < 2; side++) {
			const bool is_low = frame.pose.ankles[side].y < walk.ankle_height + 0.06f;
			CHECK(((frame.contacts >> side) & 1U) == 0 || is_low);
		}
	}
}

TEST(ground_that_rises_is_levelled) {
	const Body body = Body::of(1.0f);
	std::vector<RawFrame> frames = walker_fixture::walk(1.4f, 5.0f, body);
	for (std::size_t i = 0; i < frames.size(); i++) {
		frames[i].hips.y += 0.0002f * float(i);
	}
	const Clip clip = build_clip(frames, 30, frames.size() - 30, body);
	CHECK_NEAR(clip.frames.front().pose.hips.y, clip.frames.back().pose.hips.y, 0.015);
}

TEST(a_mirrored_clip_is_mirrored_back) {
	const Clip walk = walker_fixture::clip("walk", 1.4f);
	const Clip twice = mirror(mirror(walk));
	const Clip once = mirror(walk);
	CHECK_NEAR(once.frames[7].pose.ankles[0].x, -walk.frames[7].pose.ankles[1].x, 1e-6);
	for (std::size_t limb = 0; limb < LIMBS; limb++) {
		CHECK_NEAR(kinematics::angle_between(twice.frames[7].pose.limbs[limb], walk.frames[7].pose.limbs[limb]), 0.0,
				1e-3);
	}
}

TEST(a_set_knows_who_stands_and_walks_backwards) {
	const auto set = walker_fixture::motion_set();
	CHECK(set->has(STAND, true));
	CHECK(set->has(STAND, false));
	CHECK(!set->has(CROUCH));
	int back = 0;
	for (const MotionSet::Entry &entry : set->entries()) {
		back += !entry.stands && std::fabs(entry.travel) > 3.0f ? 1 : 0;
	}
	// Slow, walk and their mirrored twins; nobody runs backwards.
	CHECK(back == 4);
}

TEST(the_nearest_row_is_that_of_a_plain_comparison) {
	const auto set = walker_fixture::motion_set();
	const FeatureTable &table = set->table();
	for (int i = 0; i < table.size(); i += 17) {
		Features row = set->features_at(set->place_of(i));
		row[PLACES + 5] += 0.4f;
		row[ANKLES] += 0.02f;
		table.scale(row);
		const FeatureTable::Found found = table.nearest(row, 5, table.size() - 3, 1e9f);
		float best = 1e9f;
		for (int k = 5; k < table.size() - 3; k++) {
			best = std::min(best, table.cost(k, row));
		}
		CHECK(found.cost == best && found.row >= 5 && found.row < table.size() - 3);
		CHECK(table.nearest(row, 0, table.size(), 0.0f).row == -1);
	}
}

TEST(feet_that_stand_on_an_edge_are_levelled) {
	Clip tilted = walker_fixture::clip("walk", 1.4f);
	const Clip level = tilted;
	for (ClipFrame &frame : tilted.frames) {
		for (std::size_t side = 0; side < 2; side++) {
			Quat &foot = frame.pose.limbs[foot_of(side)];
			foot = foot * kinematics::exp({ 0.0f, 0.0f, side == 0 ? 0.35f : -0.35f });
		}
	}
	level_feet(tilted);
	for (std::size_t i = 0; i < level.frames.size(); i += 13) {
		for (std::size_t side = 0; side < 2; side++) {
			const std::size_t foot = foot_of(side);
			CHECK_NEAR(kinematics::angle_between(tilted.frames[i].pose.limbs[foot], level.frames[i].pose.limbs[foot]),
					0.0, 1e-3);
		}
	}
}
