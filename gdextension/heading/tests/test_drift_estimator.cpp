// SPDX-License-Identifier: MIT
#include <drift_estimator.hpp>

#include <check.hpp>

#include <cmath>

using namespace heading;

namespace {

constexpr double RATE = degrees(5.0) / 60.0;

kinematics::Quat yaw(double p_angle) {
	return kinematics::exp({ 0.0f, float(p_angle), 0.0f });
}

/// Every second sensor drifts to the left, the others to the right.
double drift_of(int p_mount, double p_rate, double p_time) {
	return p_rate * p_time * (p_mount % 2 == 0 ? 1.0 : -1.0);
}

/// Somebody who sways while standing, and turns round by p_turn at half time.
DriftEstimator stand(double p_rate, double p_seconds, double p_turn = 0.0) {
	DriftEstimator estimator;
	for (int i = 0; i < int(p_seconds * 20.0); i++) {
		DriftEstimator::Sample sample;
		sample.time = 1000.0 + i * 0.05;
		const double time = i * 0.05;
		const double turned = time > p_seconds * 0.5 ? p_turn : 0.0;
		for (int mount = 0; mount < MOUNTS; mount++) {
			const double sway = degrees(1.0) * std::sin(time * (0.5 + 0.13 * mount));
			sample.present[std::size_t(mount)] = true;
			sample.rotations[std::size_t(mount)] = yaw(drift_of(mount, p_rate, time) + turned + sway);
		}
		estimator.add(sample);
	}
	return estimator;
}

double worst(const DriftEstimator &p_estimator, double p_rate, double p_time) {
	double most = 0.0;
	for (int mount = 0; mount < MOUNTS; mount++) {
		most = std::max(most, std::abs(p_estimator.correction(mount) - drift_of(mount, p_rate, p_time)));
	}
	return most;
}

} // namespace

TEST(nothing_known_is_nothing_corrected) {
	DriftEstimator estimator;
	estimator.add({});
	CHECK(estimator.correction(0) == 0.0);
	CHECK(estimator.trust() == 0.0);
}

TEST(drift_is_taken_off_while_somebody_stands) {
	CHECK(worst(stand(RATE, 300.0), RATE, 300.0) < degrees(4.0));
}

TEST(who_turns_round_has_not_drifted) {
	CHECK(worst(stand(0.0, 120.0, 2.0), 0.0, 120.0) < degrees(0.1));
	CHECK(worst(stand(RATE, 300.0, 2.0), RATE, 300.0) < degrees(4.0));
}

TEST(what_is_known_at_a_restart_is_taken_off_at_once) {
	DriftEstimator estimator = stand(RATE, 120.0);
	std::array<double, MOUNTS> drifts{};
	drifts.fill(0.4);
	estimator.restart(drifts);
	CHECK(estimator.correction(3) == 0.4);
	CHECK(estimator.state().drift(3) == 0.0);
	CHECK(estimator.state().rate(0) - estimator.state().rate(1) > RATE);
}

TEST(samples_that_go_back_in_time_or_stop_do_no_harm) {
	DriftEstimator estimator = stand(0.0, 30.0);
	DriftEstimator::Sample sample;
	sample.present.fill(true);
	for (const double time : { 0.0, 5000.0, 5000.0, 1.0, 1.05, 1.1 }) {
		sample.time = time;
		estimator.add(sample);
	}
	CHECK(std::isfinite(estimator.correction(0)));
}

TEST(a_magnetic_field_is_held_against_its_reference) {
	MagneticField field;
	for (int i = 0; i < 200; i++) {
		field.add({ 0.0f, -0.9f, 0.42f }, 0.05);
	}
	CHECK(field.is_good());
	for (int i = 0; i < 200; i++) {
		field.add({ 0.21f, -0.9f, 0.364f }, 0.05);
	}
	CHECK(field.is_good() && std::abs(field.turned() - degrees(30.0)) < degrees(0.2));
	for (int i = 0; i < 200; i++) {
		field.add({ 0.0f, -0.9f, 0.9f }, 0.05);
	}
	CHECK(field.is_known() && !field.is_good());
}

TEST_MAIN()
