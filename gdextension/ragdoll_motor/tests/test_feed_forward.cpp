// SPDX-License-Identifier: MIT
#include "control/feed_forward.hpp"

#include "check.hpp"
#include "fixtures.hpp"

namespace test_feed_forward {

using namespace ragdoll;

namespace {

constexpr float DELTA = 1.0f / 60.0f;

/// A body whose motion is known: one step is made ready, the next is what is looked at.
struct Moving {
	Rig rig{ fixtures::limbs() };
	FeedForward feed_forward{ rig };
	std::vector<LimbCommand> commands{ 4 };
	std::vector<LimbPush> pushes{ 4 };

	Moving() {
		for (LimbCommand &command : commands) {
			command.whole_torque = 1e6f;
		}
	}

	/// The state is the pose at the beginning of the step.
	const std::vector<LimbPush> &step(const Pose &p_now, const Pose &p_next) {
		pushes.assign(4, LimbPush());
		feed_forward.add(rig, fixtures::state_of(rig, p_now), p_now, p_next, DELTA, commands, pushes);
		return pushes;
	}
};

Pose upright() {
	Pose pose;
	pose.orientations.assign(4, Quat());
	return pose;
}

/// Turns a limb about X with what hangs on nothing but it.
Pose bent(std::size_t p_limb, float p_angle) {
	Pose pose = upright();
	pose.orientations[p_limb] = exp({ p_angle, 0.0f, 0.0f });
	return pose;
}

} // namespace

TEST(nothing_comes_from_outside) {
	std::mt19937 random(5);
	for (int round = 0; round < 50; round++) {
		Moving body;
		Pose poses[3];
		for (Pose &pose : poses) {
			pose = fixtures::random_pose(random);
			pose.root = { 0.01f * float(round), 1.0f, 0.0f };
		}
		body.step(poses[0], poses[1]);
		const std::vector<LimbPush> &pushes = body.step(poses[1], poses[2]);
		const RigState state = fixtures::state_of(body.rig, poses[1]);
		Vec3 force;
		Vec3 moment;
		float sum = 0.0f;
		for (std::size_t i = 0; i < 4; i++) {
			force = force + pushes[i].force;
			moment = moment + pushes[i].torque + state.centres[i].cross(pushes[i].force);
			sum += pushes[i].force.length() + pushes[i].torque.length();
		}
		CHECK(sum > 100.0f);
		CHECK(force.length() < 1e-5f * sum);
		CHECK(moment.length() < 1e-5f * sum);
	}
}

TEST(a_limb_at_rest_is_carried_by_the_root) {
	Moving body;
	const Pose pose = bent(2, 1.5f);
	body.step(pose, pose);
	const std::vector<LimbPush> &pushes = body.step(pose, pose);
	for (std::size_t i = 1; i < 4; i++) {
		CHECK_NEAR(pushes[i].force.y, 10.0 * STANDARD_GRAVITY, 1e-3);
		CHECK(pushes[i].torque.length() < 1e-3f);
	}
	CHECK_NEAR(pushes[0].force.y, -30.0 * STANDARD_GRAVITY, 1e-3);
}

TEST(whose_motion_falls_needs_nothing) {
	Moving body;
	Pose poses[3] = { upright(), upright(), upright() };
	poses[1].root.y = -1.0f;
	poses[2].root.y = -2.0f - STANDARD_GRAVITY * DELTA * DELTA;
	body.step(poses[0], poses[1]);
	for (const LimbPush &push : body.step(poses[1], poses[2])) {
		CHECK(push.force.length() < 0.1f);
	}
}

TEST(a_limb_that_begins_to_turn_gets_its_inertia_times_that) {
	Moving body;
	body.step(upright(), upright());
	const float rate = 2.0f;
	const std::vector<LimbPush> &pushes = body.step(upright(), bent(2, rate * DELTA));
	CHECK_NEAR(pushes[2].torque.x, 0.2 * rate / DELTA, 0.01);
	CHECK_NEAR(pushes[2].force.z, 10.0 * 0.25 * rate / DELTA, 0.5);
	CHECK(pushes[3].torque.length() < 1e-3f);
}

TEST(what_hangs_on_a_limp_limb_gets_nothing) {
	Moving body;
	body.commands[1].mode = Actuation::LIMP;
	const Pose pose = bent(2, 1.5f);
	body.step(pose, pose);
	for (const LimbPush &push : body.step(pose, bent(2, 1.6f))) {
		CHECK(push.force.length() + push.torque.length() == 0.0f);
	}
}

TEST(no_joint_gives_more_than_its_torque) {
	Moving body;
	body.commands[2].whole_torque = 100.0f;
	body.step(upright(), upright());
	const std::vector<LimbPush> &pushes = body.step(upright(), bent(2, 0.2f));
	const Vec3 arm{ 0.0f, 0.25f, 0.0f };
	CHECK_NEAR((pushes[2].torque + arm.cross(pushes[2].force)).length(), 20.0, 1e-2); // 0.2 of 0.2 of 500 N m.
}

TEST(a_weak_limb_leaves_its_sibling_alone) {
	Moving body;
	body.commands[2].whole_torque = 0.0f;
	body.step(upright(), upright());
	const std::vector<LimbPush> &pushes = body.step(upright(), bent(2, 0.2f));
	CHECK(pushes[2].force.length() + pushes[2].torque.length() == 0.0f);
	CHECK_NEAR(pushes[3].force.y, 10.0 * STANDARD_GRAVITY, 1e-3);
}

TEST(the_first_step_adds_nothing_and_a_restored_one_goes_on) {
	Moving body;
	Moving other;
	for (const LimbPush &push : body.step(upright(), bent(2, 0.1f))) {
		CHECK(push.force.length() == 0.0f);
	}
	ArchiveWriter archive;
	body.feed_forward.save(archive);
	ArchiveReader reader(archive.get_bytes().data(), archive.get_bytes().size());
	CHECK(other.feed_forward.restore(reader) && reader.is_at_end());
	const Vec3 expected = body.step(bent(2, 0.1f), bent(2, 0.3f))[2].force;
	CHECK(expected.length() > 1.0f);
	CHECK((other.step(bent(2, 0.1f), bent(2, 0.3f))[2].force - expected).length() == 0.0f);
}

TEST(limbs_are_scaled_by_what_they_carry) {
	std::vector<Segment> limbs = fixtures::limbs();
	limbs[3].is_foot = true;
	scale_inertia(limbs, 6.0f, 2.0f);
	CHECK_NEAR(limbs[0].inertia.y, 1.2, 1e-6);
	CHECK_NEAR(limbs[2].inertia.y, 0.4, 1e-6);
	CHECK_NEAR(limbs[3].inertia.x, 1.2, 1e-6);
}

} // namespace test_feed_forward
