// SPDX-License-Identifier: MIT
// Where the body stays behind its motion, and what carries it.
#include "fixtures.hpp"

#include "check.hpp"
#include "root/carrier.hpp"
#include "root/tether.hpp"

#include <functional>

namespace test_tether {

using namespace ragdoll;

namespace {

constexpr float DELTA = 1.0f / 60.0f;

/// A body that follows at once, but not beyond a wall at x = 0. Returns where it is.
float follow(Tether &r_tether, float p_seconds, float p_motion, float p_from, bool p_has_wall) {
	float expected = p_from;
	float body = p_from;
	for (int i = 0; i < int(p_seconds / DELTA); i++) {
		r_tether.advance({ body - expected, 0.0f, 0.0f }, DELTA);
		expected = p_motion + r_tether.get_next().x;
		body = p_has_wall ? std::min(expected, 0.0f) : expected;
	}
	return body;
}

/// A wide platform whose top is at height 0 where it is.
class Platform : public Ground {
public:
	Quat orientation;
	Vec3 origin;
	float edge = 1e9f; // m along X

	float height(const Vec3 &p_at) const override { return find(p_at, 1.0f).height; }
	Footing find(const Vec3 &p_at, float /*p_above*/) const override {
		Footing found;
		if (p_at.x > edge) {
			return found;
		}
		found.height = origin.y;
		found.body = 7;
		found.orientation = orientation;
		found.origin = origin;
		return found;
	}
};

/// Somebody on a platform that moves before each step: how far he is off at last, if he is moved as is told.
float drift_on(Platform &r_platform, const std::function<void(float)> &p_move) {
	const Rig rig(fixtures::limbs());
	std::vector<ContactPoint> contacts(2);
	contacts[1].local = { 0.2f, 0.0f, 0.0f };
	Pose pose;
	pose.orientations.assign(rig.size(), Quat());
	pose.root = { 1.0f, 0.0f, 2.0f };
	Carrier carrier;
	RigState state = fixtures::state_of(rig, pose);
	const Vec3 begin = pose.root - r_platform.origin;
	for (int i = 0; i < 1800; i++) {
		carrier.advance(rig, contacts, state, r_platform, DELTA);
		if (carrier.get_past().moves) {
			pose.root = carrier.get_past().apply(pose.root);
			pose.orientations.assign(rig.size(), carrier.get_past().turn * pose.orientations[0]);
			state = fixtures::state_of(rig, pose);
		}
		p_move(float(i) * DELTA);
	}
	carrier.advance(rig, contacts, state, r_platform, DELTA);
	pose.root = carrier.get_past().apply(pose.root);
	return (r_platform.orientation.inverse().rotate(pose.root - r_platform.origin) - begin).length();
}

} // namespace

TEST(the_motion_gives_in_to_what_is_in_the_way_at_any_distance) {
	for (const float beyond : { 0.5f, 3.0f, 30.0f }) {
		Tether tether;
		const float body = follow(tether, 5.0f, beyond, -1.0f, true);
		CHECK_NEAR(body, 0.0, 1e-6);
		CHECK_NEAR(tether.get_now().x, -beyond, Tether::SLACK);
		CHECK(tether.is_held());
	}
}

TEST(a_small_lag_is_no_obstacle) {
	Tether tether;
	for (int i = 0; i < 60; i++) {
		tether.advance({ 0.0f, 0.0f, -0.09f }, DELTA);
	}
	CHECK_NEAR(tether.get_now().length(), 0.0, 0.0);
}

TEST(it_comes_back_when_the_way_is_free) {
	Tether tether;
	follow(tether, 5.0f, 3.0f, -1.0f, true);
	CHECK_NEAR(follow(tether, 3.0f, 3.0f, 0.0f, false), 3.0, 0.01);
	CHECK(!tether.is_held());
}

TEST(only_the_level_gives_in) {
	Tether tether;
	tether.advance({ 0.0f, -2.0f, 0.0f }, DELTA);
	tether.set({ 1.0f, 5.0f, 0.0f });
	CHECK_NEAR(tether.get_now().y, 0.0, 0.0);
}

TEST(who_stands_on_what_moves_or_turns_stays_where_he_stands_on_it) {
	Platform sideways;
	CHECK(drift_on(sideways, [&](float) { sideways.origin.x += 2.0f * DELTA; }) < 0.005f);
	Platform lift;
	CHECK(drift_on(lift, [&](float p_time) { lift.origin.y = std::sin(p_time); }) < 0.005f);
	Platform turning;
	const Quat turn = exp({ 0.0f, PI / 6.0f * DELTA, 0.0f });
	CHECK(drift_on(turning, [&](float) { turning.orientation = (turn * turning.orientation).normalized(); }) < 0.005f);
}

TEST(who_is_turned_is_told_how_far_an_engine_takes_him_off_the_arc) {
	const Rig rig(fixtures::limbs());
	Pose pose;
	pose.orientations.assign(rig.size(), Quat());
	pose.root = { 2.0f, 0.0f, 0.0f };
	const RigState state = fixtures::state_of(rig, pose);
	Platform platform;
	Carrier carrier;
	const float angle = PI / 6.0f * DELTA;
	for (int i = 0; i < 2; i++) {
		carrier.advance(rig, std::vector<ContactPoint>(1), state, platform, DELTA);
		// Another sign is the same rotation.
		platform.orientation = -(exp({ 0.0f, angle, 0.0f }) * platform.orientation);
	}
	CHECK_NEAR(carrier.get_spiral().length(), 0.5f * angle * angle * 2.0f, 1e-6);
	CHECK(carrier.get_spiral().x > 0.0f);
}

TEST(what_is_put_elsewhere_takes_nobody_along) {
	Platform platform;
	float time = 0.0f;
	const float off = drift_on(platform, [&](float) {
		time += DELTA;
		platform.origin.x = time > 1.0f ? 50.0f : 0.0f;
	});
	CHECK_NEAR(off, 50.0, 0.1);
}

TEST(who_leaves_a_platform_slows_down) {
	const Rig rig(fixtures::limbs());
	Pose pose;
	pose.orientations.assign(rig.size(), Quat());
	RigState state = fixtures::state_of(rig, pose);
	Platform platform;
	Carrier carrier;
	for (int i = 0; i < 10; i++) {
		carrier.advance(rig, std::vector<ContactPoint>(1), state, platform, DELTA);
		platform.origin.x += 0.03f;
	}
	CHECK_NEAR(carrier.get_past().apply({}).x, 0.03, 1e-6);
	platform.edge = -1.0f;
	for (int i = 0; i < 30; i++) {
		carrier.advance(rig, std::vector<ContactPoint>(1), state, platform, DELTA);
	}
	CHECK_NEAR(carrier.get_past().apply({}).x, 0.03 * std::exp(-1.0), 1e-3);
}

} // namespace test_tether
