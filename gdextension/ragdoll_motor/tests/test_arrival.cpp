// SPDX-License-Identifier: MIT
#include "fixtures.hpp"

#include "check.hpp"

namespace test_arrival {

using namespace ragdoll;

namespace {

constexpr float DELTA = 1.0f / 60.0f;
constexpr float RATE = 2.0f; // Of the motion, about Z, rad/s.
constexpr float SPEED = 3.0f; // Of the motion, along X, m/s.
constexpr float OFF = 1.2f; // How far a body lies from the motion, rad.

/// The motion: the whole body turns and runs.
Pose motion(float p_time_s) {
	Pose pose;
	pose.orientations.assign(fixtures::limbs().size(), exp({ 0.0f, 0.0f, RATE * p_time_s }));
	pose.root = { SPEED * p_time_s, 1.0f, 0.0f };
	return pose;
}

bool push(Driver &r_driver, float p_time_s, float p_clock_s = 0.0f) {
	const Pose pose = motion(p_time_s);
	float values[16];
	for (std::size_t i = 0; i < 4; i++) {
		const Quat &limb = pose.orientations[i];
		const float four[4] = { limb.x, limb.y, limb.z, limb.w };
		std::copy(four, four + 4, values + 4 * i);
	}
	return r_driver.push(double(p_time_s + p_clock_s), values, pose.root, nullptr);
}

/// Moves bodies as their velocities say.
void move(RigState &r_state, const Rig &p_rig) {
	for (std::size_t i = 0; i < r_state.centres.size(); i++) {
		r_state.centres[i] = r_state.centres[i] + r_state.linear[i] * DELTA;
		r_state.orientations[i] = (exp(r_state.angular[i] * DELTA) * r_state.orientations[i]).normalized();
	}
	r_state.root = p_rig.joint_of(r_state, 0);
}

float error(const RigState &p_state, float p_time_s) {
	const Pose wanted = motion(p_time_s);
	float worst = (p_state.root - wanted.root).length();
	for (std::size_t i = 0; i < wanted.orientations.size(); i++) {
		worst = std::max(worst, angle_between(p_state.orientations[i], wanted.orientations[i]));
	}
	return worst;
}

RigState sagged(const Rig &p_rig) {
	Pose pose = motion(0.0f);
	for (std::size_t i = 1; i < pose.orientations.size(); i++) {
		pose.orientations[i] = exp({ OFF, 0.0f, 0.0f });
	}
	pose.root.x -= 0.2f;
	return fixtures::state_of(p_rig, pose);
}

/// Whatever crosses a plane across X.
class Wall : public Obstacles {
public:
	bool is_in_way(std::size_t, const Quat &, const Vec3 &, const Vec3 &) const override { return false; }
	bool find_between(const Vec3 &, const Vec3 &p_to, Hit &) const override { return p_to.y > top; }
	float top = 1e9f;
};

/// Runs a motion with a pause of p_pause_s. Returns the greatest error from 0.1 s after it on.
float worst_after(Driver &r_driver, float p_pause_s, RigState &r_state) {
	const int before = 30;
	const int pause = int(std::lround(p_pause_s / DELTA));
	float worst = 0.0f;
	for (int i = 0; i < before + pause + 20; i++) {
		const float time = DELTA * float(i);
		const bool is_paused = i >= before && i < before + pause;
		if (!is_paused) {
			push(r_driver, time);
		}
		const StepCommands &commands = r_driver.step(r_state, double(time), DELTA);
		if (commands.must_put) {
			move(r_state, r_driver.get_rig());
		} else {
			// What the joints would make of it is not what is tested here.
			r_state = fixtures::state_of(r_driver.get_rig(), motion(is_paused ? 0.0f : time + DELTA));
		}
		if (i >= before + pause + int(0.1f / DELTA)) {
			worst = std::max(worst, error(r_state, time + DELTA));
		}
	}
	return worst;
}

} // namespace

TEST(who_begins_in_motion_has_its_velocity) {
	for (const RootMode mode : { RootMode::SOFT, RootMode::HELD, RootMode::GROUNDED }) {
		Driver driver(Rig(fixtures::limbs()), fixtures::groups(), 3, {});
		driver.root_mode = mode;
		RigState state = sagged(driver.get_rig());
		float time = 0.0f;
		bool was_put = true;
		for (int i = 0; i < 5 && was_put; i++) {
			time = DELTA * float(i);
			CHECK(push(driver, time));
			was_put = driver.step(state, double(time), DELTA).must_put;
			if (was_put) {
				move(state, driver.get_rig());
				time += DELTA;
			}
		}
		CHECK(error(state, time) < 0.02f);
		CHECK_NEAR(state.angular[3].z, RATE, 0.05);
		CHECK_NEAR((state.linear[0] - state.angular[0].cross(state.centres[0] - state.root)).x, SPEED, 0.1);
	}
}

TEST(who_goes_on_after_a_pause_is_with_the_motion_at_once) {
	for (const RootMode mode : { RootMode::SOFT, RootMode::HELD, RootMode::GROUNDED }) {
		for (const float pause : { 0.2f, 0.5f, 0.9f, 1.5f, 3.0f }) {
			Driver driver(Rig(fixtures::limbs()), fixtures::groups(), 3, {});
			driver.root_mode = mode;
			RigState state = fixtures::state_of(driver.get_rig(), motion(0.0f));
			CHECK(worst_after(driver, pause, state) < 0.02f);
		}
	}
}

TEST(a_short_way_is_gone_within_some_steps_without_force) {
	const Rig rig(fixtures::limbs());
	ActuationTable table(fixtures::groups(), 3);
	Arrival arrival(rig.size());
	RigState state = sagged(rig);
	arrival.begin_from(rig, state, motion(0.0f), {}, false, table, nullptr);
	float before = error(state, 0.0f);
	int steps = 0;
	for (float time = 0.0f; arrival.is_on(); time += DELTA) {
		arrival.advance(rig, motion(time), motion(time + DELTA), true, DELTA, state);
		const float off = error(state, time);
		CHECK(off < before || steps == 0);
		CHECK(state.angular[3].length() < 1.5f * RATE);
		before = off;
		steps++;
	}
	CHECK(steps > 3);
	CHECK(before < 1e-3f);
}

TEST(a_limp_limb_and_one_behind_a_wall_hang_on_as_they_did) {
	const Rig rig(fixtures::limbs());
	ActuationTable table(fixtures::groups(), 3);
	Wall wall;
	for (const bool is_limp : { true, false }) {
		table.set_mode(is_limp ? Actuation::LIMP : Actuation::VELOCITY_MOTOR, 2, 0.0f);
		wall.top = is_limp ? 1e9f : 1e-3f;
		Arrival arrival(rig.size());
		RigState state = sagged(rig);
		state.orientations[3] = exp({ 0.0f, 2.0f, 0.0f });
		const Quat held = state.orientations[1].inverse() * state.orientations[3];
		arrival.begin_from(rig, state, motion(0.0f), {}, false, table, &wall);
		for (float time = 0.0f; arrival.is_on(); time += DELTA) {
			arrival.advance(rig, motion(time), motion(time + DELTA), true, DELTA, state);
		}
		CHECK_NEAR(angle_between(state.orientations[1].inverse() * state.orientations[3], held), 0.0, 1e-3);
	}
}

TEST(a_limb_that_something_held_when_the_motion_stalled_is_not_put_into_it) {
	const Rig rig(fixtures::limbs());
	const ActuationTable table(fixtures::groups(), 3);
	Arrival arrival(rig.size());
	RigState state = fixtures::state_of(rig, motion(0.0f));
	state.orientations[2] = exp({ 1.0f, 0.0f, 0.0f });
	arrival.note_stall(rig, state, motion(0.0f));
	arrival.begin_from(rig, state, motion(0.0f), {}, false, table, nullptr);
	for (float time = 0.0f; arrival.is_on(); time += DELTA) {
		arrival.advance(rig, motion(time), motion(time + DELTA), true, DELTA, state);
	}
	CHECK_NEAR(angle_between(state.orientations[1].inverse() * state.orientations[2], exp({ 1.0f, 0.0f, 0.0f })), 0.0,
			1e-3);
	CHECK_NEAR(angle_between(state.orientations[1], state.orientations[3]), 0.0, 1e-3);
}

TEST(who_lies_limp_is_not_stood_up_by_a_pause) {
	Driver driver(Rig(fixtures::limbs()), fixtures::groups(), 3, {});
	RigState state = fixtures::state_of(driver.get_rig(), motion(0.0f));
	worst_after(driver, 0.0f, state);
	driver.get_table().set_mode(Actuation::LIMP, -1, 0.0f);
	for (const float pause : { 1.5f, 4.0f }) {
		CHECK(push(driver, pause));
		CHECK(!driver.step(state, double(pause), DELTA).must_put);
	}
}

TEST(a_single_sample_puts_nobody_for_ever) {
	Driver driver(Rig(fixtures::limbs()), fixtures::groups(), 3, {});
	RigState state = sagged(driver.get_rig());
	CHECK(push(driver, 0.0f));
	for (int i = 0; i < 18; i++) {
		driver.step(state, double(DELTA) * i, DELTA);
	}
	CHECK(!driver.step(state, 0.3, DELTA).must_put);
}

TEST(what_brings_a_body_back_is_part_of_the_saved_state) {
	const Rig rig(fixtures::limbs());
	ActuationTable table(fixtures::groups(), 3);
	Arrival arrival(rig.size());
	Arrival other(rig.size());
	RigState state = sagged(rig);
	RigState same = state;
	arrival.begin_from(rig, state, motion(0.0f), { 0.1f, 0.0f, 0.0f }, false, table, nullptr);
	arrival.advance(rig, motion(0.0f), motion(DELTA), true, DELTA, state);
	ArchiveWriter archive;
	arrival.save(archive);
	ArchiveReader reader(archive.get_bytes().data(), archive.get_bytes().size());
	CHECK(other.restore(reader) && reader.is_at_end());
	arrival.advance(rig, motion(DELTA), motion(2.0f * DELTA), true, DELTA, state);
	other.advance(rig, motion(DELTA), motion(2.0f * DELTA), true, DELTA, same);
	CHECK_NEAR((state.centres[3] - same.centres[3]).length(), 0.0, 0.0);
}

} // namespace test_arrival
