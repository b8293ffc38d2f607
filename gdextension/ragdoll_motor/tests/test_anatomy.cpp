// SPDX-License-Identifier: MIT
#include "balance/anatomy.hpp"
#include "person.hpp"

#include "check.hpp"

#include <cmath>

namespace test_anatomy {

using namespace ragdoll;

namespace {

constexpr float RIGHT_ANGLE = 0.5f * PI;

/// Where the limbs' joints and middles are in a pose by angles.
struct Posed {
	Rig rig{ person::limbs() };
	Anatomy anatomy{ rig, find_legs(rig, person::soles()), find_arms(rig) };
	Pose pose = person::turned(Quat());

	explicit Posed(const JointAngles &p_angles, float p_heading = 0.0f) {
		anatomy.pose(p_angles, exp({ 0.0f, p_heading, 0.0f }), pose.orientations);
	}
	/// From a limb's joint to that of the limb that hangs on it, or to its middle.
	Vec3 way(int p_limb, int p_child = -1) const {
		const Vec3 local = p_child < 0 ? rig[std::size_t(p_limb)].centre : rig[std::size_t(p_child)].anchor;
		const Vec3 way = pose.orientations[std::size_t(p_limb)].rotate(local);
		return way * (1.0f / way.length());
	}
};

void check_near(const Vec3 &p_is, const Vec3 &p_wanted) {
	CHECK((p_is - p_wanted).length() < 1e-3f);
}

} // namespace

TEST(arms_and_legs_hang_where_all_angles_are_0) {
	const Posed posed{ JointAngles() };
	CHECK(posed.anatomy.is_known());
	for (const int limb : { person::LEFT_ARM, person::LEFT_FOREARM, person::RIGHT_HAND, person::RIGHT_THIGH }) {
		check_near(posed.way(limb), { 0.0f, -1.0f, 0.0f });
	}
	check_near(posed.way(person::HEAD), { 0.0f, 1.0f, 0.0f });
	CHECK(posed.anatomy.is_foot(person::LEFT_FOOT) && !posed.anatomy.is_foot(person::LEFT_HAND));
}

TEST(limbs_bend_ahead_and_knees_back) {
	JointAngles angles;
	angles.thigh = { RIGHT_ANGLE, 0.0f };
	angles.knee = { RIGHT_ANGLE, 0.0f };
	angles.arm = { 0.0f, RIGHT_ANGLE };
	angles.elbow = { RIGHT_ANGLE, 0.0f };
	const Posed posed{ angles };
	check_near(posed.way(person::LEFT_THIGH, person::LEFT_SHIN), { 0.0f, 0.0f, 1.0f });
	check_near(posed.way(person::LEFT_SHIN, person::LEFT_FOOT), { 0.0f, -1.0f, 0.0f });
	check_near(posed.way(person::LEFT_FOREARM), { 0.0f, 0.0f, 1.0f });
	check_near(posed.way(person::RIGHT_ARM), { 0.0f, 0.0f, 1.0f });
	check_near(posed.way(person::RIGHT_THIGH), { 0.0f, -1.0f, 0.0f });
}

TEST(limbs_are_lifted_to_their_own_side) {
	JointAngles angles;
	angles.arm_out = { RIGHT_ANGLE, RIGHT_ANGLE };
	angles.thigh_out = { 0.0f, RIGHT_ANGLE };
	const Posed posed{ angles };
	check_near(posed.way(person::LEFT_ARM), { 1.0f, 0.0f, 0.0f });
	check_near(posed.way(person::RIGHT_ARM), { -1.0f, 0.0f, 0.0f });
	check_near(posed.way(person::RIGHT_THIGH), { -1.0f, 0.0f, 0.0f });
}

TEST(a_foot_points_where_its_toes_are) {
	JointAngles angles;
	angles.ankle = { 0.5f, -0.5f };
	const Posed posed{ angles };
	const auto toes = [&](int p_foot) {
		return posed.anatomy.get_toes(std::size_t(p_foot), posed.pose.orientations[std::size_t(p_foot)]);
	};
	CHECK_NEAR(toes(person::LEFT_FOOT).y, std::sin(0.5f), 1e-3f);
	CHECK_NEAR(toes(person::RIGHT_FOOT).y, -std::sin(0.5f), 1e-3f);
}

TEST(the_mirrored_pose_is_that_of_the_other_side) {
	JointAngles angles;
	angles.pitch = 0.4f;
	angles.knee = { 1.0f, 0.2f };
	angles.arm_out = { 0.3f, 0.7f };
	const Posed one{ angles };
	const Posed other{ angles.mirrored() };
	const Vec3 way = one.way(person::LEFT_SHIN);
	check_near(other.way(person::RIGHT_SHIN), { -way.x, way.y, way.z });
	const Vec3 arm = one.way(person::RIGHT_HAND);
	check_near(other.way(person::LEFT_HAND), { -arm.x, arm.y, arm.z });
}

TEST(a_heading_turns_all_of_it) {
	JointAngles angles;
	angles.pitch = RIGHT_ANGLE; // Face down, ...
	const Posed posed{ angles, RIGHT_ANGLE }; // ... the head towards X.
	check_near(posed.way(person::HEAD), { 1.0f, 0.0f, 0.0f });
	const Quat &hips = posed.pose.orientations[0];
	check_near(posed.anatomy.get_ahead(hips), { 0.0f, -1.0f, 0.0f });
	check_near(posed.anatomy.get_left(hips), { 0.0f, 0.0f, -1.0f });
	check_near(posed.anatomy.get_view(posed.anatomy.find_heading({ 1.0f, 0.0f, 0.0f })), { 1.0f, 0.0f, 0.0f });
	CHECK(angle_between(hips, posed.anatomy.get_hips(angles, exp({ 0.0f, RIGHT_ANGLE, 0.0f }))) < 1e-3f);
}

TEST(a_body_without_two_legs_is_not_known) {
	const Rig rig{ person::limbs() };
	CHECK(!Anatomy(rig, {}, find_arms(rig)).is_known());
}

} // namespace test_anatomy
