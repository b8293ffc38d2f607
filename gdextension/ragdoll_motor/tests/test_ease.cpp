// SPDX-License-Identifier: MIT
#include "balance/ease.hpp"

#include "check.hpp"

#include <cmath>
#include <vector>

namespace test_ease {

namespace {

using ragdoll::CompositeInertia;
using ragdoll::LimbCommand;
using ragdoll::Pose;
using ragdoll::Rig;
using ragdoll::RigState;
using ragdoll::Vec3;

constexpr float STEP = 1.0f / 60.0f;
constexpr float HERTZ = 1.5f;
constexpr float TORQUE = 200.0f;

/// Hips that are held, and a trunk on them which turns about X.
struct Trunk {
	Rig rig{ limbs() };
	CompositeInertia inertia{ 2 };
	RigState state;
	Pose now;
	Pose next;
	std::vector<LimbCommand> commands{ 2 };
	float angle = 0.0f;
	float speed = 0.0f;

	static std::vector<ragdoll::Segment> limbs() {
		std::vector<ragdoll::Segment> result(2);
		result[1].parent = 0;
		result[1].mass = 30.0f;
		result[1].centre = { 0.0f, 0.3f, 0.0f };
		result[1].inertia = { 1.0f, 1.0f, 1.0f };
		result[1].max_torque = TORQUE;
		return result;
	}

	Trunk() {
		state.resize(2);
		now.orientations.resize(2);
		next.orientations.resize(2);
	}

	/// Lets a step pass in which the motor does all that it is asked for and may, against a torque, N m.
	void step(float p_against = 0.0f) {
		state.orientations[1] = ragdoll::exp({ angle, 0.0f, 0.0f });
		state.angular[1] = { speed, 0.0f, 0.0f };
		state.centres[1] = state.orientations[1].rotate(rig[1].centre);
		inertia.find(rig, state);
		commands[1].mode = ragdoll::Actuation::VELOCITY_MOTOR;
		commands[1].max_torque = TORQUE;
		commands[1].velocity = {};
		ragdoll::ease_limbs(rig, inertia, state, now, next, 1.0f, HERTZ, STEP, commands);
		const float moment = inertia[1].x;
		const float wanted = (commands[1].velocity.x - speed) * moment / STEP + p_against;
		const float most = commands[1].max_torque;
		speed += (std::min(std::max(wanted, -most), most) - p_against) * STEP / moment;
		angle += speed * STEP;
	}
};

} // namespace

TEST(a_blow_turns_it_and_it_comes_back_once) {
	Trunk trunk;
	trunk.speed = 2.0f;
	float most = 0.0f;
	float least = 0.0f;
	for (int i = 0; i < 90; i++) {
		trunk.step();
		most = std::max(most, trunk.angle);
		least = std::min(least, trunk.angle);
	}
	CHECK(most > 0.04f && most < 0.3f);
	CHECK(least > -0.1f * most); // It does not swing through.
	CHECK(std::fabs(trunk.angle) < 0.01f);
}

TEST(what_is_held_aside_rests) {
	Trunk trunk;
	trunk.angle = 0.3f;
	float torque = 0.0f;
	for (int i = 0; i < 30; i++) {
		trunk.angle = 0.3f; // Something holds it there.
		trunk.speed = 0.0f;
		trunk.step();
		CHECK(torque == 0.0f || trunk.commands[1].max_torque == torque);
		torque = trunk.commands[1].max_torque;
	}
	CHECK(torque < TORQUE);
}

TEST(it_is_as_strong_on_its_way_there_as_on_its_way_back) {
	// Otherwise each touch would give it energy, and it would never rest.
	Trunk trunk;
	trunk.angle = 0.2f;
	trunk.step();
	const float resting = trunk.commands[1].max_torque;
	trunk.angle = 0.2f;
	trunk.speed = -1e-3f;
	trunk.step();
	CHECK_NEAR(trunk.commands[1].max_torque, resting, 0.01f * resting);
}

TEST(slow_motion_is_followed_without_lag) {
	Trunk trunk;
	for (int i = 0; i < 120; i++) {
		trunk.now.orientations[1] = ragdoll::exp({ 0.3f * float(i) * STEP, 0.0f, 0.0f });
		trunk.next.orientations[1] = ragdoll::exp({ 0.3f * float(i + 1) * STEP, 0.0f, 0.0f });
		trunk.step();
	}
	CHECK_NEAR(trunk.angle, 0.3f * 120.0f * STEP, 0.005f);
}

TEST(who_moves_fast_is_not_eased) {
	Trunk trunk;
	trunk.next.orientations[1] = ragdoll::exp({ 0.02f, 0.0f, 0.0f });
	trunk.step();
	CHECK(trunk.commands[1].max_torque == TORQUE);
}

} // namespace test_ease
