// SPDX-License-Identifier: MIT
#include <drift_estimator.hpp>

#include <check.hpp>

#include <cmath>

namespace test_drift_estimator {

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

/// Somebody whose upper arm and forearm are in another posture every few seconds and never the same
/// for long, while the elbow is moved about; the forearm drifts by RATE. Levers are off by some cm.
double off_of_a_forearm(bool p_is_accelerated, double p_seconds) {
	constexpr int UPPER_ARM = 4;
	constexpr int FOREARM = 5;
	const Levers levers{ { 0.15f, -0.03f, 0.02f }, { -0.2f, -0.02f, 0.0f } };
	const auto limb = [](int p_mount, double p_time) {
		const double late = p_mount == FOREARM ? 0.7 : 0.0;
		return kinematics::exp({ 0.4f * float(std::sin(3.0 * p_time + late)),
				1.2f * float(std::sin(0.31 * p_time * (1.0 + late)) + std::sin(0.17 * p_time + late)),
				0.4f * float(std::cos(3.7 * p_time + late)) });
	};
	const auto sensor = [&limb, &levers](int p_mount, double p_time) {
		const kinematics::Vec3 elbow{ 0.1f * float(std::sin(4.0 * p_time)), 0.0f,
			0.1f * float(std::sin(5.0 * p_time)) };
		return elbow - limb(p_mount, p_time).rotate(p_mount == FOREARM ? levers.own : levers.above);
	};
	DriftEstimator estimator;
	estimator.set_levers(FOREARM, { { 0.19f, 0.0f, 0.0f }, { -0.16f, 0.02f, 0.03f } });
	for (int i = 0; i < int(p_seconds * 50.0); i++) {
		const double time = i * 0.02;
		DriftEstimator::Sample sample;
		sample.time = 1000.0 + time;
		for (const int mount : { UPPER_ARM, FOREARM }) {
			const kinematics::Quat drift = yaw(mount == FOREARM ? RATE * time : 0.0);
			sample.present[std::size_t(mount)] = true;
			sample.rotations[std::size_t(mount)] = drift * limb(mount, time);
			if (p_is_accelerated) {
				const kinematics::Vec3 bent =
						sensor(mount, time + 0.02) + sensor(mount, time - 0.02) - sensor(mount, time) * 2.0f;
				sample.accelerations[std::size_t(mount)] =
						drift.rotate(bent * 2500.0f + kinematics::Vec3{ 0.0f, 9.81f, 0.0f });
			}
		}
		estimator.add(sample);
	}
	const double between = estimator.correction(FOREARM) - estimator.correction(UPPER_ARM);
	return std::abs(between - RATE * p_seconds);
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

TEST(a_joint_that_moves_tells_the_drift_in_any_posture) {
	CHECK(off_of_a_forearm(true, 240.0) < degrees(2.0));
	CHECK(off_of_a_forearm(false, 240.0) > degrees(5.0));
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

} // namespace test_drift_estimator
