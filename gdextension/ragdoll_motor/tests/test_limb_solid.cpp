// SPDX-License-Identifier: MIT
#include "whole_body.hpp"

#include "clearance/limb_solid.hpp"
#include "clearance/two_bone_chain.hpp"

#include "check.hpp"

#include <random>

namespace test_limb_solid {

using namespace ragdoll;
using namespace whole_body;

namespace {

constexpr int SAMPLES = 2000;

Vec3 draw(std::mt19937 &r_random, float p_most) {
	std::uniform_real_distribution<float> part(-p_most, p_most);
	return { part(r_random), part(r_random), part(r_random) };
}

/// A solid alone, anywhere.
LimbSolid make_solid(const LimbShape &p_shape, const Quat &p_orientation, const Vec3 &p_joint) {
	Segment limb;
	limb.centre = { 0.1f, 0.0f, 0.0f };
	limb.shape = p_shape;
	LimbSolid solid(Rig({ limb }), 0);
	solid.place(p_orientation, p_joint);
	solid.turn_axes(p_orientation);
	return solid;
}

} // namespace

TEST(an_axis_comes_nearest_to_a_solid_where_its_points_do) {
	std::mt19937 random(1);
	for (int number = 0; number < 500; number++) {
		const LimbShape shape = number % 2 == 0 ? box({ 0.36f, 0.34f, 0.2f }) : pill(0.08f, 0.3f, true);
		const LimbSolid solid = make_solid(shape, exp(draw(random, 1.5f)), draw(random, 0.1f));
		const SolidAxis axis{ draw(random, 0.6f), draw(random, 0.6f) };
		const Approach found = approach_axis(axis, AxisFreedom(), solid, solid.get_axis());
		float least = 1e9f;
		for (int sample = 0; sample <= SAMPLES; sample++) {
			const Vec3 point = axis.at(float(sample) / float(SAMPLES));
			least = std::min(least, approach_point(point, solid, solid.get_axis()).distance);
		}
		if (least > 0.001f) {
			CHECK(std::fabs(found.distance - least) < 0.001f);
			CHECK(std::fabs(found.normal.length() - 1.0f) < 1e-3f);
		} else {
			CHECK(found.distance < 0.002f);
		}
	}
}

TEST(an_axis_that_is_pushed_out_as_told_is_out) {
	std::mt19937 random(2);
	for (int number = 0; number < 500; number++) {
		const LimbShape shape = number % 2 == 0 ? box({ 0.36f, 0.34f, 0.2f }) : pill(0.08f, 0.3f, true);
		const LimbSolid solid = make_solid(shape, exp(draw(random, 1.5f)), draw(random, 0.1f));
		SolidAxis axis{ draw(random, 0.15f), draw(random, 0.4f) };
		const Approach found = approach_axis(axis, AxisFreedom(), solid, solid.get_axis());
		if (found.distance < 0.0f) {
			axis.from = axis.from - found.normal * (found.distance - 0.001f);
			CHECK(approach_axis(axis, AxisFreedom(), solid, solid.get_axis()).distance > 0.0f);
		}
	}
}

TEST(arms_and_legs_are_chains) {
	const std::vector<TwoBoneChain> chains = find_chains(Rig(limbs()));
	CHECK(chains.size() == 4);
	for (const TwoBoneChain &chain : chains) {
		CHECK(chain.lower == chain.upper + 1 && chain.end == chain.lower + 1);
		CHECK(chain.is_leg == (chain.upper >= LEFT_UPPER_LEG));
	}
}

TEST(a_clavicle_and_fingers_are_no_part_of_an_arm) {
	std::vector<Segment> body = limbs();
	// A clavicle between chest and arm, and two fingers.
	Segment clavicle = body[LEFT_UPPER_ARM];
	clavicle.group = 2;
	body.insert(body.begin() + LEFT_UPPER_ARM, clavicle);
	for (std::size_t i = LEFT_UPPER_ARM + 1; i < body.size(); i++) {
		body[i].parent += body[i].parent >= LEFT_UPPER_ARM ? 1 : 0;
	}
	body[LEFT_UPPER_ARM + 1].parent = LEFT_UPPER_ARM;
	for (int finger = 0; finger < 2; finger++) {
		body.push_back(body[LEFT_HAND + 1]);
		body.back().parent = LEFT_HAND + 1;
	}
	const std::vector<TwoBoneChain> chains = find_chains(Rig(body));
	CHECK(chains.size() == 4);
	CHECK(chains[0].upper == LEFT_UPPER_ARM + 1 && chains[0].end == LEFT_HAND + 1);
}

TEST(turned_limbs_bring_their_joints_to_where_they_are_shifted) {
	std::mt19937 random(3);
	const Rig rig(limbs());
	const TwoBoneChain chain{ LEFT_UPPER_ARM, LEFT_LOWER_ARM, LEFT_HAND, false };
	for (int number = 0; number < 200; number++) {
		Pose pose = rest();
		for (Quat &orientation : pose.orientations) {
			orientation = exp(draw(random, 1.0f));
		}
		std::vector<Vec3> before;
		rig.joint_positions(pose, before);
		ChainShift shift{ draw(random, 0.15f), draw(random, 0.2f) };
		keep_lengths(before[chain.lower] - before[chain.upper], before[chain.end] - before[chain.lower], shift);
		turn_chain(rig, chain, shift, pose);
		std::vector<Vec3> after;
		rig.joint_positions(pose, after);
		CHECK((after[chain.lower] - before[chain.lower] - shift.middle).length() < 1e-3f);
		CHECK((after[chain.end] - before[chain.end] - shift.end).length() < 1e-3f);
	}
}

TEST(a_bent_elbow_turns_about_its_hinge) {
	const Rig rig(limbs());
	Pose pose = rest();
	// The forearm points ahead: the elbow's hinge is upright.
	pose.orientations[LEFT_LOWER_ARM] = exp({ 0.0f, -1.3f, 0.0f });
	const TwoBoneChain chain{ LEFT_UPPER_ARM, LEFT_LOWER_ARM, LEFT_HAND, false };
	std::vector<Vec3> joints;
	rig.joint_positions(pose, joints);
	ChainShift shift{ {}, { 0.0f, 0.08f, 0.0f } };
	keep_lengths(joints[chain.lower] - joints[chain.upper], joints[chain.end] - joints[chain.lower], shift);
	turn_chain(rig, chain, shift, pose);
	const Quat elbow = pose.orientations[LEFT_UPPER_ARM].inverse() * pose.orientations[LEFT_LOWER_ARM];
	const Vec3 turn = log(elbow);
	// Raising the wrist turns the upper arm about its length, not the elbow sideways.
	CHECK(std::fabs(turn.z) < 0.1f && std::fabs(turn.x) < 0.1f);
	CHECK(angle_between(pose.orientations[LEFT_UPPER_ARM], Quat()) > 0.2f);
}

} // namespace test_limb_solid
