// SPDX-License-Identifier: MIT
#include <joint_motion.hpp>

#include <check.hpp>

#include <cmath>
#include <functional>

namespace test_joint_motion {

using namespace heading;
using kinematics::Quat;
using kinematics::Vec3;

namespace {

constexpr int FOREARM = 5;
constexpr int UPPER_ARM = 4;
const Levers LEVERS{ { 0.15f, -0.03f, 0.02f }, { -0.2f, -0.02f, 0.0f } };

Quat yaw(double p_angle) {
	return kinematics::exp({ 0.0f, float(p_angle), 0.0f });
}

/// How the elbow is carried, and how both of its limbs turn about it.
struct Arm {
	double reach = 0.0;
	double swing = 0.0;

	Vec3 elbow(double p_time) const {
		return { float(reach * std::sin(4.0 * p_time)), float(reach * std::cos(3.0 * p_time)),
			float(reach * std::sin(5.0 * p_time + 1.0)) };
	}
	Quat limb(int p_mount, double p_time) const {
		const double late = p_mount == FOREARM ? 0.7 : 0.0;
		return kinematics::exp({ float(swing * std::sin(3.0 * p_time + late)),
				float(swing * std::sin(4.4 * p_time - late)), float(swing * std::cos(3.7 * p_time + late)) });
	}
	Vec3 sensor(int p_mount, double p_time) const {
		const Vec3 lever = p_mount == FOREARM ? LEVERS.own : LEVERS.above;
		return elbow(p_time) - limb(p_mount, p_time).rotate(lever);
	}
	/// With gravity, m/s².
	Vec3 acceleration(int p_mount, double p_time) const {
		constexpr double STEP = 0.02;
		const Vec3 bent =
				sensor(p_mount, p_time + STEP) + sensor(p_mount, p_time - STEP) - sensor(p_mount, p_time) * 2.0f;
		return bent * float(1.0 / (STEP * STEP)) + Vec3{ 0.0f, 9.81f, 0.0f };
	}
};

/// What is seen of an arm in 20 s whose forearm's heading is off by p_turned; p_spoil may change moments.
std::vector<JointMotion::Sight> watch(const Arm &p_arm, double p_turned, double p_rate_hz,
		const std::function<void(double, std::array<Vec3, MOUNTS> &)> &p_spoil = nullptr) {
	JointMotion motion;
	motion.set_levers(FOREARM, LEVERS);
	for (int i = 0; i < int(20.0 * p_rate_hz); i++) {
		const double time = i / p_rate_hz;
		std::array<bool, MOUNTS> present{};
		std::array<Quat, MOUNTS> rotations{};
		std::array<Vec3, MOUNTS> accelerations{};
		for (const int mount : { UPPER_ARM, FOREARM }) {
			const Quat world = yaw(mount == FOREARM ? p_turned : 0.0);
			present[std::size_t(mount)] = true;
			rotations[std::size_t(mount)] = world * p_arm.limb(mount, time);
			accelerations[std::size_t(mount)] = world.rotate(p_arm.acceleration(mount, time));
		}
		if (p_spoil) {
			p_spoil(time, accelerations);
		}
		motion.add({ 1000.0 + time, present, rotations, accelerations });
	}
	return motion.take();
}

/// How far both sides of a sight are apart, m/s², where the forearm's heading is off by p_turned.
double apart(const JointMotion::Sight &p_sight, double p_turned) {
	const Vec3 off = p_sight.own.joint(LEVERS.own) - yaw(p_turned).rotate(p_sight.above.joint(LEVERS.above));
	return std::hypot(double(off.x), double(off.z));
}

} // namespace

TEST(both_sides_of_a_joint_are_turned_as_their_headings_are) {
	for (const double rate : { 25.0, 60.0, 100.0 }) {
		for (const double angle : { 0.0, 0.5, -2.0 }) {
			const std::vector<JointMotion::Sight> sights = watch({ 0.1, 0.8 }, angle, rate);
			CHECK(sights.size() > 20);
			double worst = 0.0;
			for (const JointMotion::Sight &sight : sights) {
				CHECK(sight.mount == FOREARM);
				worst = std::max(worst, apart(sight, angle));
			}
			// Of 1 to 2 m/s²; what they are always off is learnt from them too.
			CHECK(worst < 0.15);
		}
	}
}

TEST(limbs_that_turn_about_an_elbow_at_rest_tell_nothing) {
	CHECK(watch({ 0.0, 0.8 }, 0.5, 100.0).empty());
	CHECK(watch({ 0.0, 0.0 }, 0.5, 100.0).empty());
}

TEST(gaps_knocks_and_unknown_accelerations_are_no_movement) {
	const Arm arm{ 0.1, 0.8 };
	CHECK(watch(arm, 0.5, 5.0).empty());
	CHECK(watch(arm, 0.5, 50.0, [](double, std::array<Vec3, MOUNTS> &r_accelerations) {
		r_accelerations[FOREARM] = Vec3();
	}).empty());
	const std::size_t all = watch(arm, 0.5, 50.0).size();
	const std::size_t some = watch(arm, 0.5, 50.0, [](double p_time, std::array<Vec3, MOUNTS> &r_accelerations) {
		if (std::fmod(p_time, 2.0) < 0.02) {
			r_accelerations[UPPER_ARM] = { 150.0f, 0.0f, 0.0f };
		}
	}).size();
	CHECK(some > 0 && some < all * 2 / 3);
}

TEST(what_an_acceleration_is_always_off_is_no_movement) {
	// A desk that tilts, or a sensor that is not level: it goes on for ever.
	const std::vector<JointMotion::Sight> sights =
			watch({ 0.0, 0.0 }, 0.0, 50.0, [](double, std::array<Vec3, MOUNTS> &r_accelerations) {
				r_accelerations[FOREARM].x += 0.3f;
				r_accelerations[UPPER_ARM].z += 0.3f;
			});
	CHECK(sights.size() < 30);
}

TEST(joints_that_nobody_set_are_not_looked_at) {
	JointMotion motion;
	std::array<bool, MOUNTS> present{};
	std::array<Quat, MOUNTS> rotations{};
	std::array<Vec3, MOUNTS> accelerations{};
	present.fill(true);
	for (int i = 0; i < 200; i++) {
		accelerations.fill({ float(std::sin(0.2 * i)), 9.81f, 0.0f });
		motion.add({ i * 0.02, present, rotations, accelerations });
	}
	CHECK(motion.take().empty());
}

} // namespace test_joint_motion
