// SPDX-License-Identifier: MIT
#include "comparison/lowest_contact.hpp"
#include "comparison/lowest_foot.hpp"
#include "gait/foot_lock.hpp"
#include "gait/inertial_gait.hpp"

#include "check.hpp"
#include "fixtures.hpp"

#include <functional>
#include <limits>
#include <memory>
#include <random>

namespace test_gait {

using namespace ragdoll;

namespace {

constexpr float HIP = 0.9f;
constexpr float STEP = 0.6f; // m
constexpr float STEP_S = 0.5f;

/// A body on two feet of two points each, and a hand.
std::vector<ContactPoint> contacts() {
	std::vector<ContactPoint> result(5);
	for (int i = 0; i < 4; i++) {
		result[std::size_t(i)].limb = 1 + i / 2;
		result[std::size_t(i)].sole = true;
	}
	result[4].limb = 3;
	result[4].radius = 0.04f;
	return result;
}

/// Somebody who walks along Z: feet stand for one step each, and swing for the other.
struct Walker {
	float speed = STEP / STEP_S;
	float ground_rise = 0.0f; // Of the ground, a metre.

	Vec3 root(float p_time) const {
		const float z = speed * p_time;
		return { 0.0f, HIP + ground_rise * z, z };
	}
	Vec3 foot(int p_side, float p_time) const {
		// Steps of this foot are two step lengths long; it stands during the first half of its round.
		const float round = p_time / (2.0f * STEP_S) + (p_side == 0 ? 0.0f : 0.5f);
		const float position = std::floor(round);
		const float part = round - position;
		const float moved = part < 0.5f ? 0.0f : 0.5f - 0.5f * std::cos((part - 0.5f) * 2.0f * PI);
		const float lift = part < 0.5f ? 0.0f : 0.1f * std::sin((part - 0.5f) * 2.0f * PI);
		const float z =
				(position + moved - (p_side == 0 ? 0.0f : 0.5f)) * 2.0f * STEP * speed * STEP_S / STEP + 0.25f * STEP;
		return { p_side == 0 ? 0.1f : -0.1f, ground_rise * z + lift, z };
	}
	std::vector<Vec3> points(float p_time) const {
		const Vec3 at = root(p_time);
		std::vector<Vec3> result;
		for (int side = 0; side < 2; side++) {
			const Vec3 heel = foot(side, p_time) - at;
			result.push_back(heel);
			result.push_back(heel + Vec3{ 0.0f, 0.15f * ground_rise, 0.15f });
		}
		result.push_back({ 0.3f, 0.0f, 0.1f });
		return result;
	}
};

/// Ground that rises evenly.
class Slope : public Ground {
public:
	explicit Slope(float p_rise) : _rise(p_rise) {}
	float height(const Vec3 &p_at) const override { return _rise * p_at.z; }

private:
	float _rise;
};

class Nothing : public Ground {
public:
	float height(const Vec3 & /*p_at*/) const override { return std::numeric_limits<float>::quiet_NaN(); }
};

/// Lets an estimator follow; returns how far it is off in the end, m.
float follow(Travel &r_travel, const Walker &p_walker, const Ground &p_ground, int p_ticks, int p_hz, int p_from = 0) {
	for (int tick = p_from; tick < p_from + p_ticks; tick++) {
		const std::vector<Vec3> points = p_walker.points(float(tick) / float(p_hz));
		r_travel.step({ 1.0f / float(p_hz), &points, { 0.0f, 0.05f, 0.0f }, &p_ground });
	}
	return (r_travel.get_root() - p_walker.root(float(p_from + p_ticks - 1) / float(p_hz))).length();
}

std::vector<std::unique_ptr<Travel>> all() {
	std::vector<std::unique_ptr<Travel>> result;
	result.push_back(std::make_unique<LowestFoot>(contacts()));
	result.push_back(std::make_unique<LowestContact>(contacts()));
	result.push_back(std::make_unique<InertialGait>(contacts()));
	return result;
}

} // namespace

TEST(standing_does_not_drift) {
	const Walker still{ 0.0f };
	for (const std::unique_ptr<Travel> &travel : all()) {
		travel->reset(still.root(0.0f));
		CHECK_NEAR(follow(*travel, still, FlatGround(), 600, 60), 0.0, 0.002);
		CHECK(!travel->is_flying());
	}
}

TEST(walking_is_followed_at_any_rate) {
	const Walker walker;
	for (const int hz : { 30, 60, 120 }) {
		InertialGait travel(contacts());
		travel.reset(walker.root(0.0f));
		const float off = follow(travel, walker, FlatGround(), 10 * hz, hz);
		CHECK(off < 0.04f * walker.root(10.0f).z);
		CHECK_NEAR(travel.get_root().y, HIP, 0.02);
	}
	LowestFoot lowest(contacts());
	lowest.reset(walker.root(0.0f));
	CHECK(follow(lowest, walker, FlatGround(), 600, 60) < 2.0f);
}

TEST(slopes_are_climbed) {
	Walker walker;
	walker.ground_rise = 0.2f;
	const Slope slope(0.2f);
	for (const std::unique_ptr<Travel> &travel : all()) {
		if (dynamic_cast<LowestFoot *>(travel.get())) {
			continue; // The thesis's rule knows level ground only.
		}
		travel->reset(walker.root(0.0f));
		follow(*travel, walker, slope, 600, 60);
		CHECK_NEAR(travel->get_root().y, HIP + 0.2f * travel->get_root().z, 0.05);
		CHECK(travel->get_root().z > 9.0f);
	}
}

TEST(the_lowest_foot_is_anchored_anew_where_it_is) {
	LowestFoot travel(contacts());
	travel.reset({ 0.0f, 1.0f, 0.0f });
	std::vector<Vec3> points(5, Vec3{ 0.0f, 0.0f, 0.0f });
	points[0] = { 0.0f, -1.0f, 0.0f };
	const FlatGround ground;
	travel.step({ 0.02f, &points, {}, &ground });
	points[0] = { 0.0f, -1.0f, -0.5f }; // The body moves ahead over the held point.
	travel.step({ 0.02f, &points, {}, &ground });
	CHECK_NEAR(travel.get_root().z, 0.5, 1e-6);
	points[2] = { 0.0f, -1.1f, 0.3f }; // Another one is lower now.
	travel.step({ 0.02f, &points, {}, &ground });
	CHECK_NEAR(travel.get_root().z, 0.5, 1e-6);
	CHECK_NEAR(travel.get_root().y, 1.1, 1e-6);
	points[2] = { 0.0f, -1.1f, 0.1f };
	travel.step({ 0.02f, &points, {}, &ground });
	CHECK_NEAR(travel.get_root().z, 0.7, 1e-6);
}

TEST(a_hand_carries_who_lies) {
	for (const std::unique_ptr<Travel> &travel : all()) {
		if (dynamic_cast<LowestFoot *>(travel.get())) {
			continue;
		}
		travel->reset({ 0.0f, 0.3f, 0.0f });
		std::vector<Vec3> points(5, Vec3{ 0.0f, 0.2f, 0.0f });
		points[4] = { 0.3f, -0.2f, 0.0f };
		const FlatGround ground;
		for (int i = 0; i < 60; i++) {
			travel->step({ 0.02f, &points, {}, &ground });
		}
		CHECK_NEAR(travel->get_root().y, 0.24, 0.005); // The hand's radius counts.
	}
}

TEST(jumps_are_found_and_fall_freely_at_any_rate) {
	for (const int hz : { 30, 60, 120, 240 }) {
		InertialGait travel(contacts());
		travel.reset({ 0.0f, HIP, 0.0f });
		const FlatGround ground;
		float highest = 0.0f;
		float flown_s = 0.0f;
		for (int tick = 0; tick < 3 * hz; tick++) {
			// Crouches, pushes off with 1.4 m/s, flies with the legs as they are, lands.
			const float time = float(tick) / float(hz);
			float leg = HIP;
			if (time > 1.0f && time < 1.25f) {
				leg = HIP - 0.21f * std::sin((time - 1.0f) / 0.25f * PI / 2.0f);
			} else if (time >= 1.25f && time < 1.4f) {
				leg = HIP - 0.21f + 1.4f * (time - 1.25f);
			}
			std::vector<Vec3> points(5, Vec3{ 0.0f, -leg, 0.0f });
			points[4] = { 0.3f, 0.0f, 0.0f };
			travel.step({ 1.0f / float(hz), &points, {}, &ground });
			highest = std::max(highest, travel.get_root().y);
			flown_s += travel.is_flying() ? 1.0f / float(hz) : 0.0f;
		}
		CHECK(flown_s > 0.1f && flown_s < 0.5f);
		CHECK(highest > HIP + 0.03f && highest < HIP + 0.3f);
		CHECK_NEAR(travel.get_root().y, HIP, 0.01);
	}
}

TEST(a_flight_takes_as_long_as_gravity_lets_it) {
	// Up with 1.4 m/s: 2 v / g in the air.
	for (const float pull : { 9.81f, 3.71f, 1.62f }) {
		InertialGait travel(contacts());
		travel.reset({ 0.0f, HIP, 0.0f });
		const FlatGround ground;
		float flown_s = 0.0f;
		for (int tick = 0; tick < 60 * 6; tick++) {
			const float time = float(tick) / 60.0f;
			float leg = HIP;
			if (time > 1.0f && time < 1.25f) {
				leg = HIP - 0.21f * std::sin((time - 1.0f) / 0.25f * PI / 2.0f);
			} else if (time >= 1.25f && time < 1.4f) {
				leg = HIP - 0.21f + 1.4f * (time - 1.25f);
			}
			std::vector<Vec3> points(5, Vec3{ 0.0f, -leg, 0.0f });
			points[4] = { 0.3f, 0.0f, 0.0f };
			travel.step({ 1.0f / 60.0f, &points, {}, &ground, { 0.0f, -pull, 0.0f } });
			flown_s += travel.is_flying() ? 1.0f / 60.0f : 0.0f;
		}
		CHECK_NEAR(flown_s, 2.0f * 1.4f / pull, 0.25f * 2.0f * 1.4f / pull);
		CHECK_NEAR(travel.get_root().y, HIP, 0.01);
	}
}

TEST(without_gravity_nothing_falls) {
	InertialGait travel(contacts());
	const std::vector<Vec3> points = Walker{}.points(0.0f);
	travel.reset({ 0.0f, HIP, 0.0f });
	const Nothing nothing;
	const FlatGround flat;
	float stood = 0.0f;
	for (int tick = 0; tick < 120; tick++) {
		const bool is_gone = tick >= 60; // The ground.
		stood = is_gone ? stood : travel.get_root().y;
		travel.step({ 1.0f / 60.0f, &points, {}, is_gone ? static_cast<const Ground *>(&nothing) : &flat, {} });
	}
	CHECK(travel.is_flying());
	CHECK_NEAR(travel.get_root().y, stood, 1e-3);
}

TEST(without_any_ground_a_body_falls) {
	InertialGait travel(contacts());
	const Walker still{ 0.0f };
	travel.reset(still.root(0.0f));
	const Nothing nothing;
	follow(travel, still, FlatGround(), 60, 60);
	follow(travel, still, nothing, 30, 60, 60);
	CHECK(travel.is_flying());
	CHECK(travel.get_root().y < HIP - 0.5f && travel.get_root().y > HIP - 2.0f);
	LowestContact stays(contacts());
	stays.reset(still.root(0.0f));
	follow(stays, still, nothing, 30, 60);
	CHECK_NEAR(stays.get_root().y, HIP, 1e-6);
}

TEST(bad_input_is_left_out) {
	const Walker walker;
	for (const std::unique_ptr<Travel> &travel : all()) {
		travel->reset(walker.root(0.0f));
		follow(*travel, walker, FlatGround(), 60, 60);
		const Vec3 before = travel->get_root();
		const FlatGround ground;
		std::vector<Vec3> points = walker.points(1.0f);
		points[2].y = std::numeric_limits<float>::quiet_NaN();
		travel->step({ 0.02f, &points, {}, &ground });
		const std::vector<Vec3> few(2);
		travel->step({ 0.02f, &few, {}, &ground });
		points = walker.points(1.0f);
		travel->step({ 0.0f, &points, {}, &ground });
		travel->step({ 0.02f, &points, { std::numeric_limits<float>::infinity(), 0.0f, 0.0f }, &ground });
		CHECK_NEAR((travel->get_root() - before).length(), 0.0, 0.0);
		CHECK(follow(*travel, walker, FlatGround(), 60, 60, 60) < 1.0f);
	}
}

TEST(shifts_and_saves) {
	const Walker walker;
	for (int kind = 0; kind < 3; kind++) {
		std::vector<std::unique_ptr<Travel>> one = all();
		std::vector<std::unique_ptr<Travel>> other = all();
		Travel &travel = *one[std::size_t(kind)];
		Travel &copy = *other[std::size_t(kind)];
		travel.reset(walker.root(0.0f));
		follow(travel, walker, FlatGround(), 100, 60);
		const Vec3 before = travel.get_root();
		travel.shift({ 1.0f, 0.0f, -2.0f });
		CHECK_NEAR(travel.get_root().x, before.x + 1.0f, 1e-5);
		ArchiveWriter archive;
		travel.save(archive);
		ArchiveReader reader(archive.get_bytes().data(), archive.get_bytes().size());
		CHECK(copy.restore(reader) && reader.is_at_end());
		follow(travel, walker, FlatGround(), 100, 60, 100);
		follow(copy, walker, FlatGround(), 100, 60, 100);
		CHECK(travel.get_root().x == copy.get_root().x && travel.get_root().z == copy.get_root().z);
		ArchiveReader cut(archive.get_bytes().data(), archive.get_bytes().size() / 2);
		CHECK(!copy.restore(cut));
	}
}

TEST(standing_feet_are_held_by_bending_the_legs) {
	std::vector<Segment> segments(4);
	for (std::size_t i = 1; i < 4; i++) {
		segments[i].parent = int(i) - 1;
		segments[i].anchor = { 0.0f, i == 1 ? 0.0f : -0.45f, i == 2 ? 0.05f : 0.0f };
	}
	const Rig rig(segments);
	std::vector<ContactPoint> sole(1);
	sole[0].limb = 3;
	sole[0].sole = true;
	FootLock lock(rig, sole);
	LowestFoot travel(sole);
	Pose pose;
	pose.orientations.resize(4);
	pose.orientations[1] = exp({ -0.2f, 0.0f, 0.0f });
	std::vector<Vec3> joints;
	std::mt19937 random(3);
	std::normal_distribution<float> noise(0.0f, 0.02f);
	Vec3 stands;
	for (int tick = 0; tick < 50; tick++) {
		Pose shown = pose;
		shown.orientations[1] = shown.orientations[1] * exp({ noise(random), 0.0f, noise(random) });
		rig.joint_positions(shown, joints);
		const std::vector<Vec3> points = { joints[3] };
		const std::vector<Vec3> shown_points = { tick == 0 ? joints[3] + Vec3{ 0.0f, 0.9f, 0.0f } : stands };
		const FlatGround ground;
		if (tick == 0) {
			travel.reset({ 0.0f, 0.9f, 0.0f });
			travel.step({ 0.02f, &points, {}, &ground });
		}
		shown.root = travel.get_root(); // Held still: the noise must go into the leg.
		lock.advance(travel, shown.root, points, shown_points, 0.0f, 0.02f);
		rig.joint_positions(shown, joints);
		lock.apply(rig, 0.0f, shown, joints);
		std::vector<Vec3> again;
		rig.joint_positions(shown, again);
		CHECK_NEAR((again[3] - joints[3]).length(), 0.0, 1e-5);
		if (tick == 0) {
			stands = again[3];
		}
		CHECK_NEAR(again[3].x, stands.x, 1e-3);
		CHECK_NEAR(again[3].z, stands.z, 1e-3);
	}
}

} // namespace test_gait
