// SPDX-License-Identifier: MIT
#include <motion_cueing.hpp>

#include "check.hpp"

#include <algorithm>
#include <limits>
#include <random>

namespace test_motion_cueing {

using namespace cueing;

namespace {

constexpr double STEP_S = 1.0 / 200.0;
/// Rounding of differences of positions.
constexpr double TINY = 1e-9;

MotionCueing small_platform() {
	MotionCueing cueing;
	cueing.set_limits({ { { 0.10, 0.3, 3.0 }, { 0.08, 0.3, 4.0 }, { 0.12, 0.35, 3.5 } } },
			{ { { 0.26, 0.5, 4.0 }, { 0.3, 0.5, 5.0 }, { 0.25, 0.45, 4.5 } } });
	return cueing;
}

/// Notes what the platform does from one pose to the next, and whether that is within its limits.
class Watch {
public:
	explicit Watch(const MotionCueing &p_cueing) : _cueing(p_cueing), _before(p_cueing.pose()) {}

	void look(double p_seconds) {
		for (int axis = 0; axis < 3; axis++) {
			judge(_cueing.travel_limits(axis), _cueing.pose().position[axis], _before.position[axis],
					_speeds.position[axis], p_seconds);
			judge(_cueing.attitude_limits(axis), _cueing.pose().attitude[axis], _before.attitude[axis],
					_speeds.attitude[axis], p_seconds);
		}
		_before = _cueing.pose();
	}
	/// Greatest use of any limit: 1 is all of it.
	double travel = 0.0;
	double speed = 0.0;
	double acceleration = 0.0;

private:
	void judge(const AxisLimits &p_limits, double p_now, double p_before, double &r_speed, double p_seconds) {
		const double now = (p_now - p_before) / p_seconds;
		travel = std::max(travel, std::fabs(p_now) / p_limits.travel);
		speed = std::max(speed, std::fabs(now) / p_limits.speed);
		acceleration = std::max(acceleration, std::fabs(now - r_speed) / p_seconds / p_limits.acceleration);
		r_speed = now;
	}

	const MotionCueing &_cueing;
	Pose _before;
	Pose _speeds;
};

Motion pushed(double p_right, double p_back) {
	Motion motion;
	motion.specific_force[0] = p_right;
	motion.specific_force[2] = p_back;
	return motion;
}

void run(MotionCueing &r_cueing, const Motion *p_motion, double p_seconds, Watch *r_watch = nullptr) {
	const auto steps = std::lround(p_seconds / STEP_S);
	for (long i = 0; i < steps; i++) {
		r_cueing.step(p_motion, STEP_S);
		if (r_watch != nullptr) {
			r_watch->look(STEP_S);
		}
	}
}

double farthest(const Pose &p_pose) {
	double most = 0.0;
	for (int axis = 0; axis < 3; axis++) {
		most = std::max({ most, std::fabs(p_pose.position[axis]), std::fabs(p_pose.attitude[axis]) });
	}
	return most;
}

} // namespace

TEST(limits_hold_whatever_comes) {
	std::mt19937 random(4711);
	std::uniform_real_distribution<double> unit(-1.0, 1.0);
	double farthest_of_all = 0.0;
	for (int drive = 0; drive < 60; drive++) {
		MotionCueing cueing = small_platform();
		cueing.washout.parameters.horizontal = { 1.0, 60.0, 0.6 + drive * 0.1, 1.0, 0.2 };
		cueing.washout.parameters.vertical = { 1.0, 60.0, 2.0, 0.7, 0.25 };
		cueing.washout.parameters.rotation = { 1.0, 6.0, 0.3, 1.0, 1 + drive % 2 };
		Watch watch(cueing);
		Motion motion;
		for (int i = 0; i < 6000; i++) {
			const double fate = unit(random);
			if (fate > 0.98) {
				motion.specific_force = { 100.0 * unit(random), 100.0 * unit(random), 100.0 * unit(random) };
				motion.rates = { 9.0 * unit(random), 9.0 * unit(random), 9.0 * unit(random) };
			} else if (fate < -0.9995) {
				cueing.teleport();
			} else if (fate < -0.999) {
				cueing.set_paused(unit(random) > 0.0);
			}
			// Steps of all lengths, as of a machine that is too slow.
			const double seconds = STEP_S * (fate > 0.95 ? 1.0 + 20.0 * (fate - 0.95) : 1.0);
			cueing.step(fate > 0.5 && drive % 3 == 0 ? nullptr : &motion, seconds);
			watch.look(seconds);
		}
		CHECK(watch.travel <= 1.0 + TINY);
		CHECK(watch.speed <= 1.0 + TINY);
		CHECK(watch.acceleration <= 1.0 + 1e-6);
		farthest_of_all = std::max(farthest_of_all, watch.travel);
	}
	CHECK(farthest_of_all > 0.95);
}

TEST(within_the_limits_the_platform_is_where_the_filter_has_it) {
	MotionCueing cueing = small_platform();
	const Motion rest;
	run(cueing, &rest, 3.0);
	double worst = 0.0;
	double greatest = 0.0;
	for (int i = 0; i < 2000; i++) {
		const Motion motion = pushed(0.8 * std::sin(i * 0.01), 0.5 * std::sin(i * 0.023));
		cueing.step(&motion, STEP_S);
		worst = std::max(worst, std::fabs(cueing.pose().position[0] - cueing.washout.pose().position[0]));
		greatest = std::max(greatest, std::fabs(cueing.pose().position[0]));
	}
	CHECK(greatest > 0.02);
	CHECK(worst < 1e-9);
}

TEST(a_platform_that_was_at_its_limit_finds_back_without_swinging) {
	MotionCueing cueing = small_platform();
	const Motion rest;
	run(cueing, &rest, 3.0);
	cueing.washout.parameters.horizontal.limit = 60.0;
	const Motion hard = pushed(50.0, 0.0);
	run(cueing, &hard, 1.0);
	CHECK(cueing.pose().position[0] > 0.09);
	run(cueing, &rest, 30.0);
	CHECK_NEAR(farthest(cueing.pose()), 0.0, 0.001);
}

TEST(without_news_the_platform_is_neutral_after_two_seconds) {
	MotionCueing cueing = small_platform();
	const Motion slope = pushed(2.0, 2.0);
	Watch watch(cueing);
	run(cueing, &slope, 8.0, &watch);
	CHECK(farthest(cueing.pose()) > 0.05);
	run(cueing, nullptr, 0.19, &watch);
	CHECK(!cueing.is_leaving());
	run(cueing, nullptr, 1.0, &watch);
	CHECK(cueing.is_leaving());
	CHECK(farthest(cueing.pose()) > 0.01);
	run(cueing, nullptr, 1.05, &watch);
	CHECK_NEAR(farthest(cueing.pose()), 0.0, 1e-4);
	CHECK(watch.acceleration <= 1.0 + 1e-6);
	run(cueing, &slope, 5.0, &watch);
	CHECK(farthest(cueing.pose()) > 0.05);
}

TEST(a_teleport_and_a_pause_make_no_step) {
	for (const bool is_pause : { true, false }) {
		MotionCueing cueing = small_platform();
		const Motion before = pushed(1.5, 3.0);
		const Motion after = pushed(-3.0, -3.0);
		run(cueing, &before, 6.0);
		Pose last = cueing.pose();
		if (is_pause) {
			cueing.set_paused(true);
		} else {
			cueing.teleport();
		}
		double fastest = 0.0;
		double nearest = 1.0;
		for (int i = 0; i < 2400; i++) {
			if (i == 700) {
				cueing.set_paused(false);
			}
			cueing.step(&after, STEP_S);
			for (int axis = 0; axis < 3; axis++) {
				fastest = std::max(fastest, std::fabs(cueing.pose().position[axis] - last.position[axis]) / STEP_S);
				fastest = std::max(fastest, std::fabs(cueing.pose().attitude[axis] - last.attitude[axis]) / STEP_S);
			}
			nearest = std::min(nearest, farthest(cueing.pose()));
			last = cueing.pose();
		}
		CHECK(fastest < 0.35);
		CHECK(nearest < 1e-4);
		// Then it shows where the vehicle is now: the other way.
		CHECK(cueing.pose().attitude[0] > 0.05);
	}
}

TEST(numbers_that_are_none_count_as_no_news) {
	MotionCueing cueing = small_platform();
	const Motion fine = pushed(1.0, 1.0);
	run(cueing, &fine, 5.0);
	Motion broken = fine;
	broken.rates[1] = std::numeric_limits<double>::quiet_NaN();
	run(cueing, &broken, 3.0);
	CHECK_NEAR(farthest(cueing.pose()), 0.0, 1e-4);
	broken = fine;
	broken.specific_force[0] = std::numeric_limits<double>::infinity();
	run(cueing, &broken, 1.0);
	CHECK(farthest(cueing.pose()) < 1e-4);
	run(cueing, &fine, 5.0);
	CHECK(farthest(cueing.pose()) > 0.02);
}

TEST(an_axis_that_is_not_there_stands_still) {
	MotionCueing cueing = small_platform();
	cueing.set_limits({ { {}, { 0.1, 0.3, 3.0 }, {} } }, { { { 0.2, 0.5, 4.0 }, {}, { 0.2, 0.5, 4.0 } } });
	const Motion motion = pushed(2.0, 2.0);
	run(cueing, &motion, 6.0);
	CHECK(cueing.pose().position[0] == 0.0);
	CHECK(cueing.pose().position[2] == 0.0);
	CHECK(cueing.pose().attitude[1] == 0.0);
	CHECK(cueing.pose().attitude[0] < -0.05);
}

} // namespace test_motion_cueing
