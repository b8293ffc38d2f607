// SPDX-License-Identifier: MIT
#include <check.hpp>
#include <skeleton.hpp>

namespace test_skeleton {

using namespace kinematics;

namespace {

constexpr float QUARTER = 1.57079632679f;

Skeleton arm() {
	Skeleton skeleton;
	skeleton.limb_count = 3;
	skeleton.parents[0] = -1;
	for (std::size_t i = 1; i < 3; i++) {
		skeleton.parents[i] = int(i) - 1;
		skeleton.joints_in_parent[i] = { 0.5f, 0.0f, 0.0f };
		skeleton.joints_in_limb[i] = { -0.5f, 0.0f, 0.0f };
	}
	return skeleton;
}

} // namespace

TEST(a_straight_chain_is_placed_end_to_end) {
	PersonPose pose;
	pose.root = { 1.0f, 2.0f, 3.0f };
	std::array<Vec3, MAX_LIMBS> positions;
	position_limbs(arm(), pose, positions);
	CHECK_NEAR(positions[2].x, 3.0, 1e-6);
	CHECK_NEAR(positions[2].y, 2.0, 1e-6);
}

TEST(a_bent_joint_stays_closed) {
	PersonPose pose;
	pose.orientations[1] = exp({ 0.0f, 0.0f, QUARTER });
	pose.orientations[2] = exp({ 0.0f, QUARTER, 0.0f });
	std::array<Vec3, MAX_LIMBS> positions;
	const Skeleton skeleton = arm();
	position_limbs(skeleton, pose, positions);
	for (std::size_t i = 1; i < 3; i++) {
		const Vec3 outer = positions[i - 1] + pose.orientations[i - 1].rotate(skeleton.joints_in_parent[i]);
		const Vec3 inner = positions[i] + pose.orientations[i].rotate(skeleton.joints_in_limb[i]);
		CHECK_NEAR((outer - inner).length(), 0.0, 1e-6);
	}
	CHECK_NEAR(positions[1].y, 0.5, 1e-6);
}

TEST(a_skeleton_whose_parents_come_late_is_none) {
	CHECK(arm().is_sound());
	Skeleton wrong = arm();
	wrong.parents[1] = 2;
	CHECK(!wrong.is_sound());
	wrong = arm();
	wrong.parents[0] = 0;
	CHECK(!wrong.is_sound());
	wrong.limb_count = 0;
	CHECK(!wrong.is_sound());
}

} // namespace test_skeleton
