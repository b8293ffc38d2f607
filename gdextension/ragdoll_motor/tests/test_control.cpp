// SPDX-License-Identifier: MIT
#include "control/hit.hpp"
#include "control/world_drive.hpp"
#include "fixtures.hpp"

#include "check.hpp"

namespace test_control {

using namespace ragdoll;

namespace {

constexpr float DELTA = 1.0f / 60.0f;

const float STILL[16] = { 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1 };

struct Bench {
	Rig rig{ fixtures::limbs() };
	WorldDrive drive{ 4 };
	Pose pose;
	RigState state;
	std::vector<Vec3> joints;
	std::vector<LimbPush> pushes{ 4 };

	Bench() {
		pose.orientations.assign(4, Quat());
		state = fixtures::state_of(rig, pose);
		rig.joint_positions(pose, joints);
	}
	/// One step of a limb that is alone.
	void step(std::size_t p_limb) {
		drive.advance(DELTA);
		drive.compute(rig, state, pose, pose, joints, joints, DELTA, pushes);
		const Segment &limb = rig[p_limb];
		state.linear[p_limb] = state.linear[p_limb] + pushes[p_limb].force * (DELTA / limb.mass);
		state.centres[p_limb] = state.centres[p_limb] + state.linear[p_limb] * DELTA;
		// Turned about the centre by its axes: slowly enough for no gyroscopic torque.
		const Vec3 &own = rig.get_own_inertia(p_limb);
		const Vec3 torque = state.orientations[p_limb].inverse().rotate(pushes[p_limb].torque);
		const Vec3 gained{ torque.x / own.x, torque.y / own.y, torque.z / own.z };
		state.angular[p_limb] = state.angular[p_limb] + state.orientations[p_limb].rotate(gained) * DELTA;
		const Vec3 turn = state.orientations[p_limb].inverse().rotate(state.angular[p_limb]) * DELTA;
		state.orientations[p_limb] = (state.orientations[p_limb] * exp(turn)).normalized();
	}
};

} // namespace

TEST(a_world_spring_pulls_as_fast_as_its_frequency_says) {
	// Undamped, from rest, a spring of 1 Hz passes its target after a quarter of a second; the limb here
	// carries nothing but itself.
	Bench bench;
	bench.drive.set(3, {}, { 1.0f, 0.0f, 0.0f }, 0.0f);
	CHECK(bench.drive.is_active());
	bench.state.centres[3].x += 0.1f;
	const float target = bench.joints[3].x;
	int steps = 0;
	while (bench.state.centres[3].x > target && steps < 100) {
		bench.step(3);
		steps++;
	}
	CHECK_NEAR(steps * DELTA, 0.25, 0.03);
}

TEST(no_strength_makes_a_world_spring_explode) {
	for (const float strength : { 0.5f, 5.0f, 30.0f, 500.0f }) {
		for (const float ratio : { 0.0f, 0.3f, 1.0f, 5.0f }) {
			Bench bench;
			bench.drive.set(1, { strength, ratio, 0.0f }, { strength, ratio, 0.0f }, 0.0f);
			bench.state.centres[1].y += 0.2f;
			bench.state.orientations[1] = exp({ 0.0f, 0.0f, 0.6f });
			float furthest = 0.0f;
			float widest = 0.0f;
			for (int i = 0; i < 600; i++) {
				bench.step(1);
				furthest = std::max(furthest, std::fabs(bench.state.centres[1].y - 0.75f));
				widest = std::max(widest, angle_between(bench.state.orientations[1], Quat()));
			}
			CHECK(furthest < 0.25f);
			CHECK(widest < 0.7f);
			const bool is_damped = ratio >= 0.3f && ratio <= 1.0f;
			CHECK(!is_damped || angle_between(bench.state.orientations[1], Quat()) < 0.02f);
		}
	}
}

TEST(world_springs_are_limited_and_blend) {
	Bench bench;
	bench.state.centres[2].x += 1.0f;
	bench.state.orientations[2] = exp({ 1.0f, 0.0f, 0.0f });
	bench.drive.set(2, { 10.0f, 1.0f, 3.0f }, { 10.0f, 1.0f, 7.0f }, 0.0f);
	bench.drive.compute(
			bench.rig, bench.state, bench.pose, bench.pose, bench.joints, bench.joints, DELTA, bench.pushes);
	CHECK_NEAR(bench.pushes[2].force.length(), 7.0, 1e-3);
	CHECK_NEAR(bench.pushes[2].torque.length(), 3.0, 1e-3);
	CHECK_NEAR(bench.pushes[3].force.length() + bench.pushes[3].torque.length(), 0.0, 0.0);
	CHECK(bench.pushes[2].force.x < 0.0f && bench.pushes[2].torque.x < 0.0f);
	// Fades within half a second, and is gone then.
	bench.drive.set(2, {}, {}, 0.5f);
	CHECK(bench.drive.is_pulled(2));
	for (int i = 0; i < 31; i++) {
		bench.drive.advance(DELTA);
	}
	CHECK(!bench.drive.is_active());
	bench.drive.compute(
			bench.rig, bench.state, bench.pose, bench.pose, bench.joints, bench.joints, DELTA, bench.pushes);
	CHECK_NEAR(bench.pushes[2].force.length(), 0.0, 0.0);
}

TEST(the_nearest_limb_is_hit) {
	const Bench bench;
	// The trunk's line goes from 0 to 0.5 m, that of the next from there to 1 m.
	CHECK(find_nearest_limb(bench.rig, bench.state, { 0.3f, 0.2f, 0.0f }, -1) == 0);
	CHECK(find_nearest_limb(bench.rig, bench.state, { 0.3f, 0.8f, 0.0f }, -1) == 1);
	CHECK(find_nearest_limb(bench.rig, bench.state, { 0.0f, 0.2f, 0.0f }, 2) == 3);
	CHECK(find_nearest_limb(bench.rig, bench.state, {}, 7) == -1);
}

TEST(a_hit_takes_strength_of_the_group_and_half_as_much_of_its_neighbours) {
	Driver driver(Rig(fixtures::limbs()), fixtures::groups(), 3, {});
	Pose pose;
	pose.orientations.assign(4, Quat());
	RigState state = fixtures::state_of(driver.get_rig(), pose);
	CHECK(driver.push(0.0, STILL, {}, nullptr));
	const ActuationTable &table = driver.get_table();
	CHECK(driver.hit(state, {}, { 0.0f, 1.4f, 0.0f }, 1, 0.2f, 0.5f) == 2);
	CHECK_NEAR(table.get_strength(2), 0.2, 1e-6);
	CHECK_NEAR(table.get_strength(0), 0.6, 1e-6); // The trunk, on which it hangs.
	CHECK_NEAR(table.get_strength(3), 1.0, 1e-6); // The other arm.
	// A second, weaker blow gives nothing back.
	driver.hit(state, {}, { 0.0f, 1.4f, 0.0f }, 1, 0.9f, 0.5f);
	CHECK_NEAR(table.get_strength(2), 0.2, 1e-6);
	float before = 0.0f;
	for (int i = 0; i < 31; i++) {
		driver.push((i + 1) * double(DELTA), STILL, {}, nullptr); // Or the stream would stall.
		driver.step(state, i * double(DELTA), DELTA);
		CHECK(table.get_strength(2) >= before);
		before = table.get_strength(2);
	}
	CHECK_NEAR(table.get_strength(2), 1.0, 1e-5);
}

TEST(a_heavy_blow_leaves_a_limb_what_stops_it) {
	Driver driver(Rig(fixtures::limbs()), fixtures::groups(), 3, {});
	Pose pose;
	pose.orientations.assign(4, Quat());
	RigState state = fixtures::state_of(driver.get_rig(), pose);
	// Limb 2: 0.2 + 10 * 0.25^2 kg m^2 about its joint at 1 m, 500 N m.
	const Vec3 end{ 0.0f, 1.5f, 0.0f };
	const auto least = [&](float p_impulse) {
		return find_least_strength(driver.get_rig(), state, 2, { 0.0f, 0.0f, p_impulse }, end);
	};
	CHECK_NEAR(least(20.0f), 0.5 * 10.0 * 10.0 / 0.825 / (500.0 * double(MAX_BEND)), 1e-3);
	CHECK_NEAR(least(1000.0f), 1.0, 0.0);
	CHECK_NEAR(least(0.0f), 0.0, 0.0);
	CHECK_NEAR(find_least_strength(driver.get_rig(), state, 0, { 0.0f, 0.0f, 100.0f }, end), 0.0, 0.0);
	CHECK(driver.hit(state, { 0.0f, 0.0f, 20.0f }, end, 1, 0.0f, 1.0f) == 2);
	CHECK_NEAR(driver.get_table().get_strength(2), double(least(20.0f)), 1e-5);
}

TEST(a_hit_on_the_root_leaves_what_holds_it_up) {
	Driver driver(Rig(fixtures::limbs()), fixtures::groups(), 3, {});
	Pose pose;
	pose.orientations.assign(4, Quat());
	RigState state = fixtures::state_of(driver.get_rig(), pose);
	CHECK(driver.push(0.0, STILL, {}, nullptr));
	driver.step(state, 0.0, DELTA);
	driver.hit(state, {}, {}, 0, 0.1f, 10.0f);
	const RootCommand &command = driver.step(state, double(DELTA), DELTA).root;
	CHECK_NEAR(command.force_up, 2000.0, 1.0);
	CHECK_NEAR(command.force_across, 200.0, 5.0);
	CHECK_NEAR(command.torque, 80.0, 2.0);
}

TEST(a_control_blends_and_can_be_taken_back) {
	Driver driver(Rig(fixtures::limbs()), fixtures::groups(), 3, {});
	Pose pose;
	pose.orientations.assign(4, Quat());
	RigState state = fixtures::state_of(driver.get_rig(), pose);
	CHECK(driver.push(0.0, STILL, {}, nullptr));
	LimbControl wounded;
	wounded.mode = Actuation::POSITION_MOTOR;
	wounded.strength = 0.5f;
	wounded.parent_angular = { 3.0f, 0.7f, 100.0f }; // Of 500 N m.
	driver.set_control(2, wounded, 1.0f);
	const ActuationTable &table = driver.get_table();
	CHECK_NEAR(table.get_strength(2), 1.0, 1e-6);
	CHECK_NEAR(table.get_spring(2).frequency, 12.0, 1e-5); // The mode's own, to begin with.
	for (int i = 0; i < 30; i++) {
		driver.push((i + 1) * double(DELTA), STILL, {}, nullptr); // Or the stream would stall.
		driver.step(state, i * double(DELTA), DELTA);
	}
	CHECK_NEAR(table.get_strength(2), 0.55, 1e-3);
	CHECK_NEAR(table.get_spring(2).frequency, 7.5, 1e-2);
	for (int i = 30; i < 61; i++) {
		driver.push((i + 1) * double(DELTA), STILL, {}, nullptr); // Or the stream would stall.
		driver.step(state, i * double(DELTA), DELTA);
	}
	CHECK_NEAR(table.get_strength(2), 0.1, 1e-5);
	CHECK_NEAR(table.get_spring(2).frequency, 3.0, 1e-5);
	CHECK_NEAR(table.get_spring(2).damping_ratio, 0.7, 1e-5);
	CHECK(table.get_mode(2) == Actuation::POSITION_MOTOR && table.get_mode(3) == Actuation::VELOCITY_MOTOR);
	driver.set_control(2, LimbControl(), 0.0f);
	CHECK_NEAR(table.get_strength(2), 1.0, 1e-6);
	CHECK_NEAR(table.get_spring(2).frequency, 0.0, 0.0);
	CHECK(table.get_mode(2) == Actuation::VELOCITY_MOTOR);
}

TEST(what_is_shown_lies_between_motion_and_simulation) {
	Driver driver(Rig(fixtures::limbs()), fixtures::groups(), 3, {});
	Pose off;
	off.orientations.assign(4, exp({ 0.0f, 0.0f, 0.4f }));
	RigState state = fixtures::state_of(driver.get_rig(), off);
	CHECK(driver.push(0.0, STILL, {}, nullptr));
	driver.step(state, 0.0, DELTA);
	state = fixtures::state_of(driver.get_rig(), off);
	LimbControl half;
	half.physics_blend = 0.5f;
	LimbControl none;
	none.physics_blend = 0.0f;
	driver.set_control(1, half, 0.0f);
	driver.set_control(2, none, 0.0f);
	std::vector<Quat> shown;
	Vec3 centre;
	driver.blend_shown(state, shown, centre);
	CHECK_NEAR(angle_between(shown[0], Quat()), 0.4, 1e-4);
	CHECK_NEAR(angle_between(shown[1], Quat()), 0.2, 1e-4);
	CHECK_NEAR(angle_between(shown[2], Quat()), 0.0, 1e-4);
	CHECK_NEAR((centre - state.centres[0]).length(), 0.0, 1e-6);
	CHECK(driver.get_table().get_mode(2) == Actuation::DIRECT_SET);
	CHECK(driver.get_table().get_mode(1) == Actuation::VELOCITY_MOTOR);
	driver.set_control(0, none, 0.0f);
	driver.blend_shown(state, shown, centre);
	CHECK_NEAR((centre - Vec3{ 0.0f, 0.25f, 0.0f }).length(), 0.0, 1e-5);
}

TEST(controls_are_part_of_the_saved_state) {
	Driver driver(Rig(fixtures::limbs()), fixtures::groups(), 3, {});
	Driver other(Rig(fixtures::limbs()), fixtures::groups(), 3, {});
	LimbControl control;
	control.strength = 0.3f;
	control.world_linear = { 5.0f, 1.0f, 50.0f };
	control.physics_blend = 0.25f;
	driver.set_control(3, control, 0.0f);
	ArchiveWriter archive;
	driver.save(archive);
	ArchiveReader reader(archive.get_bytes().data(), archive.get_bytes().size());
	CHECK(other.restore(reader) && reader.is_at_end());
	CHECK_NEAR(other.get_table().get_strength(3), 0.3, 1e-6);
	CHECK_NEAR(other.get_table().get_physics_blend(3), 0.25, 1e-6);
	Pose pose;
	pose.orientations.assign(4, Quat());
	RigState state = fixtures::state_of(other.get_rig(), pose);
	CHECK(other.push(0.0, STILL, {}, nullptr));
	CHECK(other.push(double(DELTA), STILL, {}, nullptr));
	int steps = 0;
	// Puts the body into the motion's pose.
	while (other.step(state, double(DELTA) * steps, DELTA).must_put && steps < 100) {
		steps++;
	}
	state.centres[3].x += 0.1f;
	CHECK(other.step(state, double(DELTA) * (steps + 1), DELTA).pushes[3].force.length() > 0.0f);
}

} // namespace test_control
