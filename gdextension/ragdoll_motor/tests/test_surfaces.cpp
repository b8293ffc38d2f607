// SPDX-License-Identifier: MIT
#include "fixtures.hpp"
#include "root/landing.hpp"
#include "root/surface_guard.hpp"

#include "check.hpp"

namespace test_surfaces {

using namespace ragdoll;

namespace {

constexpr float DELTA = 1.0f / 60.0f;

/// A floor without end at height 0, which may move up.
class Floor : public Obstacles {
public:
	bool is_in_way(std::size_t, const Quat &, const Vec3 &, const Vec3 &) const override { return false; }
	bool find_between(const Vec3 &p_from, const Vec3 &p_to, Hit &r_hit) const override {
		asked++;
		if (!(p_from.y > 0.0f && p_to.y < 0.0f)) {
			return false;
		}
		r_hit = { p_from.y / (p_from.y - p_to.y), { 0.0f, 1.0f, 0.0f }, { 0.0f, rises, 0.0f } };
		return true;
	}
	float rises = 0.0f; // m/s
	mutable int asked = 0;
};

RigState standing(const Rig &p_rig, float p_height, float p_fall) {
	Pose pose;
	pose.orientations.assign(p_rig.size(), Quat());
	pose.root = { 0.0f, p_height, 0.0f };
	RigState state = fixtures::state_of(p_rig, pose);
	for (Vec3 &limb : state.linear) {
		limb = { 1.0f, -p_fall, 0.0f };
	}
	return state;
}

float lowest_next(const RigState &p_state) {
	float lowest = 1e9f;
	for (std::size_t i = 0; i < p_state.centres.size(); i++) {
		lowest = std::min(lowest, p_state.centres[i].y + p_state.linear[i].y * DELTA);
	}
	return lowest;
}

} // namespace

TEST(who_falls_fast_comes_to_the_surface_and_no_further) {
	const Rig rig(fixtures::limbs());
	const Floor floor;
	const Landing landing;
	for (int i = 0; i < 30; i++) {
		RigState state = standing(rig, 0.05f * float(i), 31.0f);
		const bool is_slowed = landing.advance(rig, &floor, {}, DELTA, state);
		CHECK(lowest_next(state) > -Landing::SHORT_STEP);
		CHECK(is_slowed == (state.linear[0].y > -31.0f));
		CHECK_NEAR(state.linear[0].x, 1.0, 1e-5); // Along the surface nothing is lost.
		for (const Vec3 &limb : state.linear) {
			CHECK_NEAR(limb.y, state.linear[0].y, 1e-4); // The limbs are not torn apart.
		}
	}
}

TEST(nobody_is_slowed_who_falls_slowly_or_has_far_to_go_or_flies_along) {
	const Rig rig(fixtures::limbs());
	Floor floor;
	const Landing landing;
	RigState slow = standing(rig, 0.1f, 0.9f * Landing::LONG_STEP / DELTA);
	CHECK(!landing.advance(rig, &floor, {}, DELTA, slow));
	CHECK(floor.asked == 0); // And it costs nothing.
	RigState high = standing(rig, 20.0f, 31.0f);
	CHECK(!landing.advance(rig, &floor, {}, DELTA, high));
	RigState carried = standing(rig, 0.1f, 31.0f);
	CHECK(!landing.advance(rig, &floor, { 0.0f, -31.0f * DELTA, 0.0f }, DELTA, carried));
	floor.rises = -31.0f; // The floor falls as fast.
	RigState above = standing(rig, 0.1f, 31.0f);
	CHECK(!landing.advance(rig, &floor, {}, DELTA, above));
	CHECK(!landing.advance(rig, nullptr, {}, DELTA, above));
}

TEST(a_limb_that_runs_into_a_surface_is_laid_along_it_with_all_that_hangs_on_it) {
	const Rig rig(fixtures::limbs());
	const ActuationTable table(fixtures::groups(), 3);
	const Floor floor;
	for (const float angle : { 3.1f, 2.6f, 2.0f }) {
		SurfaceGuard guard(rig);
		RigState state = standing(rig, 0.0f, 0.0f);
		// A trunk over the floor, and what hangs on it turned down into it.
		Pose pose;
		pose.orientations = { Quat(), exp({ angle, 0.0f, 0.0f }), exp({ angle, 0.0f, 0.0f }), Quat() };
		pose.root = { 0.0f, -0.4f, 0.0f }; // The joint is 0.1 m over the floor.
		state = fixtures::state_of(rig, pose);
		CHECK(state.centres[1].y < 0.0f);
		const Quat held = state.orientations[1].inverse() * state.orientations[2];
		CHECK(guard.advance(rig, table, &floor, state));
		CHECK(state.centres[1].y > 0.0f);
		CHECK_NEAR(angle_between(state.orientations[1].inverse() * state.orientations[2], held), 0.0, 1e-3);
		// Every joint is where it was.
		CHECK_NEAR((rig.joint_of(state, 1) - Vec3{ 0.0f, 0.1f, 0.0f }).length(), 0.0, 1e-4);
		const Vec3 end = rig.joint_of(state, 1) + state.orientations[1].rotate(rig[2].anchor);
		CHECK_NEAR((rig.joint_of(state, 2) - end).length(), 0.0, 1e-4);
	}
}

TEST(limbs_that_are_put_somewhere_or_touch_nothing_stay) {
	const Rig rig(fixtures::limbs());
	ActuationTable table(fixtures::groups(), 3);
	const Floor floor;
	SurfaceGuard guard(rig);
	RigState above = standing(rig, 0.5f, 0.0f);
	for (int i = 0; i < 10; i++) {
		CHECK(!guard.advance(rig, table, &floor, above));
	}
	table.set_mode(Actuation::DIRECT_SET, -1, 0.0f);
	Pose pose;
	pose.orientations = { Quat(), exp({ 3.0f, 0.0f, 0.0f }), Quat(), Quat() };
	pose.root = { 0.0f, -0.4f, 0.0f };
	RigState below = fixtures::state_of(rig, pose);
	for (int i = 0; i < 10; i++) {
		CHECK(!guard.advance(rig, table, &floor, below));
		CHECK(!guard.advance(rig, table, nullptr, below));
	}
}

} // namespace test_surfaces
