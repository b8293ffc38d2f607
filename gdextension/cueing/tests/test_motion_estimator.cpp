// SPDX-License-Identifier: MIT
#include <motion_estimator.hpp>

#include "check.hpp"

#include <algorithm>
#include <limits>
#include <random>

namespace test_motion_estimator {

using namespace cueing;

namespace {

constexpr double TICK_S = 1.0 / 60.0;

kinematics::Quat turned(double p_x, double p_y, double p_z) {
	return kinematics::exp({ float(p_x), float(p_y), float(p_z) });
}

/// A car that goes round a curve of 20 m radius with 10 m/s, to the left.
SeatState circling(double p_time) {
	const double angle = 0.5 * p_time;
	SeatState state;
	state.time = p_time;
	state.position = { -20.0 + 20.0 * std::cos(angle), 0.0, -20.0 * std::sin(angle) };
	state.orientation = turned(0.0, angle, 0.0);
	return state;
}

double rounded(double p_value, double p_step) {
	return std::round(p_value / p_step) * p_step;
}

} // namespace

TEST(a_curve_pushes_to_its_inside_and_turns) {
	MotionEstimator estimator;
	for (int i = 0; i < 60; i++) {
		CHECK(estimator.add(circling(i * TICK_S)));
	}
	SeatMotion motion;
	CHECK(estimator.estimate(0.9, motion));
	CHECK_NEAR(motion.felt.specific_force[0], -5.0, 0.05);
	CHECK_NEAR(motion.felt.specific_force[1], GRAVITY, 0.02);
	CHECK_NEAR(motion.felt.specific_force[2], 0.0, 0.05);
	CHECK_NEAR(motion.felt.rates[1], 0.5, 0.002);
	CHECK_NEAR(std::hypot(motion.velocity[0], motion.velocity[2]), 10.0, 0.02);
}

TEST(who_stands_on_a_slope_is_pushed_by_gravity_alone) {
	MotionEstimator estimator;
	SeatState state;
	state.orientation = turned(0.3, 0.0, 0.0);
	for (int i = 0; i < 20; i++) {
		state.time = i * TICK_S;
		estimator.add(state);
	}
	SeatMotion motion;
	CHECK(estimator.estimate(0.3, motion));
	CHECK_NEAR(motion.felt.specific_force[1], GRAVITY * std::cos(0.3), 1e-3);
	CHECK_NEAR(motion.felt.specific_force[2], -GRAVITY * std::sin(0.3), 1e-3);
}

TEST(rounded_uneven_and_lost_states_make_no_spikes) {
	std::mt19937 random(5);
	std::uniform_real_distribution<double> unit(0.0, 1.0);
	for (const bool knows_velocity : { false, true }) {
		MotionEstimator estimator;
		double worst = 0.0;
		double steepest = 0.0;
		double before = 0.0;
		for (int i = 0; i < 600; i++) {
			SeatState state = circling((i + 0.3 * unit(random)) * TICK_S);
			for (double &value : state.position) {
				value = rounded(value, 0.001);
			}
			state.velocity = { -10.0 * std::sin(0.5 * state.time), 0.0, -10.0 * std::cos(0.5 * state.time) };
			for (double &value : state.velocity) {
				value = rounded(value, 0.01);
			}
			state.has_velocity = knows_velocity;
			if (unit(random) > 0.1) {
				estimator.add(state);
			}
			for (int part = 0; part < 3; part++) {
				SeatMotion motion;
				if (i < 20 || !estimator.estimate((i + part / 3.0) * TICK_S - 0.06, motion)) {
					continue;
				}
				const double right = motion.felt.specific_force[0];
				worst = std::max(worst, std::fabs(right + 5.0));
				steepest = std::max(steepest, before == 0.0 ? 0.0 : std::fabs(right - before));
				before = right;
			}
		}
		// Differences of differences would be off by 3.6 m/s^2 and more.
		CHECK(worst < (knows_velocity ? 0.2 : 0.9));
		CHECK(steepest < (knows_velocity ? 0.1 : 0.5));
		CHECK(steepest > 1e-6);
	}
}

TEST(a_jump_or_a_gap_is_no_motion) {
	MotionEstimator estimator;
	for (int i = 0; i < 30; i++) {
		CHECK(estimator.add(circling(i * TICK_S)));
	}
	SeatState there = circling(30 * TICK_S);
	there.position[0] += 200.0;
	CHECK(!estimator.add(there));
	SeatMotion motion;
	CHECK(!estimator.estimate(there.time, motion));
	for (int i = 1; i < 10; i++) {
		there.time += TICK_S;
		CHECK(estimator.add(there));
	}
	CHECK(estimator.estimate(there.time, motion));
	CHECK_NEAR(motion.felt.specific_force[0], 0.0, 1e-2);
	there.time += 2.0;
	CHECK(!estimator.add(there));
	// A turn on the spot by more than anything turns between two states.
	there.time += TICK_S;
	there.orientation = turned(0.0, 2.5, 0.0) * there.orientation;
	CHECK(!estimator.add(there));
}

TEST(old_double_and_broken_states_are_left_out) {
	MotionEstimator estimator;
	for (int i = 0; i < 30; i++) {
		SeatState state = circling(i * TICK_S);
		estimator.add(state);
		CHECK(estimator.add(state));
		state.time -= 0.1;
		CHECK(estimator.add(state));
		state.time += 1.0;
		state.position[1] = std::numeric_limits<double>::quiet_NaN();
		CHECK(estimator.add(state));
		state = circling(i * TICK_S + 0.001);
		state.orientation = { 0.0f, 0.0f, 0.0f, 0.0f };
		CHECK(estimator.add(state));
	}
	CHECK(estimator.size() == 30);
	SeatMotion motion;
	CHECK(estimator.estimate(0.4, motion));
	CHECK_NEAR(motion.felt.specific_force[0], -5.0, 0.1);
}

} // namespace test_motion_estimator
