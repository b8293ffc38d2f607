// SPDX-License-Identifier: MIT
#include "fixtures.hpp"

#include "check.hpp"

namespace test_driver_parts {

using namespace ragdoll;

namespace {

constexpr float STILL[16] = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1 };
constexpr float DELTA = 0.01f;

Pose standing() {
	Pose pose;
	pose.orientations.assign(fixtures::limbs().size(), Quat());
	return pose;
}

} // namespace

TEST(a_motion_begins_stalls_and_comes_back) {
	PoseStream stream(4);
	StreamWatch watch;
	CHECK(stream.push(1.0, STILL, {}, nullptr));
	CHECK(!watch.has_begun());
	CHECK(watch.advance(stream, 1.0));
	CHECK(watch.has_begun() && watch.has_resumed());
	CHECK(!watch.advance(stream, 1.05) && !watch.has_resumed());
	CHECK(!watch.advance(stream, 1.5)); // Stalled.
	CHECK(stream.push(1.6, STILL, {}, nullptr));
	CHECK(!watch.advance(stream, 1.6) && watch.has_resumed());
	CHECK(stream.push(1.6 + 2.0 * StreamWatch::RESTART_AFTER, STILL, {}, nullptr));
	CHECK(watch.advance(stream, 1.6 + 2.0 * StreamWatch::RESTART_AFTER));
	watch.clear();
	CHECK(!watch.has_begun());
}

TEST(only_who_was_limp_is_lifted_until_upright) {
	const Rig rig(fixtures::limbs());
	const Pose motion = standing();
	Pose askew = motion;
	askew.orientations[2] = exp({ 1.0f, 0.0f, 0.0f });
	const RigState lying = fixtures::state_of(rig, askew);
	GettingUp getting_up;
	getting_up.advance(lying, motion, motion, false, false, 0.2f, DELTA);
	CHECK_NEAR(getting_up.get_lift().y, 0.0, 0.0);
	getting_up.advance(lying, motion, motion, true, false, 0.2f, DELTA);
	CHECK_NEAR(getting_up.get_lift().y, 0.0, 0.0);
	getting_up.advance(lying, motion, motion, false, false, 0.2f, DELTA);
	CHECK_NEAR(getting_up.get_lift().y, 0.25 * double(GettingUp::LIFT), 1e-5);
	const RigState upright = fixtures::state_of(rig, motion);
	for (int i = 0; i < 25; i++) {
		getting_up.advance(upright, motion, motion, false, false, 0.2f, DELTA);
	}
	getting_up.advance(lying, motion, motion, false, false, 0.2f, DELTA);
	CHECK_NEAR(getting_up.get_lift().y, 0.0, 0.0);
}

TEST(who_is_stuck_is_lifted_further_where_the_travel_is_found) {
	const Rig rig(fixtures::limbs());
	const Pose motion = standing();
	Pose askew = motion;
	askew.orientations[2] = exp({ 1.0f, 0.0f, 0.0f });
	const RigState lying = fixtures::state_of(rig, askew);
	for (const float highest : { 10.0f, 0.2f }) {
		GettingUp getting_up;
		getting_up.advance(lying, motion, motion, true, true, highest, DELTA);
		for (int i = 0; i < 300; i++) {
			getting_up.advance(lying, motion, motion, false, true, highest, DELTA);
		}
		const float most = 0.25f * GettingUp::LIFT * GettingUp::MOST;
		CHECK_NEAR(getting_up.get_lift().y, double(std::min(most, highest)), 1e-4);
	}
}

TEST(a_frame_takes_the_motion_to_the_world_and_back) {
	const Rig rig(fixtures::limbs());
	const RigState state = fixtures::state_of(rig, standing());
	CarriedFrame frame;
	CHECK(frame.is_world());
	const Quat turn = exp({ 0.0f, 1.0f, 0.0f });
	frame.set(turn, { 2.0f, 0.0f, 0.0f });
	frame.advance(rig, {}, state, nullptr, DELTA);
	CHECK_NEAR(frame.get_way({}).x, 2.0, 1e-6);
	Pose now = standing();
	Pose next = standing();
	frame.apply(now, next);
	CHECK_NEAR(now.root.x, 0.0, 0.0); // It was the world's at the beginning of the step.
	CHECK_NEAR(next.root.x, 2.0, 1e-6);
	CHECK_NEAR(angle_between(next.orientations[3], turn), 0.0, 1e-3);
	std::vector<Vec3> points{ next.root };
	frame.to_own(next.orientations, points);
	CHECK_NEAR(points[0].length(), 0.0, 1e-6);
	CHECK_NEAR(angle_between(next.orientations[3], Quat()), 0.0, 1e-3);
}

TEST(a_root_that_becomes_held_is_fetched) {
	const Rig rig(fixtures::limbs());
	const Pose motion = standing();
	Pose away = motion;
	away.root = { 1.0f, 0.0f, 0.0f };
	HeldRoot root;
	Quat orientation;
	Vec3 joint;
	root.place(fixtures::state_of(rig, away), motion, motion, {}, DELTA, orientation, joint);
	CHECK_NEAR(joint.x, 1.0 - double(HeldRoot::FETCH_SPEED * DELTA), 1e-4);
	root.finish(true);
	away.root.x = HeldRoot::ARRIVED / 2.0f;
	root.place(fixtures::state_of(rig, away), motion, motion, {}, DELTA, orientation, joint);
	CHECK_NEAR(joint.x, 0.0, 1e-6);
}

TEST(a_limb_that_is_held_back_lets_the_root_be_pulled_for_a_while) {
	const Rig rig(fixtures::limbs());
	ActuationTable table(fixtures::groups(), 3);
	const Pose motion = standing();
	RigState state = fixtures::state_of(rig, motion);
	HeldRoot root;
	CHECK(!root.is_obstructed(rig, table, nullptr, state, motion, motion, DELTA));
	state.centres[3].x += 2.0f * HeldRoot::HELD_BACK;
	CHECK(root.is_obstructed(rig, table, nullptr, state, motion, motion, DELTA));
	state = fixtures::state_of(rig, motion);
	CHECK(root.is_obstructed(rig, table, nullptr, state, motion, motion, DELTA));
	CHECK(!root.is_obstructed(rig, table, nullptr, state, motion, motion, HeldRoot::OBSTRUCTED_S));
}

TEST(joints_say_what_part_of_their_torque_they_needed) {
	const Rig rig(fixtures::limbs());
	ActuationTable table(fixtures::groups(), 3);
	TorqueMeter meter(rig.size());
	RigState state = fixtures::state_of(rig, standing());
	state.gravity = { 9.81f, 0.0f, 0.0f }; // Limbs lie, as it were.
	meter.note(rig, state, DELTA);
	meter.compare(rig, table, 40.0f, 800.0f);
	CHECK(meter.get_torques()[3] > 1.0f);
	CHECK_NEAR(meter.get_saturations()[3], double(meter.get_torques()[3] / 500.0f), 1e-6);
	CHECK_NEAR(meter.get_saturations()[0], 0.05, 1e-6);
}

TEST(the_residual_is_counted_with_what_the_motor_pushes_itself) {
	ResidualMeter meter;
	CHECK_NEAR(meter.find_torque(0.95), 0.0, 1e-6);
	for (int i = 0; i < 100; i++) {
		meter.expect({ { 30.0f, 0.0f, 0.0f }, {} });
		meter.note({ { 0.0f, 0.0f, 40.0f }, { 0.0f, i < 94 ? 12.0f : 5000.0f, 0.0f } });
	}
	CHECK_NEAR(meter.get_latest().force.length(), 50.0, 1e-4);
	CHECK_NEAR(meter.get_latest().torque.y, 5000.0, 1e-2);
	CHECK_NEAR(meter.find_torque(0.94), 20.0, 1e-4);
	CHECK(meter.find_torque(0.95) > 2000.0f); // Whatever is beyond the last bin is there.
	meter.clear();
	CHECK_NEAR(meter.find_torque(0.5), 0.0, 1e-6);
}

} // namespace test_driver_parts
