// SPDX-License-Identifier: MIT
#include "balance/balance.hpp"
#include "state_of.hpp"

#include "check.hpp"

#include <algorithm>
#include <vector>

namespace test_balance {

namespace {

using fixtures::state_of;
using ragdoll::Balance;
using ragdoll::BalanceInput;
using ragdoll::BalanceSettings;
using ragdoll::Pose;
using ragdoll::Quat;
using ragdoll::Recovery;
using ragdoll::Rig;
using ragdoll::RigState;
using ragdoll::Vec3;

constexpr float STEP = 1.0f / 60.0f;

/// Hips, a trunk, and two legs of three limbs: indices 0, 1, 2 to 4 (left), 5 to 7 (right).
std::vector<ragdoll::Segment> limbs() {
	std::vector<ragdoll::Segment> result(8);
	const int parents[8] = { -1, 0, 0, 2, 3, 0, 5, 6 };
	const float masses[8] = { 12.0f, 40.0f, 8.0f, 4.0f, 1.0f, 8.0f, 4.0f, 1.0f };
	for (int i = 0; i < 8; i++) {
		result[i].parent = parents[i];
		result[i].mass = masses[i];
		result[i].inertia = { 0.1f, 0.1f, 0.1f };
		result[i].max_torque = 300.0f;
		result[i].centre = { 0.0f, -0.2f, 0.0f };
	}
	result[1].centre = { 0.0f, 0.3f, 0.0f };
	for (int hip : { 2, 5 }) {
		result[hip].anchor = { hip == 2 ? 0.1f : -0.1f, 0.0f, 0.0f };
		result[hip + 1].anchor = { 0.0f, -0.45f, 0.01f };
		result[hip + 2].anchor = { 0.0f, -0.45f, -0.01f };
		result[hip + 2].centre = { 0.0f, -0.05f, 0.08f };
		result[hip + 2].is_foot = true;
	}
	return result;
}

std::vector<ragdoll::ContactPoint> soles() {
	return { { 4, { 0.0f, -0.09f, -0.05f }, 0.01f, true }, { 4, { 0.0f, -0.09f, 0.15f }, 0.01f, true },
		{ 7, { 0.0f, -0.09f, -0.05f }, 0.01f, true }, { 7, { 0.0f, -0.09f, 0.15f }, 0.01f, true } };
}

Pose standing() {
	Pose pose;
	pose.orientations.resize(8);
	pose.root = { 0.0f, 1.0f, 0.0f };
	return pose;
}

/// The same with hips that lean forwards, rad.
Pose leaning(float p_angle) {
	Pose pose = standing();
	pose.orientations[0] = ragdoll::exp({ p_angle, 0.0f, 0.0f });
	return pose;
}

/// Level ground, and something loose under the left foot.
class Crate : public ragdoll::FlatGround {
public:
	explicit Crate(float p_top) : _top(p_top) {}
	ragdoll::Footing find(const Vec3 &p_at, float /*p_above*/) const override {
		ragdoll::Footing found;
		found.is_loose = p_at.x > 0.0f;
		found.height = found.is_loose ? _top : 0.0f;
		return found;
	}

private:
	float _top;
};

/// A tread ahead of a place along Z, level ground before it.
class Tread : public ragdoll::FlatGround {
public:
	Tread(float p_from, float p_height) : _from(p_from), _height(p_height) {}
	ragdoll::Footing find(const Vec3 &p_at, float /*p_above*/) const override {
		ragdoll::Footing found;
		found.height = p_at.z > _from ? _height : 0.0f;
		return found;
	}

private:
	float _from;
	float _height;
};

/// A balance with its body and what it makes of the poses.
struct Stand {
	Rig rig{ limbs() };
	Balance balance{ rig, soles() };
	ragdoll::FlatGround ground;
	const ragdoll::Ground *under = &ground;
	Pose now = standing();
	Pose next = standing();
	/// How far the left foot swings ahead in a step, by its thigh, rad.
	float swing_by = 0.0f;

	void step(const RigState &p_state) {
		now = standing();
		next = standing();
		next.orientations[2] = ragdoll::exp({ -swing_by, 0.0f, 0.0f });
		BalanceInput input;
		input.state = &p_state;
		input.ground = under;
		input.delta_s = STEP;
		balance.advance(rig, input, now, next);
	}
	/// Height of the lowest point of a foot's sole in the pose that was made, m.
	float sole(std::size_t p_foot) {
		std::vector<Vec3> joints;
		rig.joint_positions(now, joints);
		return joints[p_foot].y - 0.1f;
	}
};

} // namespace

TEST(leaves_a_body_alone_that_stands_as_the_motion_does) {
	Stand stand;
	const RigState state = state_of(stand.rig, standing());
	for (int i = 0; i < 120; i++) {
		stand.step(state);
	}
	CHECK(stand.balance.get_force().length() < 1e-3f);
	CHECK(!stand.balance.is_stepping());
	CHECK(ragdoll::angle_between(stand.now.orientations[2], Quat()) < 1e-3f);
	CHECK(stand.balance.get_recovery().get_phase() == Recovery::Phase::NONE);
}

TEST(never_pushes_with_more_than_its_share_of_the_weight_nor_upwards) {
	Stand stand;
	for (int i = 0; i < 60; i++) {
		stand.step(state_of(stand.rig, standing(), { 0.4f, -2.0f, 0.1f }));
		const Vec3 force = stand.balance.get_force();
		CHECK(force.length() <= 0.06f * stand.rig.get_mass() * 9.81f + 1e-3f);
		CHECK(force.y == 0.0f);
	}
	CHECK(stand.balance.get_force().x < 0.0f); // It brakes.
}

TEST(sinks_its_torque_when_the_feet_rest) {
	Stand stand;
	const RigState state = state_of(stand.rig, standing());
	stand.step(state);
	CHECK_NEAR(stand.balance.get_torque(), stand.balance.settings.hold_torque, 1e-3);
	stand.step(state_of(stand.rig, leaning(0.5f)));
	CHECK_NEAR(stand.balance.get_torque(), stand.balance.settings.torque, 1e-3);
	for (int i = 0; i < 60; i++) {
		stand.step(state);
	}
	// At ease as the hips lean, up to what holds somebody who stands.
	const BalanceSettings &settings = stand.balance.settings;
	for (const float lean : { 0.0f, 0.003f, 0.2f }) {
		stand.step(state_of(stand.rig, leaning(lean)));
		const float most = settings.quiet_torque + settings.quiet_stiffness * lean;
		CHECK_NEAR(stand.balance.get_torque(), std::min(most, settings.standing_torque), 0.1);
	}
}

TEST(leaves_who_is_knocked_to_the_feet_for_a_moment) {
	for (const float speed : { 0.6f, 2.0f }) { // A ball's blow, and a shove of 160 N s.
		Stand stand;
		for (int i = 0; i < 10; i++) {
			stand.step(state_of(stand.rig, leaning(0.05f)));
		}
		const float usual = stand.balance.get_torque();
		stand.step(state_of(stand.rig, leaning(0.05f), { speed, 0.0f, 0.0f }));
		const float knocked = stand.balance.settings.knocked_torque;
		CHECK(speed < 1.0f ? stand.balance.get_torque() > 2.0f * knocked : stand.balance.get_torque() <= knocked);
		CHECK(usual > 2.0f * knocked);
		for (int i = 0; i < 60; i++) {
			stand.step(state_of(stand.rig, leaning(0.05f)));
		}
		CHECK(stand.balance.get_torque() > 2.0f * knocked);
	}
}

TEST(who_speeds_up_slowly_is_not_knocked) {
	Stand stand;
	for (int i = 0; i < 120; i++) {
		stand.step(state_of(stand.rig, leaning(0.05f), { 0.03f * float(i), 0.0f, 0.0f }));
		CHECK(stand.balance.get_torque() > stand.balance.settings.knocked_torque);
	}
}

TEST(who_has_sunk_on_one_leg_lifts_the_other_as_far) {
	for (const float sunk : { 0.0f, 0.01f, 0.08f, 0.15f }) {
		Stand stand;
		stand.step(state_of(stand.rig, standing()));
		stand.swing_by = 0.06f;
		Pose lower = standing();
		lower.root.y -= sunk;
		for (int i = 0; i < 3; i++) {
			stand.step(state_of(stand.rig, lower));
		}
		const BalanceSettings &settings = stand.balance.settings;
		const float lifted = std::clamp(sunk - settings.sunk_slack, 0.0f, settings.sunk_most);
		CHECK_NEAR(stand.sole(4), lifted, 5e-3);
		CHECK_NEAR(stand.sole(7), 0.0, 5e-3);
	}
}

TEST(takes_a_step_towards_where_a_push_drives_it) {
	Stand stand;
	const RigState still = state_of(stand.rig, standing());
	for (int i = 0; i < 60; i++) {
		stand.step(still);
	}
	const RigState pushed = state_of(stand.rig, standing(), { 0.0f, 0.0f, 1.2f });
	bool stepped = false;
	float furthest = 0.0f;
	float highest = 0.0f;
	for (int i = 0; i < 15; i++) {
		stand.step(pushed);
		stepped = stepped || stand.balance.is_stepping();
		std::vector<Vec3> joints;
		stand.rig.joint_positions(stand.now, joints);
		furthest = std::max({ furthest, joints[4].z, joints[7].z });
		highest = std::max({ highest, stand.sole(4), stand.sole(7) });
	}
	CHECK(stepped);
	CHECK(furthest > 0.1f);
	CHECK(highest > 0.03f);
}

TEST(a_foot_stands_on_the_ground_under_it) {
	Stand stand;
	stand.ground = ragdoll::FlatGround(0.15f);
	Pose high = standing();
	high.root.y += 0.15f;
	const RigState state = state_of(stand.rig, high);
	for (int i = 0; i < 120; i++) {
		stand.step(state);
	}
	CHECK_NEAR(stand.sole(4), 0.15f, 0.01f);
	CHECK_NEAR(stand.sole(7), 0.15f, 0.01f);
}

TEST(a_foot_whose_ball_is_over_a_step_stands_on_it) {
	// Ankles are at z = 0, balls 0.15 m ahead: the whole foot comes onto the tread, or it would be in it.
	for (const float from : { 0.1f, 0.2f }) {
		Stand stand;
		const Tread tread(from, 0.17f);
		stand.under = &tread;
		const RigState state = state_of(stand.rig, standing());
		for (int i = 0; i < 120; i++) {
			stand.step(state);
		}
		CHECK_NEAR(stand.sole(4), from < 0.15f ? 0.17f : 0.0f, 0.01f);
	}
}

TEST(a_foot_in_the_air_clears_the_riser_that_comes_next) {
	// The left foot swings ahead with 2 m/s; its toes are 0.15 m before its ankle, which will be 0.2 m ahead.
	for (const float rise : { 0.0f, 0.17f }) {
		Stand stand;
		const Tread tread(0.42f, rise);
		stand.under = &tread;
		const RigState state = state_of(stand.rig, standing());
		stand.step(state);
		for (int i = 0; i < 6; i++) {
			stand.swing_by = 0.06f;
			stand.step(state);
		}
		CHECK_NEAR(stand.sole(4), rise > 0.0f ? rise + stand.balance.settings.foothold.clearance : 0.0f, 0.02f);
	}
}

TEST(on_a_slope_a_foot_stands_under_its_ankle) {
	Stand stand;
	const Tread low(0.1f, 0.05f);
	stand.under = &low;
	const RigState state = state_of(stand.rig, standing());
	for (int i = 0; i < 60; i++) {
		stand.step(state);
	}
	CHECK_NEAR(stand.sole(4), 0.0f, 0.01f);
}

TEST(what_is_loose_and_high_is_kicked_aside) {
	for (const float top : { 0.1f, 0.5f }) {
		Stand stand;
		const Crate crate(top);
		stand.under = &crate;
		const RigState state = state_of(stand.rig, standing());
		for (int i = 0; i < 60; i++) {
			stand.step(state);
		}
		CHECK_NEAR(stand.sole(4), top < 0.4f ? top : 0.0f, 0.02f);
	}
}

TEST(who_falls_bends_the_knees) {
	Stand stand;
	Pose tipped = standing();
	for (Quat &limb : tipped.orientations) {
		limb = ragdoll::exp({ 1.0f, 0.0f, 0.0f });
	}
	stand.step(state_of(stand.rig, standing()));
	for (int i = 0; i < 20; i++) {
		stand.step(state_of(stand.rig, tipped, { 0.0f, -1.0f, 1.0f }));
	}
	CHECK(stand.balance.get_recovery().get_phase() == Recovery::Phase::FALLING);
	CHECK(ragdoll::angle_between(stand.now.orientations[2], stand.now.orientations[3]) > 0.5f);
}

TEST(the_motions_place_gives_in_where_the_feet_are_held_back) {
	Stand stand;
	Pose held = standing();
	held.root.x -= 0.5f;
	stand.step(state_of(stand.rig, standing()));
	for (int i = 0; i < 30; i++) {
		stand.step(state_of(stand.rig, held));
	}
	CHECK_NEAR(stand.balance.get_offset().x, -0.5f, 0.1f);
}

TEST(falls_lies_and_gets_up) {
	Stand stand;
	Pose lying = standing();
	for (Quat &limb : lying.orientations) {
		limb = ragdoll::exp({ 1.5f, 0.0f, 0.0f });
	}
	lying.root.y = 0.15f;
	stand.step(state_of(stand.rig, standing()));
	std::vector<Recovery::Phase> phases;
	for (int i = 0; i < 400; i++) {
		const bool rolled = phases.size() > 2 && phases.back() == Recovery::Phase::ROLLING;
		const bool rises = !phases.empty() && phases.back() == Recovery::Phase::RISING;
		// The body follows as soon as the crouch is wanted, and stays down before.
		Pose shown = rolled || rises ? stand.now : lying;
		const bool falls = !phases.empty() && phases.back() == Recovery::Phase::FALLING;
		stand.step(state_of(stand.rig, shown, falls ? Vec3{ 2.0f, 0.0f, 0.0f } : Vec3()));
		const Recovery::Phase phase = stand.balance.get_recovery().get_phase();
		if (phases.empty() || phases.back() != phase) {
			phases.push_back(phase);
		}
		if (phases.size() > 4 && phase == Recovery::Phase::NONE) {
			break;
		}
		CHECK(stand.balance.get_force().length() == 0.0f); // No force lifts it.
	}
	const std::vector<Recovery::Phase> expected = { Recovery::Phase::FALLING, Recovery::Phase::TUCKING,
		Recovery::Phase::ROLLING, Recovery::Phase::RISING, Recovery::Phase::NONE };
	CHECK(phases == expected);
	// His fall is no knock any more, and he is held as who stands, not as who walks.
	CHECK(stand.balance.get_torque() <= stand.balance.settings.standing_torque);
	CHECK(stand.balance.get_torque() > stand.balance.settings.knocked_torque);
}

TEST(goes_on_the_same_from_a_saved_state) {
	Stand first;
	for (int i = 0; i < 50; i++) {
		first.step(state_of(first.rig, standing(), { 0.0f, 0.0f, 0.02f * float(i) }));
	}
	ragdoll::ArchiveWriter archive;
	first.balance.save(archive);
	Stand second;
	ragdoll::ArchiveReader reader(archive.get_bytes().data(), archive.get_bytes().size());
	CHECK(second.balance.restore(reader));
	for (int i = 0; i < 20; i++) {
		const RigState state = state_of(first.rig, standing(), { 0.1f, 0.0f, 0.9f });
		first.step(state);
		second.step(state);
		CHECK(first.balance.get_force().z == second.balance.get_force().z);
		CHECK(first.now.orientations[2].x == second.now.orientations[2].x);
	}
}

} // namespace test_balance
