// SPDX-License-Identifier: MIT
#include <impact_detector.hpp>

#include <check.hpp>

#include <cmath>
#include <limits>

namespace test_impact_detector {

using namespace contact;

namespace {

constexpr float WEIGHT = 20.0f * 9.81f / 60.0f; // Of 20 kg in a step, N s.

Touch touch(float p_impulse, float p_slip = 0.0f, std::uint64_t p_other = 7) {
	return { { 3, p_other }, p_impulse, 20.0f, p_slip, 0 };
}

std::size_t count(ImpactDetector &r_detector, const Touch &p_touch, int p_steps) {
	std::size_t found = 0;
	for (int i = 0; i < p_steps; i++) {
		found += r_detector.advance({ p_touch }, 16).size();
	}
	return found;
}

} // namespace

TEST(what_falls_is_heard_once) {
	ImpactDetector detector;
	const auto found = detector.advance({ touch(60.0f) }, 16);
	CHECK(found.size() == 1 && found[0].impulse == 60.0f && found[0].slip == 0.0f);
	CHECK(count(detector, touch(WEIGHT), 600) == 0);
}

TEST(what_is_laid_down_or_wakes_is_silent) {
	ImpactDetector detector;
	CHECK(count(detector, touch(WEIGHT), 60) == 0);
	CHECK(detector.advance({}, 16).empty());
	for (int i = 0; i < 60; i++) {
		detector.advance({}, 16);
	}
	CHECK(count(detector, touch(WEIGHT), 60) == 0);
}

TEST(a_blow_on_what_rests_is_heard) {
	ImpactDetector detector;
	count(detector, touch(WEIGHT), 60);
	CHECK(count(detector, touch(10.0f * WEIGHT), 1) == 1);
	CHECK(count(detector, touch(10.0f * WEIGHT), 3) == 0);
}

TEST(bounces_within_50_ms_are_one) {
	ImpactDetector detector;
	CHECK(count(detector, touch(60.0f), 3) == 1);
	for (int i = 0; i < 10; i++) {
		detector.advance({}, 16);
	}
	CHECK(count(detector, touch(30.0f), 1) == 1);
}

TEST(what_slides_scrapes_ten_times_a_second) {
	ImpactDetector detector;
	const std::size_t found = count(detector, touch(WEIGHT, 1.5f), 60);
	CHECK(found >= 9 && found <= 10);
	CHECK(count(detector, touch(WEIGHT, 0.1f), 60) == 0);
}

TEST(the_strongest_are_kept) {
	ImpactDetector detector;
	std::vector<Touch> touches;
	touches.reserve(100);
	for (std::uint64_t i = 0; i < 100; i++) {
		touches.push_back(touch(10.0f + float(i), 0.0f, 100 + i));
	}
	const auto found = detector.advance(touches, 8);
	CHECK(found.size() == 8 && found[0].impulse == 109.0f && found[7].impulse == 102.0f);
}

TEST(contacts_of_a_pair_are_added) {
	ImpactDetector detector;
	Touch second = touch(6.0f);
	second.tag = 5;
	const auto found = detector.advance({ touch(4.0f), second }, 8);
	CHECK(found.size() == 1 && found[0].impulse == 10.0f && found[0].tag == 5);
}

TEST(numbers_that_are_none_are_left_out) {
	ImpactDetector detector;
	const float nan = std::numeric_limits<float>::quiet_NaN();
	CHECK(detector.advance({ touch(nan), touch(-5.0f), touch(50.0f, nan) }, 8).empty());
}

TEST(pairs_are_forgotten) {
	ImpactDetector detector;
	count(detector, touch(50.0f), 1);
	CHECK(detector.pair_count() == 1);
	detector.forget(7);
	CHECK(detector.pair_count() == 0);
	count(detector, touch(50.0f), 1);
	for (int i = 0; i < 300; i++) {
		detector.advance({}, 8);
	}
	CHECK(detector.pair_count() == 0);
}

} // namespace test_impact_detector
