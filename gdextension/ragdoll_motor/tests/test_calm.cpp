// SPDX-License-Identifier: MIT
#include "gait/path_filter.hpp"
#include "motion/pose_filter.hpp"

#include "check.hpp"

#include <random>

namespace test_calm {

using namespace ragdoll;

namespace {

constexpr float STEP_S = 1.0f / 60.0f;
constexpr float DEGREE = 0.0174533f;
constexpr std::size_t LIMBS = 5;

/// Limbs that swing about X by half a radian each way, once in a second, or rest.
std::vector<Quat> swinging(int p_tick, float p_amount = 0.5f) {
	return std::vector<Quat>(LIMBS, exp({ p_amount * std::sin(6.28318531f * float(p_tick) * STEP_S), 0.0f, 0.0f }));
}

struct Noise {
	std::mt19937 random{ 7 };
	std::normal_distribution<float> normal{ 0.0f, DEGREE };

	std::vector<Quat> on(std::vector<Quat> p_pose) {
		for (Quat &orientation : p_pose) {
			orientation = orientation * exp({ normal(random), normal(random), normal(random) });
		}
		return p_pose;
	}
};

} // namespace

TEST(motion_is_not_taken_for_noise) {
	PoseFilter filter(LIMBS);
	filter.begin(swinging(0, 1.5f));
	for (int tick = 1; tick < 300; tick++) {
		filter.advance(swinging(tick, 1.5f), STEP_S);
		CHECK(filter.get_noise() == 0.0f);
		CHECK_NEAR(angle_between(filter.get_orientation(2), swinging(tick, 1.5f)[2]), 0.0, 1e-4);
	}
	CHECK(filter.get_unrest() == 0.0f);
}

TEST(noise_is_measured_and_taken_out) {
	for (const float amount : { 0.0f, 0.5f }) {
		Noise noise;
		PoseFilter filter(LIMBS);
		filter.begin(noise.on(swinging(0, amount)));
		double raw = 0.0;
		double left = 0.0;
		for (int tick = 1; tick < 600; tick++) {
			const std::vector<Quat> sampled = noise.on(swinging(tick, amount));
			filter.advance(sampled, STEP_S);
			if (tick > 120) {
				raw += double(angle_between(sampled[1], swinging(tick, amount)[1]));
				left += double(angle_between(filter.get_orientation(1), swinging(tick, amount)[1]));
			}
		}
		CHECK_NEAR(filter.get_noise(), DEGREE, 0.3f * DEGREE);
		CHECK(left < (amount > 0.0f ? 0.85 : 0.6) * raw);
	}
}

TEST(a_blow_to_one_limb_is_no_noise) {
	PoseFilter filter(LIMBS);
	std::vector<Quat> pose(LIMBS);
	filter.begin(pose);
	for (int tick = 1; tick < 60; tick++) {
		pose[3] = exp({ tick > 30 ? 0.8f : 0.0f, 0.0f, 0.0f });
		filter.advance(pose, STEP_S);
		CHECK(filter.get_noise() == 0.0f);
	}
}

TEST(irregular_samples_do_not_pass_for_noise) {
	PoseFilter filter(LIMBS);
	filter.begin(swinging(0));
	int tick = 0;
	for (int i = 0; i < 300; i++) {
		const int lost = i % 7 == 3 ? 3 : 1;
		tick += lost;
		filter.advance(swinging(tick), STEP_S * float(lost));
		CHECK(filter.get_noise() == 0.0f);
	}
}

TEST(a_saved_filter_goes_on_the_same) {
	Noise noise;
	PoseFilter filter(LIMBS);
	PoseFilter copy(LIMBS);
	filter.begin(swinging(0));
	for (int tick = 1; tick < 100; tick++) {
		filter.advance(noise.on(swinging(tick)), STEP_S);
	}
	ArchiveWriter archive;
	filter.save(archive);
	ArchiveReader reader(archive.get_bytes().data(), archive.get_bytes().size());
	CHECK(copy.restore(reader) && reader.is_at_end());
	for (int tick = 100; tick < 120; tick++) {
		const std::vector<Quat> sampled = noise.on(swinging(tick));
		filter.advance(sampled, STEP_S);
		copy.advance(sampled, STEP_S);
		CHECK(filter.get_noise() == copy.get_noise());
		CHECK(filter.get_orientation(4).x == copy.get_orientation(4).x);
		CHECK(filter.get_rate(4).x == copy.get_rate(4).x);
	}
}

TEST(a_path_keeps_its_momentum_under_noise) {
	Noise noise;
	PathFilter clean;
	PathFilter shaken;
	Vec3 before;
	double steps = 0.0;
	for (int tick = 0; tick < 300; tick++) {
		const Vec3 position{ 1.2f * float(tick) * STEP_S, 0.9f, 0.0f };
		const Vec3 off{ noise.normal(noise.random), noise.normal(noise.random), noise.normal(noise.random) };
		clean.advance(position, 0.0f, STEP_S);
		shaken.advance(position + off * 0.5f, DEGREE, STEP_S);
		CHECK_NEAR((clean.get_position() - position).length(), 0.0, 1e-5);
		if (tick > 120) {
			steps += double((shaken.get_position() - before - Vec3{ 1.2f * STEP_S, 0.0f, 0.0f }).length()) / 179.0;
			CHECK((shaken.get_position() - position).length() < 0.03f);
		}
		before = shaken.get_position();
	}
	CHECK(steps < 0.006); // Unfiltered: 0.02 m a tick.
	shaken.shift({ 0.0f, 0.0f, 1.0f });
	CHECK_NEAR(shaken.get_position().z, before.z + 1.0f, 1e-6);
	ArchiveWriter archive;
	shaken.save(archive);
	ArchiveReader reader(archive.get_bytes().data(), archive.get_bytes().size());
	CHECK(clean.restore(reader) && reader.is_at_end());
	CHECK(clean.ahead(0.1f).x == shaken.ahead(0.1f).x);
}

} // namespace test_calm
