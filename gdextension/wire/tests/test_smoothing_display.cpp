// SPDX-License-Identifier: MIT
// Displays of any rate: how old what they show is, at each frame, and what they make of something sudden.
#include "smoothing_fixtures.hpp"

#include <check.hpp>

namespace test_smoothing_display {

using namespace fixtures;

namespace {

constexpr double RATES[] = { 50.0, 59.0, 59.94, 60.0, 72.0, 75.0, 90.0, 120.0, 144.0 };

struct Ages {
	double mean = 0.0; // s
	double deviation = 0.0; // s
	double most = 0.0; // s
};

// How old the motion is that each frame of a display shows; the client's clock runs faster than the server's by
// p_drift, s per second.
Ages watch(double p_rate, double p_drift, const std::vector<Arrival> &p_datagrams) {
	Smoother smoother;
	smoother.set_skeleton(0, arm());
	std::size_t next = 0;
	double sum = 0.0;
	double squares = 0.0;
	double count = 0.0;
	Ages ages;
	const double end = p_datagrams.back().arrival;
	for (int frame = 0; (frame + 0.37) / p_rate < end; frame++) {
		const double true_now = (frame + 0.37) / p_rate;
		const double now = 50.0 + true_now * (1.0 + p_drift);
		for (; next < p_datagrams.size() && p_datagrams[next].arrival <= true_now; next++) {
			const double arrival = 50.0 + p_datagrams[next].arrival * (1.0 + p_drift);
			smoother.push(swinging(p_datagrams[next].tick), arrival);
		}
		smoother.evaluate(now);
		if (true_now > 2.0) {
			const double age = true_now - smoother.motion_tick() / 60.0;
			sum += age;
			squares += age * age;
			count += 1.0;
			ages.most = std::max(ages.most, age);
		}
	}
	ages.mean = sum / count;
	ages.deviation = std::sqrt(std::max(squares / count - ages.mean * ages.mean, 0.0));
	return ages;
}

// How far a limb is shown beyond a sudden turn of 0.7 rad at tick 100, rad; and when half of it was first shown, s
// after the tick.
struct Step {
	float beyond = 0.0f;
	double half = 0.0;
};

Step step_on(double p_rate, double p_phase) {
	Smoother smoother;
	smoother.set_skeleton(0, arm());
	Step step;
	uint32_t tick = 1;
	for (int frame = 0; frame < int(3.0 * p_rate); frame++) {
		const double now = (frame + p_phase) / p_rate;
		for (; double(tick) / 60.0 + 0.002 <= now; tick++) {
			PersonUpdate update;
			update.tick = tick;
			const float angle = tick < 100 ? 0.0f : 0.7f;
			update.pose.orientations[2] = kinematics::exp({ 0.0f, 0.0f, angle });
			smoother.push(update, double(tick) / 60.0 + 0.002);
		}
		smoother.evaluate(now);
		if (const Smoother::Person *person = smoother.person(0)) {
			const float angle = kinematics::log(person->pose.orientations[2]).z;
			step.beyond = std::max(step.beyond, std::max(angle - 0.7f, -angle));
			step.half = step.half == 0.0 && angle > 0.35f ? now - 100.0 / 60.0 : step.half;
		}
	}
	return step;
}

} // namespace

TEST(motion_is_as_old_at_every_frame_of_every_display) {
	const std::vector<Arrival> lan = network(0, 1200, 1, 0.003, 0.001, 0.0);
	for (const double rate : RATES) {
		const Ages ages = watch(rate, 0.0, lan);
		CHECK(ages.mean > 0.002 && ages.mean < 0.008);
		CHECK(ages.deviation < 0.001);
	}
}

TEST(clocks_that_drift_and_datagrams_that_are_late_or_lost_leave_it_so) {
	const std::vector<Arrival> worse = network(0, 1800, 1, 0.006, 0.004, 0.03);
	for (const double rate : RATES) {
		for (const double drift : { -3e-4, 3e-4 }) {
			const Ages ages = watch(rate, drift, worse);
			CHECK(ages.mean < 0.017);
			CHECK(ages.deviation < 0.002);
		}
	}
}

TEST(what_does_not_come_makes_motion_old) {
	// One second is lost: the shown tick runs on, motion does not, and counts as what it is.
	std::vector<Arrival> datagrams = network(0, 300, 1, 0.003, 0.0, 0.0);
	const std::vector<Arrival> rest = network(360, 600, 1, 0.003, 0.0, 0.0);
	datagrams.insert(datagrams.end(), rest.begin(), rest.end());
	const Ages ages = watch(59.0, 0.0, datagrams);
	CHECK(ages.most > 0.9 && ages.most < 1.05);
}

TEST(the_tick_of_motion_is_that_of_what_each_method_shows) {
	for (const SmoothingMethod method : ALL_METHODS) {
		Smoother smoother;
		smoother.set_method(method);
		smoother.set_skeleton(0, arm());
		CHECK_NEAR(smoother.motion_tick(), -1.0, 1e-9);
		for (uint32_t tick = 1; tick <= 120; tick++) {
			smoother.push(swinging(tick), tick / 60.0);
			smoother.evaluate(tick / 60.0 + 0.001);
		}
		// The root walks at 1 m/s: where it is shown says which moment is shown.
		for (const double silence : { 0.001, 0.012, 0.1 }) {
			smoother.evaluate(2.0 + silence);
			CHECK_NEAR(smoother.motion_tick() / 60.0, double(smoother.person(0)->pose.root.x), 0.004);
			CHECK(smoother.motion_tick() < smoother.shown_tick() + 2.5);
		}
	}
}

TEST(something_sudden_is_seen_soon_and_not_beyond_itself) {
	for (const double rate : RATES) {
		for (const double phase : { 0.05, 0.35, 0.65, 0.95 }) {
			const Step step = step_on(rate, phase);
			CHECK(step.beyond < 0.12f * 0.7f);
			CHECK(step.half > 0.0 && step.half < 0.005 + 2.0 / rate);
		}
	}
}

TEST(displays_of_a_station_show_the_same_at_the_same_tick) {
	Smoother first;
	Smoother second;
	first.set_skeleton(0, arm());
	second.set_skeleton(0, arm());
	for (uint32_t tick = 0; tick < 120; tick++) {
		// The second one's datagrams come late.
		first.push(swinging(tick), tick / 60.0 + 0.001);
		second.push(swinging(tick), tick / 60.0 + 0.021);
	}
	for (int frame = 0; frame < 25; frame++) {
		const double now = 2.0 + 0.004 * frame;
		first.evaluate(now);
		second.evaluate(now + 0.02);
		const double own = second.shown_tick();
		CHECK(second.show_tick(first.shown_tick() - 3.0, now + 0.02));
		CHECK(std::fabs(second.shown_tick() - first.shown_tick() + 3.0) < 1e-9);
		CHECK(second.show_tick(first.shown_tick(), now + 0.02));
		// What others choose does not move what this one would show by itself.
		second.evaluate(now + 0.02);
		CHECK(std::fabs(second.shown_tick() - own) < 1e-6);
		CHECK(second.show_tick(first.shown_tick(), now + 0.02));
		CHECK(second.shown_tick() == first.shown_tick());
	}
	CHECK(!second.show_tick(-1.0, 2.2));
	CHECK(!second.show_tick(NAN, 2.2));
	CHECK(!second.show_tick(1e18, 2.2));
	CHECK(second.shown_tick() == first.shown_tick());
	Smoother unborn;
	CHECK(!unborn.show_tick(5.0, 1.0));
}

} // namespace test_smoothing_display
