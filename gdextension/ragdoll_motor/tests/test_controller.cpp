// SPDX-License-Identifier: MIT
#include "fixtures.hpp"

#include "comparison/comparison.hpp"

#include "check.hpp"

namespace test_controller {

using namespace ragdoll;

namespace {

constexpr float DELTA = 1.0f / 60.0f;

struct Bench {
	Rig rig{ fixtures::limbs() };
	ActuationTable table{ fixtures::groups(), 3 };
	Controller controller{ rig, make_thesis_joints };
	std::vector<LimbCommand> commands;

	void compute(const RigState &p_state, const Pose &p_now, const Pose &p_next) {
		controller.compute(p_state, p_now, p_next, DELTA, table, commands);
	}
};

} // namespace

TEST(feed_forward_alone_follows_exactly) {
	std::mt19937 random(3);
	Bench bench;
	for (int i = 0; i < 200; i++) {
		const Pose now = fixtures::random_pose(random);
		Pose next = now;
		for (Quat &orientation : next.orientations) {
			orientation = orientation * exp({ 0.05f, -0.02f, 0.03f });
		}
		bench.compute(fixtures::state_of(bench.rig, now), now, next);
		const Pose moved = fixtures::turned(bench.rig, now, bench.commands, DELTA);
		for (std::size_t limb = 0; limb < bench.rig.size(); limb++) {
			CHECK_NEAR(angle_between(moved.orientations[limb], next.orientations[limb]), 0.0, 1e-3);
		}
	}
}

TEST(motor_modes_remove_errors_without_overshoot) {
	std::mt19937 random(4);
	for (const Actuation mode : { Actuation::VELOCITY_MOTOR, Actuation::ANGULAR_MOTOR }) {
		Bench bench;
		bench.table.set_mode(mode, -1, 0.0f);
		const Pose target = fixtures::random_pose(random);
		Pose pose;
		pose.orientations.resize(bench.rig.size());
		double before = 100.0;
		for (int i = 0; i < 300; i++) {
			bench.compute(fixtures::state_of(bench.rig, pose), target, target);
			pose = fixtures::turned(bench.rig, pose, bench.commands, DELTA);
			const Quat relative = pose.orientations[0].inverse() * pose.orientations[1];
			const Quat wanted = target.orientations[0].inverse() * target.orientations[1];
			const double error = angle_between(relative, wanted);
			CHECK(error <= before + 1e-5);
			before = error;
		}
		CHECK_NEAR(before, 0.0, 1e-3);
	}
}

TEST(the_angular_motor_has_no_feed_forward) {
	Bench bench;
	bench.table.set_mode(Actuation::ANGULAR_MOTOR, -1, 0.0f);
	Pose now;
	now.orientations.resize(bench.rig.size());
	Pose next = now;
	next.orientations[1] = exp({ 0.1f, 0.0f, 0.0f });
	bench.compute(fixtures::state_of(bench.rig, now), now, next);
	CHECK_NEAR(bench.commands[1].velocity.length(), 0.0, 1e-6);
}

TEST(a_correction_can_always_be_braked) {
	CHECK_NEAR(braking_speed(0.5f, 4.0f), 2.0, 1e-6);
	CHECK_NEAR(braking_speed(-1.0f, 4.0f), 0.0, 0.0);
	Bench bench;
	bench.table.set_strength(0.1f, -1, 0.0f);
	Pose now;
	now.orientations.resize(bench.rig.size());
	Pose away = now;
	away.orientations[2] = exp({ 2.0f, 0.0f, 0.0f });
	bench.compute(fixtures::state_of(bench.rig, now), away, away);
	const float most = braking_speed(2.0f, 50.0f / bench.rig.get_subtree_inertia(2).x);
	CHECK(most < 2.0f * 45.0f);
	CHECK_NEAR(bench.commands[2].velocity.length(), most, 1e-3);
	CHECK_NEAR(bench.commands[2].max_torque, 50.0, 1e-3);
}

TEST(the_spring_pulls_towards_the_motion_and_never_above_its_limit) {
	Bench bench;
	bench.table.set_mode(Actuation::SPRING_TORQUE, 1, 0.0f);
	Pose now;
	now.orientations.resize(bench.rig.size());
	Pose away = now;
	away.orientations[2] = exp({ 0.05f, 0.0f, 0.0f });
	bench.compute(fixtures::state_of(bench.rig, now), away, away);
	CHECK(bench.commands[2].torque.x > 0.0f);
	const float first = bench.commands[2].torque.x;
	for (int i = 0; i < 60; i++) {
		bench.compute(fixtures::state_of(bench.rig, now), away, away);
	}
	CHECK(bench.commands[2].torque.x > first * 1.02f); // The leaky integrator has filled.
	away.orientations[2] = exp({ 3.0f, 0.0f, 0.0f });
	bench.compute(fixtures::state_of(bench.rig, now), away, away);
	CHECK(bench.commands[2].torque.length() <= 500.0f * 1.001f);
	CHECK(bench.commands[1].mode == Actuation::VELOCITY_MOTOR);
}

TEST(a_single_spring_settles_however_stiff) {
	// One free limb, turned by the torque alone: semi-implicit Euler, as the engine does it.
	for (const float frequency : { 1.0f, 4.0f, 30.0f, 1000.0f }) {
		Bench bench;
		bench.table.set_mode(Actuation::SPRING_TORQUE, 1, 0.0f);
		bench.table.set_spring(frequency, 1.0f, 1);
		Pose target;
		target.orientations.resize(bench.rig.size());
		target.orientations[2] = exp({ 0.3f, 0.0f, 0.0f });
		RigState state = fixtures::state_of(bench.rig, target);
		state.orientations[2] = Quat();
		const float inertia = bench.rig.get_subtree_inertia(2).x;
		for (int i = 0; i < 600; i++) {
			bench.compute(state, target, target);
			state.angular[2] = state.angular[2] + bench.commands[2].torque * (DELTA / inertia);
			state.orientations[2] = state.orientations[2] * exp(state.angular[2] * DELTA);
		}
		CHECK_NEAR(angle_between(state.orientations[2], target.orientations[2]), 0.0, 0.02);
	}
}

TEST(the_position_motor_looks_ahead_and_asks_for_no_more_than_its_torque) {
	Bench bench;
	bench.table.set_mode(Actuation::POSITION_MOTOR, 1, 0.0f);
	bench.table.set_spring(10.0f, 1.0f, 1);
	Pose now;
	now.orientations.resize(bench.rig.size());
	Pose next = now;
	next.orientations[2] = exp({ 0.01f, 0.0f, 0.0f });
	bench.compute(fixtures::state_of(bench.rig, now), now, next);
	const LimbCommand &command = bench.commands[2];
	CHECK_NEAR(log(command.target).x, 0.01 + 0.01 / double(DELTA) * command.damping.x / command.stiffness.x, 1e-3);
	next.orientations[2] = exp({ 3.0f, 0.0f, 0.0f });
	bench.compute(fixtures::state_of(bench.rig, now), next, next);
	CHECK(log(command.target).length() * command.stiffness.x <= 500.0f * 1.01f);
}

TEST(limbs_that_are_put_meet_their_parents) {
	std::mt19937 random(5);
	Bench bench;
	bench.table.set_mode(Actuation::DIRECT_SET, 1, 0.0f);
	const Pose actual = fixtures::random_pose(random);
	Pose next = fixtures::random_pose(random);
	next.root = { 5.0f, 0.0f, 0.0f }; // The root is not put: its limb stays with it.
	const RigState state = fixtures::state_of(bench.rig, actual);
	std::vector<Quat> orientations;
	std::vector<Vec3> joints;
	place_limbs(bench.rig, state, next, DELTA, bench.table, orientations, joints);
	CHECK_NEAR(angle_between(orientations[2], next.orientations[2]), 0.0, 1e-3);
	const Vec3 above = joints[1] + orientations[1].rotate(bench.rig[2].anchor);
	CHECK_NEAR((joints[2] - above).length(), 0.0, 1e-5);
	bench.table.set_mode(Actuation::DIRECT_SET, -1, 0.0f);
	place_limbs(bench.rig, state, next, DELTA, bench.table, orientations, joints);
	CHECK_NEAR(joints[0].x, 5.0, 1e-6);
}

TEST(joint_positions_follow_the_anchors) {
	std::vector<Segment> limbs = fixtures::limbs();
	limbs[1].anchor = { 1.0f, 0.0f, 0.0f };
	limbs[2].anchor = { 1.0f, 0.0f, 0.0f };
	const Rig rig(limbs);
	Pose pose;
	pose.root = { 0.0f, 1.0f, 0.0f };
	pose.orientations = { exp({ 0.0f, 0.0f, 3.14159265f / 2 }), Quat(), Quat(), Quat() };
	std::vector<Vec3> positions;
	rig.joint_positions(pose, positions);
	CHECK_NEAR(positions[1].y, 2.0, 1e-5);
	CHECK_NEAR(positions[2].x, 1.0, 1e-5);
	CHECK_NEAR(rig.get_mass(), 40.0, 1e-4);
}

TEST(subtree_inertia_counts_all_that_hangs_below) {
	const Rig rig(fixtures::limbs());
	CHECK_NEAR(rig.get_subtree_inertia(3).y, 0.05, 1e-6);
	CHECK_NEAR(rig.get_subtree_inertia(3).x, 0.2 + 10.0 * 0.25 * 0.25, 1e-4);
	CHECK_NEAR(rig.get_subtree_inertia(1).x, 3 * 0.2 + 10.0 * (0.25 * 0.25 + 2 * 0.75 * 0.75), 1e-3);
}

TEST(root_drive_corrects_within_its_limits) {
	const Rig rig(fixtures::limbs());
	RootSettings settings;
	RigState still;
	const RootCommand soft =
			drive_root(RootMode::SOFT, settings, rig, still, { 0.001f, 0, 0 }, { 0.011f, 0, 0 }, 0.01f, 0.5f);
	CHECK_NEAR(soft.velocity.x, 1.0 + 0.05, 1e-4);
	CHECK_NEAR(soft.force_up, 1000.0, 1e-3);
	CHECK_NEAR(soft.torque, 400.0, 1e-3);
	const RootCommand far = drive_root(RootMode::SOFT, settings, rig, still, { 10, 0, 0 }, { 10, 0, 0 }, 0.01f, 1.0f);
	CHECK_NEAR(far.velocity.x, braking_speed(10.0f, 2000.0f / 40.0f), 1e-3);
	const RootCommand grip = drive_root(RootMode::INERTIAL, settings, rig, still, {}, {}, 0.01f, 1.0f);
	CHECK_NEAR(grip.force_across, double(settings.grip) * 40.0 * 9.81, 0.1);
	still.gravity = { 0.0f, -1.62f, 0.0f }; // The Moon's.
	const RootCommand light = drive_root(RootMode::INERTIAL, settings, rig, still, {}, {}, 0.01f, 1.0f);
	CHECK_NEAR(light.force_across, double(settings.grip) * 40.0 * 1.62, 0.1);
	still.gravity = {};
	const RootCommand weightless =
			drive_root(RootMode::INERTIAL, settings, rig, still, { 1, 1, 0 }, { 1, 1, 0 }, 0.01f, 1.0f);
	CHECK_NEAR(weightless.force_across, 0.0, 0.0);
	CHECK_NEAR(weightless.velocity.x, 0.0, 0.0);
	CHECK_NEAR(weightless.velocity.y, braking_speed(1.0f, 2000.0f / 40.0f), 1e-3);
	const RootCommand free =
			drive_thesis_root(RootMode::SELF_RIGHTING, settings, still, {}, {}, { 1, 0, 0 }, -1, 0.01f, 0.5f);
	CHECK_NEAR(free.force_up + free.force_across, 0.0, 0.0);
	CHECK_NEAR(free.torque, 400.0, 1e-3);
	const RootCommand hung =
			drive_thesis_root(RootMode::PENDULUM, settings, still, {}, {}, { 1, 0, 0 }, -1, 0.01f, 0.5f);
	CHECK_NEAR(hung.torque, 0.0, 0.0); // The weight's joint turns it instead.
	CHECK_NEAR(hung.assist_torque, 400.0, 1e-3);
	CHECK_NEAR(hung.assist_turn.x, 1.0, 0.0);
}

TEST(the_root_rises_and_sinks_by_its_own_limits) {
	const Rig rig(fixtures::limbs());
	RootSettings settings;
	settings.grip = 0.1f; // Hardly any force across, all of it upwards.
	const RigState still;
	const auto climb = [&](float p_x, float p_y) {
		const Vec3 target{ p_x, p_y, 0.0f };
		return drive_root(RootMode::INERTIAL, settings, rig, still, target, target, 0.01f, 1.0f).velocity;
	};
	const float up = 2000.0f / 40.0f;
	CHECK_NEAR(climb(0.0f, 1.0f).y, braking_speed(1.0f, up + 9.81f), 1e-3);
	CHECK_NEAR(climb(0.0f, -1.0f).y, -braking_speed(1.0f, up - 9.81f), 1e-3);
	// Neither is slowed by the other, nor hurried.
	CHECK_NEAR(climb(2.0f, 1.0f).y, climb(0.0f, 1.0f).y, 1e-6);
	CHECK_NEAR(climb(2.0f, 1.0f).x, braking_speed(2.0f, 0.1f * 9.81f), 1e-3);
	settings.force = 100.0f; // Less than the weight: what sinks could not be held.
	CHECK_NEAR(climb(0.0f, -1.0f).y, 0.0, 0.0);
}

TEST(composite_inertia_is_that_of_the_present_pose) {
	std::mt19937 random(11);
	const Rig rig(fixtures::limbs());
	CompositeInertia turned(rig.size());
	Pose rest;
	rest.orientations.assign(rig.size(), Quat());
	turned.find(rig, fixtures::state_of(rig, rest));
	for (std::size_t i = 0; i < rig.size(); i++) {
		CHECK_NEAR((turned[i] - rig.get_subtree_inertia(i)).length(), 0.0, 1e-4);
	}
	for (int round = 0; round < 20; round++) {
		// Against a rig whose rest pose is this one, far from the origin.
		Pose pose = fixtures::random_pose(random);
		pose.root = { 30.0f, 2.0f, -10.0f };
		std::vector<Segment> limbs = fixtures::limbs();
		for (std::size_t i = 0; i < limbs.size(); i++) {
			limbs[i].rest = pose.orientations[i];
		}
		const Rig posed(limbs);
		turned.find(rig, fixtures::state_of(rig, pose));
		for (std::size_t i = 0; i < rig.size(); i++) {
			CHECK_NEAR((turned[i] - posed.get_subtree_inertia(i)).length(), 0.0, 2e-3);
		}
	}
}

} // namespace test_controller
