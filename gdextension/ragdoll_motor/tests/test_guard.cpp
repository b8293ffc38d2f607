// SPDX-License-Identifier: MIT
#include "fixtures.hpp"

#include "check.hpp"

#include <limits>

namespace test_guard {

using namespace ragdoll;

namespace {

RigState resting(const Rig &p_rig) {
	Pose pose;
	pose.orientations.resize(p_rig.size());
	return fixtures::state_of(p_rig, pose);
}

} // namespace

TEST(leaves_ordinary_motion_alone) {
	const Rig rig(fixtures::limbs());
	RigState state = resting(rig);
	for (Vec3 &velocity : state.linear) {
		velocity = { 10.0f, 0.0f, 0.0f };
	}
	state.angular[2] = { 20.0f, 0.0f, 0.0f };
	const RigState before = state;
	CHECK(EnergyGuard().check(rig, state) == GUARD_NOTHING);
	CHECK_NEAR(state.angular[2].x, before.angular[2].x, 0.0);
	// Half of 0.2 kg m^2 times 20 squared; the common speed does not count.
	CHECK_NEAR(EnergyGuard::internal_energy(rig, state), 40.0, 1e-2);
}

TEST(bounds_the_energy_and_keeps_the_momentum) {
	const Rig rig(fixtures::limbs());
	std::mt19937 random(7);
	std::normal_distribution<float> normal(0.0f, 500.0f);
	for (int round = 0; round < 100; round++) {
		RigState state = resting(rig);
		Vec3 before;
		for (std::size_t i = 0; i < rig.size(); i++) {
			state.linear[i] = { normal(random) * 0.1f, normal(random), normal(random) };
			state.angular[i] = { normal(random), normal(random), normal(random) };
			before = before + state.linear[i] * 10.0f;
		}
		EnergyGuard guard;
		guard.max_speed = 1e6f;
		CHECK((guard.check(rig, state) & GUARD_ENERGY) != 0);
		CHECK(EnergyGuard::internal_energy(rig, state) <= 60.0f * 40.0f * 1.01f);
		Vec3 after;
		for (std::size_t i = 0; i < rig.size(); i++) {
			after = after + state.linear[i] * 10.0f;
		}
		CHECK_NEAR((after - before).length(), 0.0, 1.0);
	}
}

TEST(bounds_the_speed_of_the_whole) {
	const Rig rig(fixtures::limbs());
	RigState state = resting(rig);
	for (Vec3 &velocity : state.linear) {
		velocity = { 0.0f, 1000.0f, 0.0f };
	}
	CHECK(EnergyGuard().check(rig, state) == GUARD_SPEED);
	CHECK_NEAR(state.linear[3].y, 60.0, 1e-3);
}

TEST(puts_a_torn_limb_back) {
	const Rig rig(fixtures::limbs());
	RigState state = resting(rig);
	const Vec3 right = state.centres[3];
	state.centres[3] = right + Vec3{ 2.0f, 0.0f, 0.0f };
	CHECK(EnergyGuard().check(rig, state) == GUARD_GAP);
	CHECK_NEAR((state.centres[3] - right).length(), 0.0, 1e-5);
}

TEST(says_when_a_state_is_lost) {
	const Rig rig(fixtures::limbs());
	RigState state = resting(rig);
	state.angular[1].y = std::numeric_limits<float>::quiet_NaN();
	CHECK(EnergyGuard().check(rig, state) == GUARD_LOST);
}

TEST(torques_hold_a_limb_against_gravity) {
	const Rig rig(fixtures::limbs());
	Pose pose;
	// Everything lies level along X: limb 2's centre is 0.25 m from its joint.
	pose.orientations.assign(rig.size(), exp({ 0.0f, 0.0f, -3.14159265f / 2 }));
	RigState state = fixtures::state_of(rig, pose);
	TorqueMeter meter(rig.size());
	meter.note(rig, state, 0.01f);
	CHECK_NEAR(meter.get_torques()[2], 10.0 * 9.81 * 0.25, 1e-2);
	CHECK_NEAR(meter.get_torques()[1], 10.0 * 9.81 * (0.25 + 0.75 + 0.75), 1e-1);
	state.gravity = { 0.0f, -1.62f, 0.0f };
	meter.note(rig, state, 0.01f);
	CHECK_NEAR(meter.get_torques()[2], 10.0 * 1.62 * 0.25, 1e-2);
	state.gravity = {};
	meter.note(rig, state, 0.01f);
	CHECK_NEAR(meter.get_torques()[2], 0.0, 1e-4);
}

TEST(torques_speed_a_limb_up) {
	const Rig rig(fixtures::limbs());
	RigState state = resting(rig);
	state.gravity = {};
	TorqueMeter meter(rig.size());
	meter.note(rig, state, 0.01f);
	// Limb 2 begins to turn about its joint with 10 rad/s^2.
	state.angular[2] = { 0.1f, 0.0f, 0.0f };
	state.linear[2] = { 0.0f, 0.0f, 0.1f * 0.25f };
	meter.note(rig, state, 0.01f);
	CHECK_NEAR(meter.get_torques()[2], 10.0 * (0.2 + 10.0 * 0.25 * 0.25), 1e-2);
	CHECK_NEAR(meter.get_torques()[3], 0.0, 1e-3);
}

} // namespace test_guard
