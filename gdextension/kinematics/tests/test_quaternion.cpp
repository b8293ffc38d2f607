// SPDX-License-Identifier: MIT
#include "quaternion.hpp"

#include "check.hpp"

#include <random>

namespace test_quaternion {

using namespace kinematics;

namespace {

constexpr float PI = 3.14159265f;

Vec3 random_vector(std::mt19937 &p_random, float p_length) {
	std::normal_distribution<float> normal;
	const Vec3 vector{ normal(p_random), normal(p_random), normal(p_random) };
	return vector * (p_length / vector.length());
}

} // namespace

TEST(exp_and_log_are_inverse) {
	std::mt19937 random(1);
	for (int i = 0; i < 2000; i++) {
		const float angle = 3.1f * float(i) / 2000.0f;
		const Vec3 vector = random_vector(random, angle);
		const Vec3 back = log(exp(vector));
		CHECK_NEAR((back - vector).length(), 0.0, 2e-4);
		CHECK_NEAR(exp(vector).dot(exp(vector)), 1.0, 1e-5);
	}
}

TEST(log_takes_the_short_way_for_both_signs) {
	const Quat turn = exp({ 0.0f, 0.4f, 0.0f });
	CHECK_NEAR(log(turn).y, 0.4, 1e-6);
	CHECK_NEAR(log(-turn).y, 0.4, 1e-6);
	CHECK_NEAR(log(exp({ 0.0f, PI + 0.5f, 0.0f })).y, 0.5 - PI, 1e-5);
	CHECK_NEAR(log(Quat()).length(), 0.0, 0.0);
}

TEST(rotate_agrees_with_the_product) {
	std::mt19937 random(2);
	for (int i = 0; i < 500; i++) {
		const Quat turn = exp(random_vector(random, 2.0f));
		const Vec3 vector = random_vector(random, 3.0f);
		const Quat product = turn * Quat{ vector.x, vector.y, vector.z, 0.0f } * turn.inverse();
		const Vec3 rotated = turn.rotate(vector);
		CHECK_NEAR((rotated - Vec3{ product.x, product.y, product.z }).length(), 0.0, 1e-5);
	}
	const Vec3 turned = exp({ 0.0f, PI / 2, 0.0f }).rotate({ 1.0f, 0.0f, 0.0f });
	CHECK_NEAR(turned.z, -1.0, 1e-6); // Right-handed: +X goes to -Z about +Y.
}

TEST(slerp_meets_its_ends_and_goes_on_beyond) {
	const Quat from = exp({ 0.3f, 0.0f, 0.0f });
	const Quat to = exp({ 0.5f, 0.0f, 0.0f });
	CHECK_NEAR(log(slerp(from, to, 0.0f)).x, 0.3, 1e-5);
	CHECK_NEAR(log(slerp(from, to, 1.0f)).x, 0.5, 1e-5);
	CHECK_NEAR(log(slerp(from, -to, 0.5f)).x, 0.4, 1e-5);
	CHECK_NEAR(log(slerp(from, to, 2.0f)).x, 0.7, 1e-5);
}

TEST(axes_make_the_rotation_that_makes_them) {
	std::mt19937 random(9);
	std::normal_distribution<float> normal;
	for (int i = 0; i < 500; i++) {
		const Quat turn = exp({ normal(random) * 2.0f, normal(random) * 2.0f, normal(random) * 2.0f });
		const Quat again = from_axes(turn.rotate({ 1, 0, 0 }), turn.rotate({ 0, 1, 0 }), turn.rotate({ 0, 0, 1 }));
		CHECK_NEAR(angle_between(turn, again), 0.0, 1e-3);
	}
}

} // namespace test_quaternion
