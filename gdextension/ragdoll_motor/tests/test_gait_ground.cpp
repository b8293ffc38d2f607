// SPDX-License-Identifier: MIT
#include "driver.hpp"
#include "gait/foot_lock.hpp"
#include "gait/inertial_gait.hpp"
#include "gait/takeoff.hpp"

#include "check.hpp"

#include <functional>

namespace test_gait_ground {

using namespace ragdoll;

namespace {

constexpr float HIP = 0.9f; // m
constexpr float HZ = 60.0f;

/// Two feet of one point each, and a back.
std::vector<ContactPoint> contacts() {
	std::vector<ContactPoint> result(3);
	for (int i = 0; i < 2; i++) {
		result[std::size_t(i)].limb = 1 + i;
		result[std::size_t(i)].sole = true;
	}
	result[2].limb = 3;
	result[2].radius = 0.1f;
	return result;
}

/// The feet of somebody who walks on a level floor, whatever his body walks on.
std::vector<Vec3> walking(float p_time_s, float p_speed) {
	std::vector<Vec3> points(3, Vec3{ 0.0f, 0.1f, 0.0f });
	for (int side = 0; side < 2; side++) {
		const float round = p_time_s + 0.5f * float(side);
		const float part = round - std::floor(round);
		const float swung = part < 0.5f ? 0.0f : 0.5f - 0.5f * std::cos((part - 0.5f) * 2.0f * PI);
		const float lift = part < 0.5f ? 0.0f : 0.08f * std::sin((part - 0.5f) * 2.0f * PI);
		points[std::size_t(side)] = { 0.1f - 0.2f * float(side), lift - HIP, (swung + 0.25f - part) * p_speed };
	}
	return points;
}

/// Ground of any shape, and a crate or a platform where there is one.
class Field : public Ground {
public:
	std::function<float(const Vec3 &)> shape = [](const Vec3 &) { return 0.0f; };
	Vec3 velocity;
	Vec3 turning;
	float crate = -1e9f; ///< Height of the crate's top, m.

	float height(const Vec3 &p_at) const override { return shape(p_at); }
	Footing find(const Vec3 &p_at, float p_above) const override {
		Footing found;
		found.height = shape(p_at);
		found.velocity = velocity;
		found.turning = turning;
		if (crate > found.height && crate < p_at.y + p_above) {
			found.height = crate;
			found.is_loose = true;
		}
		// As rays do: nothing is seen from below the ground.
		found.height = p_at.y + p_above < found.height ? NAN : found.height;
		return found;
	}
};

void step(InertialGait &r_gait, const std::vector<Vec3> &p_points, const Ground &p_ground,
		const std::vector<Vec3> *p_shown = nullptr) {
	GaitInput input;
	input.delta_s = 1.0f / HZ;
	input.points = &p_points;
	input.ground = &p_ground;
	input.shown = p_shown;
	r_gait.step(input);
}

} // namespace

TEST(a_level_walk_goes_on_down_and_up_any_slope) {
	for (const float degrees : { -30.0f, -20.0f, -10.0f, -5.0f, 5.0f, 10.0f, 20.0f, 30.0f }) {
		const float rise = std::tan(degrees * PI / 180.0f);
		Field field;
		field.shape = [rise](const Vec3 &p_at) { return rise * p_at.z; };
		InertialGait gait(contacts());
		gait.reset({ 0.0f, HIP, 0.0f });
		for (int tick = 0; tick < 600; tick++) {
			step(gait, walking(float(tick) / HZ, 1.2f), field);
		}
		CHECK_NEAR(gait.get_root().z, 1.2 * 599.0 / 60.0, 0.05 * 12.0);
		CHECK_NEAR(gait.get_root().y, HIP + rise * gait.get_root().z, 0.2);
	}
}

TEST(bumps_do_not_turn_a_walk) {
	Field field;
	field.shape = [](const Vec3 &p_at) { return 0.1f * std::sin(2.0f * p_at.x) * std::sin(2.0f * p_at.z); };
	InertialGait gait(contacts());
	gait.reset({ 0.5f, HIP, 0.0f });
	for (int tick = 0; tick < 600; tick++) {
		step(gait, walking(float(tick) / HZ, 1.2f), field);
		CHECK(!gait.is_flying());
	}
	CHECK_NEAR(gait.get_root().z, 12.0, 0.6);
}

TEST(who_begins_in_the_ground_or_above_it_comes_to_stand) {
	for (const float told : { -0.5f, 0.0f, 0.1f, 0.5f, 0.9f, 1.5f, 4.0f }) {
		for (const float tall : { 0.15f, 0.3f, 0.5f, 0.9f }) {
			std::vector<Vec3> points(3, Vec3{ 0.0f, 0.05f, 0.0f });
			points[0] = { 0.1f, -tall, 0.0f };
			points[1] = { -0.1f, -tall, 0.0f };
			InertialGait gait(contacts());
			gait.reset({ 0.0f, told, 0.0f });
			for (int tick = 0; tick < 90; tick++) {
				step(gait, points, Field());
			}
			CHECK(!gait.is_flying());
			CHECK_NEAR(gait.get_root().y, tall, 1e-3);
		}
	}
}

TEST(who_joins_in_mid_stride_soon_goes_the_right_way) {
	for (int phase = 0; phase < 20; phase++) {
		InertialGait gait(contacts());
		gait.reset({ 0.0f, HIP, 0.0f });
		for (int tick = 0; tick < 60; tick++) {
			step(gait, walking(0.05f * float(phase), 1.2f), Field()); // The suit's stream has stalled.
		}
		for (int tick = 0; tick < 120; tick++) {
			step(gait, walking(0.05f * float(phase) + float(tick) / HZ, 1.2f), Field());
		}
		const float place = gait.get_root().z;
		CHECK(place > 0.5f);
		for (int tick = 120; tick < 420; tick++) {
			step(gait, walking(0.05f * float(phase) + float(tick) / HZ, 1.2f), Field());
		}
		CHECK_NEAR(gait.get_root().z - place, 6.0, 0.2);
	}
}

TEST(a_ledge_is_fallen_down_from_and_landed_after) {
	Field field;
	InertialGait gait(contacts());
	gait.reset({ 0.0f, HIP, 0.0f });
	field.shape = [](const Vec3 &p_at) { return p_at.z < 3.0f ? 0.0f : -1.0f; };
	float flown_s = 0.0f;
	for (int tick = 0; tick < 400; tick++) {
		step(gait, walking(float(tick) / HZ, 1.2f), field);
		flown_s += gait.is_flying() ? 1.0f / HZ : 0.0f;
	}
	CHECK_NEAR(gait.get_root().y, HIP - 1.0, 0.02);
	// A metre takes 0.45 s.
	CHECK(flown_s > 0.2f && flown_s < 0.6f);
}

TEST(what_lies_on_the_body_does_not_carry_it) {
	// Somebody lies on his back's side under a crate, or crawls under a table.
	for (const bool steps_up : { false, true }) {
		std::vector<ContactPoint> points_of = contacts();
		Field field;
		field.crate = 0.3f;
		std::vector<Vec3> points(3, Vec3{ 0.0f, 0.0f, 0.0f });
		points[0] = { 0.5f, -0.05f, 0.1f };
		points[1] = { 0.5f, -0.05f, -0.1f };
		InertialGait gait(points_of);
		const float begins = steps_up ? 0.7f : 0.1f;
		gait.reset({ 0.0f, begins, 0.0f });
		for (int tick = 0; tick < 60; tick++) {
			std::vector<Vec3> shown = points;
			for (Vec3 &point : shown) {
				point = point + Vec3{ 0.0f, begins, 0.0f };
			}
			step(gait, points, field, &shown);
		}
		CHECK_NEAR(gait.get_root().y, steps_up ? 0.4 : 0.1, 0.01);
	}
}

TEST(platforms_carry_and_turn_who_stands_on_them) {
	for (const bool turns : { false, true }) {
		Field field;
		field.velocity = turns ? Vec3() : Vec3{ 2.0f, 0.0f, 0.0f };
		field.turning = turns ? Vec3{ 0.0f, PI / 6.0f, 0.0f } : Vec3();
		InertialGait gait(contacts());
		gait.reset({ 0.0f, HIP, 2.0f });
		std::vector<Vec3> points(3, Vec3{ 0.0f, 0.1f, 0.0f });
		points[0] = { 0.1f, -HIP, 0.0f };
		points[1] = { -0.1f, -HIP, 0.0f };
		const Quat turn = exp(field.turning * (1.0f / HZ));
		Vec3 place{ 0.0f, HIP, 2.0f };
		for (int tick = 0; tick < 1800; tick++) {
			step(gait, points, field);
			if (!turns && tick > 10) {
				// The platform goes on to carry him in the step that comes.
				CHECK_NEAR(gait.ahead(points, 1.0f / HZ).x - gait.get_root().x, 2.0 / 60.0, 1e-3);
			}
			if (tick > 0) {
				place = turns ? turn.rotate(place) : place + field.velocity * (1.0f / HZ);
			}
		}
		// Half a minute: 60 m, or two and a half rounds.
		CHECK_NEAR((gait.get_root() - place).length(), 0.0, 0.02);
	}
}

TEST(a_lift_carries_who_stands_on_it) {
	Field field;
	float floor = 0.0f;
	field.shape = [&floor](const Vec3 &) { return floor; };
	InertialGait gait(contacts());
	gait.reset({ 0.0f, HIP, 0.0f });
	std::vector<Vec3> points(3, Vec3{ 0.0f, 0.1f, 0.0f });
	points[0] = { 0.1f, -HIP, 0.0f };
	points[1] = { -0.1f, -HIP, 0.0f };
	for (int tick = 0; tick < 600; tick++) {
		field.velocity = { 0.0f, 1.5f * std::sin(float(tick) / HZ * 2.0f * PI / 5.0f), 0.0f };
		floor += field.velocity.y / HZ;
		step(gait, points, field);
		CHECK_NEAR(gait.get_root().y, floor + HIP, 0.03);
		CHECK(!gait.is_flying());
	}
}

TEST(a_quick_crouch_is_no_flight_and_a_runner_flies) {
	Takeoff crouch;
	bool flies = false;
	for (int tick = 0; tick < 120; tick++) {
		// 10 cm up and down twice a second: 3 m/s^2 at most.
		const float phase = float(tick) / HZ * 4.0f * PI;
		const float speed = 0.02f * 4.0f * PI * std::cos(phase);
		flies = flies || crouch.advance(HIP + 0.02f * std::sin(phase), speed, 2.0f, 9.81f, 1.0f / HZ);
	}
	CHECK(!flies);
	for (const float slide : { 0.0f, 2.0f }) {
		// Legs are drawn up in flight: the lowest point comes nearer to the centre than the body rises.
		Takeoff run;
		flies = false;
		for (int tick = 0; tick < 8; tick++) {
			const float time = float(tick) / HZ;
			flies = flies ||
					run.advance(HIP - (tick > 2 ? 0.6f * (time - 0.05f) : 0.0f), 0.6f, slide, 9.81f, 1.0f / HZ);
		}
		CHECK(flies == (slide > 1.0f));
	}
}

/// Hips, two legs of thigh, shin and foot, and a sole of one point each; legs hang down.
struct Walker {
	std::vector<Segment> segments;
	std::vector<ContactPoint> soles;
	Walker() : segments(7), soles(2) {
		for (std::size_t i = 1; i < 7; i++) {
			const bool is_thigh = i == 1 || i == 4;
			segments[i].parent = is_thigh ? 0 : int(i) - 1;
			segments[i].anchor = { 0.0f, is_thigh ? 0.0f : -0.45f, i == 2 || i == 5 ? 0.05f : 0.0f };
		}
		for (std::size_t i = 0; i < 2; i++) {
			soles[i].limb = i == 0 ? 3 : 6;
			soles[i].sole = true;
		}
	}
};

TEST(feet_clear_the_ground_while_they_swing_and_reach_it_on_lower_ground) {
	const Walker walker;
	const Rig rig(walker.segments);
	FootLock lock(rig, walker.soles);
	Field field;
	field.shape = [](const Vec3 &p_at) { return p_at.z > 0.2f ? -0.15f : 0.0f; };
	InertialGait gait(walker.soles);
	std::vector<Vec3> joints;
	std::vector<Vec3> points(2);
	Pose pose;
	pose.orientations.resize(7);
	const float step = 1.0f / HZ;
	gait.reset({ 0.0f, HIP - 0.08f, 0.0f });
	float least = 1.0f;
	for (int tick = 0; tick < 60; tick++) {
		// One foot stands still; the other one is swung ahead without being lifted, and comes to rest.
		const float part = std::clamp(float(tick - 20) / 24.0f, 0.0f, 1.0f);
		pose.root = {};
		std::fill(pose.orientations.begin(), pose.orientations.end(), Quat());
		rig.joint_positions(pose, joints);
		bend_leg(rig, { 3, 2, 1 }, { 0.0f, 0.08f, 0.0f }, pose, joints);
		bend_leg(rig, { 6, 5, 4 }, { 0.0f, 0.08f, 0.35f * part }, pose, joints);
		points = { joints[3], joints[6] };
		gait.step({ step, &points, {}, &field });
		pose.root = gait.get_root();
		lock.advance(gait, pose.root, points, { pose.root + points[0], pose.root + points[1] }, 0.0f, step);
		rig.joint_positions(pose, joints);
		pose.root.y -= lock.sink(rig, 0.0f, joints, step);
		rig.joint_positions(pose, joints);
		lock.apply(rig, 0.0f, pose, joints);
		if (tick > 28 && joints[6].z < 0.2f) {
			least = std::min(least, joints[6].y);
		}
	}
	CHECK(least > 0.01f);
	CHECK(lock.get_drop() > 0.05f);
	CHECK_NEAR(joints[6].y, -0.15, 0.02);
	CHECK_NEAR(joints[3].y, 0.0, 0.02);
}

TEST(a_pose_that_changed_while_nothing_came_moves_nobody) {
	Walker walker;
	for (Segment &segment : walker.segments) {
		segment.mass = 5.0f;
		segment.inertia = { 0.1f, 0.1f, 0.1f };
		segment.max_torque = 300.0f;
	}
	Driver driver(Rig(walker.segments), std::vector<int>(7, 0), 1, walker.soles);
	driver.root_mode = RootMode::INERTIAL;
	std::vector<Quat> pose(7);
	RigState state;
	state.resize(7);
	state.gravity = { 0.0f, -9.81f, 0.0f };
	double time = 0.0;
	const auto run = [&](double p_until, bool p_sends) {
		while (time < p_until) {
			if (p_sends) {
				driver.push(time, &pose[0].x, { 0.0f, HIP, 0.0f }, nullptr);
			}
			if (time == 0.0) {
				driver.pose_state(time, state);
			}
			driver.step(state, time, 1.0f / 60.0f);
			time += 1.0 / 60.0;
		}
	};
	run(0.5, true);
	run(1.0, false);
	const Vec3 before = driver.get_root_target();
	pose[1] = exp({ -0.4f, 0.0f, 0.0f });
	pose[2] = pose[1];
	pose[3] = pose[1];
	pose[4] = pose[1];
	pose[5] = pose[1];
	pose[6] = pose[1];
	run(1.03, true);
	CHECK_NEAR(level(driver.get_root_target() - before).length(), 0.0, 0.03);
}

} // namespace test_gait_ground
