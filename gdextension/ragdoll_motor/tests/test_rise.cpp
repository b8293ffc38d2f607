// SPDX-License-Identifier: MIT
#include "balance/rise.hpp"
#include "person.hpp"

#include "check.hpp"

#include <cmath>
#include <set>
#include <vector>

namespace test_rise {

using namespace ragdoll;

namespace {

constexpr float STEP = 1.0f / 60.0f;
constexpr float RIGHT_ANGLE = 0.5f * PI;
constexpr float GRAVITY = 9.81f;

/// Somebody who lies, and whose limbs do what is wanted or nothing.
struct Lying {
	Rig rig{ person::limbs() };
	Rise rise{ rig, find_legs(rig, person::soles()), find_arms(rig) };
	Pose motion = person::turned(Quat());
	Pose shown;

	explicit Lying(const Quat &p_turn) : shown(person::turned(p_turn)) {
		rise.begin(rig, person::state_of(rig, shown), false);
	}
	void step(bool p_follows) {
		const RigState state = person::state_of(rig, shown);
		rise.advance(rig, state, motion, GRAVITY, STEP);
		Pose wanted = motion;
		rise.bend(rig, STEP, wanted);
		shown = p_follows ? wanted : shown;
	}
};

const Quat FACE_DOWN = exp({ RIGHT_ANGLE, 0.0f, 0.0f });
const Quat FACE_UP = exp({ -RIGHT_ANGLE, 0.0f, 0.0f });

} // namespace

TEST(the_way_up_suits_how_the_body_lies) {
	CHECK(Lying(FACE_DOWN).rise.get_lie() == Lie::FACE_DOWN);
	CHECK(Lying(FACE_UP).rise.get_lie() == Lie::FACE_UP);
	CHECK(Lying(exp({ 0.0f, 0.0f, RIGHT_ANGLE })).rise.get_lie() == Lie::RIGHT_SIDE);
	CHECK(Lying(exp({ 0.0f, 0.0f, -RIGHT_ANGLE })).rise.get_lie() == Lie::LEFT_SIDE);
	// Wherever the head points.
	const Quat elsewhere = exp({ 0.0f, 2.0f, 0.0f });
	CHECK(Lying(elsewhere * FACE_DOWN).rise.get_lie() == Lie::FACE_DOWN);
	// On a side, but looking up a little.
	const Quat to_back = exp({ 0.0f, 0.0f, -RIGHT_ANGLE }) * exp({ 0.0f, -0.5f, 0.0f });
	const Lie lie = Lying(to_back).rise.get_lie();
	CHECK(lie == Lie::LEFT_BACK || lie == Lie::LEFT_SIDE);
}

TEST(who_kneels_does_not_sit_up) {
	Lying kneels(Quat{});
	for (const int shin : { person::LEFT_SHIN, person::RIGHT_SHIN }) {
		kneels.shown.orientations[std::size_t(shin)] = exp({ RIGHT_ANGLE, 0.0f, 0.0f });
		kneels.shown.orientations[std::size_t(shin) + 1] = exp({ RIGHT_ANGLE, 0.0f, 0.0f });
	}
	kneels.rise.begin(kneels.rig, person::state_of(kneels.rig, kneels.shown), false);
	CHECK(kneels.rise.get_lie() == Lie::KNEELS);
}

TEST(a_body_that_follows_comes_up_in_time) {
	for (const Quat &turn : { FACE_DOWN, exp({ 0.0f, 0.0f, RIGHT_ANGLE }), exp({ 0.0f, 0.0f, -RIGHT_ANGLE }) }) {
		Lying lying(turn);
		std::vector<RisePart> parts;
		float time_s = 0.0f;
		while (!lying.rise.is_done() && time_s < 4.0f) {
			lying.step(true);
			time_s += STEP;
			const RisePart part = lying.rise.get_stage().part;
			if (parts.empty() || parts.back() != part) {
				parts.push_back(part);
			}
		}
		CHECK(lying.rise.is_done());
		CHECK(parts.front() == RisePart::TUCKING);
		CHECK(parts.back() == RisePart::RISING);
	}
}

TEST(the_end_is_the_motions_pose) {
	Lying lying(FACE_DOWN);
	lying.motion = person::turned(exp({ 0.0f, 1.0f, 0.0f }));
	lying.motion.orientations[person::LEFT_ARM] = exp({ 0.5f, 0.0f, 0.0f });
	for (int i = 0; i < 400 && !lying.rise.is_done(); i++) {
		lying.step(true);
	}
	CHECK(lying.rise.is_done());
	const auto joint = [](const Pose &p_pose) {
		return p_pose.orientations[person::SPINE].inverse() * p_pose.orientations[person::LEFT_ARM];
	};
	CHECK(angle_between(joint(lying.shown), joint(lying.motion)) < 0.05f);
}

TEST(who_straightens_up_has_the_weight_over_the_feet) {
	Lying lying(FACE_DOWN);
	lying.motion = person::turned(Quat());
	int steps = 0;
	for (int i = 0; i < 400 && !lying.rise.is_done(); i++) {
		lying.step(true);
		if (lying.rise.get_stage().part != RisePart::RISING || lying.rise.is_done()) {
			continue;
		}
		std::vector<Vec3> joints(lying.rig.size());
		lying.rig.joint_positions(lying.shown, joints);
		Vec3 feet;
		for (const int foot : { person::LEFT_FOOT, person::RIGHT_FOOT }) {
			const Vec3 centre = lying.shown.orientations[std::size_t(foot)].rotate(lying.rig[std::size_t(foot)].centre);
			feet = feet + (joints[std::size_t(foot)] + centre) * 0.5f;
		}
		steps++;
		if (steps > 20) { // By then what the body brought along is gone for the most part.
			CHECK(std::fabs((lying.rig.centre_of_mass(lying.shown, joints) - feet).z) < 0.15f);
		}
	}
	CHECK(steps > 20);
}

TEST(the_help_is_limited_as_a_vector) {
	Lying lying(exp({ 0.3f, 0.0f, RIGHT_ANGLE }));
	float most = 0.0f;
	for (int i = 0; i < 30; i++) {
		lying.step(false);
		CHECK(lying.rise.get_help().length() <= lying.rise.get_most_help() + 1e-3f);
		most = std::max(most, lying.rise.get_help().length());
	}
	CHECK(most > 10.0f);
}

TEST(who_cannot_move_tries_again_and_is_helped_more) {
	Lying lying(FACE_UP);
	std::set<float> limits;
	float last = 0.0f;
	for (int i = 0; i < 1200; i++) {
		lying.step(false);
		const float limit = lying.rise.get_most_help() / std::max(lying.rise.get_stage().torque, 1.0f);
		CHECK(limit >= last || limit == 1.0f);
		last = limit;
		limits.insert(limit);
	}
	CHECK(!lying.rise.is_done());
	CHECK(limits.size() > 2);
	CHECK(*limits.rbegin() <= 4.0f);
}

TEST(goes_on_the_same_from_a_saved_state) {
	Lying first(FACE_DOWN);
	for (int i = 0; i < 40; i++) {
		first.step(true);
	}
	ArchiveWriter archive;
	first.rise.save(archive);
	Lying second(FACE_UP);
	ArchiveReader reader(archive.get_bytes().data(), archive.get_bytes().size());
	CHECK(second.rise.restore(reader));
	second.shown = first.shown;
	for (int i = 0; i < 60; i++) {
		first.step(true);
		second.step(true);
		CHECK(angle_between(first.shown.orientations[person::LEFT_ARM], second.shown.orientations[person::LEFT_ARM]) <
				1e-5f);
	}
}

} // namespace test_rise
