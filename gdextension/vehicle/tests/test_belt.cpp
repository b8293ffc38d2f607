// SPDX-License-Identifier: MIT
#include <belt.hpp>

#include <check.hpp>

#include <chrono>
#include <cmath>
#include <limits>

namespace test_belt {

using namespace vehicle;

namespace {

constexpr int TEETH = 14;
constexpr float PITCH = 0.16f;
constexpr double RADIUS = TEETH * double(PITCH) / 6.283185307179586;

BeltSettings make_tank() {
	BeltSettings settings;
	settings.pitch = PITCH;
	settings.links = 90;
	settings.wheels.push_back({ 3.10f, 0.70f, float(RADIUS) });
	for (int i = 7; i >= 0; i--) {
		settings.wheels.push_back({ -(2.40f - 0.685f * i), 0.404f, 0.346f });
	}
	settings.first_sagging = settings.wheels.size();
	settings.wheels.push_back({ -3.06f, 0.69f, 0.306f });
	for (int i = 0; i < 4; i++) {
		settings.wheels.push_back({ -1.95f + 1.31f * i, 0.89f + 0.015f * i, 0.116f });
	}
	return settings;
}

Belt make_belt() {
	Belt belt;
	BeltSettings settings = make_tank();
	CHECK(belt.configure(settings));
	settings.links = size_t(belt.tight_length() / PITCH) + 1; // The first number that is long enough.
	CHECK(belt.configure(settings));
	return belt;
}

/// How far the nearest link at the sprocket is from the nearest tooth, along the pitch circle, m.
double phase_error(Belt &r_belt, double p_way) {
	std::vector<BeltLink> links;
	r_belt.lay(p_way, links);
	const double turned = r_belt.sprocket_angle(p_way);
	const double step = 6.283185307179586 / TEETH;
	double worst = 0.0;
	for (const BeltLink &link : links) {
		const double dz = link.z - 3.10;
		const double dy = link.y - 0.70;
		// Only links that lie on the teeth: behind the sprocket's middle.
		if (std::hypot(dz, dy) > RADIUS + 1e-3 || dz < 0.1) {
			continue;
		}
		const double from_tooth = std::remainder(std::atan2(dy, dz) - std::fmod(turned, 6.283185307179586), step);
		worst = std::max(worst, std::fabs(from_tooth) * RADIUS);
	}
	return worst;
}

} // namespace

TEST(links_follow_one_another_without_gaps) {
	Belt belt = make_belt();
	std::vector<BeltLink> links;
	belt.lay(0.05, links);
	for (size_t i = 0; i < links.size(); i++) {
		const BeltLink &one = links[i];
		const BeltLink &next = links[(i + 1) % links.size()];
		// From the end of one to the start of the next.
		const float z = next.z - one.z - 0.5f * PITCH * (one.along_z + next.along_z);
		const float y = next.y - one.y - 0.5f * PITCH * (one.along_y + next.along_y);
		CHECK(std::hypot(z, y) < 0.008f);
	}
}

TEST(no_link_is_inside_a_wheel) {
	Belt belt = make_belt();
	std::vector<BeltLink> links;
	belt.lay(1.234, links);
	for (const BeltLink &link : links) {
		for (const BeltWheel &wheel : make_tank().wheels) {
			// A straight link on a small roller dips by the chord's height.
			CHECK(std::hypot(link.z - wheel.z, link.y - wheel.y) > wheel.radius - 0.03f);
		}
	}
}

TEST(the_upper_run_hangs_and_the_lower_does_not) {
	Belt belt = make_belt();
	CHECK(belt.sag() > 0.01f);
	CHECK(belt.sag() <= 0.12f);
	CHECK_NEAR(belt.drawn_pitch(), PITCH, 0.0005);
	std::vector<BeltLink> links;
	belt.lay(0.0, links);
	for (const BeltLink &link : links) {
		if (link.y < 0.2f && std::fabs(link.z) < 2.3f) {
			CHECK_NEAR(link.y, 0.404f - 0.346f, 1e-3);
			CHECK(link.along_z < -0.99f);
		}
	}
}

TEST(a_longer_belt_hangs_deeper) {
	BeltSettings settings = make_tank();
	Belt belt;
	CHECK(belt.configure(settings));
	settings.links = size_t(belt.tight_length() / PITCH) + 1;
	CHECK(belt.configure(settings));
	const float sag = belt.sag();
	settings.pitch += 0.0004f;
	CHECK(belt.configure(settings));
	CHECK(belt.sag() > sag + 0.005f);
}

TEST(links_move_forward_over_the_top_and_back_on_the_ground) {
	Belt belt = make_belt();
	std::vector<BeltLink> before;
	std::vector<BeltLink> after;
	belt.lay(0.0, before);
	belt.lay(0.04, after);
	for (size_t i = 0; i < before.size(); i++) {
		if (std::fabs(before[i].z) < 2.0f) {
			const float moved = after[i].z - before[i].z;
			CHECK_NEAR(moved, before[i].y < 0.3f ? 0.04f : -0.04f, 0.003);
		}
	}
}

TEST(links_stay_on_the_teeth_over_a_kilometre) {
	Belt belt = make_belt();
	double worst = 0.0;
	for (int i = 0; i <= 20000; i++) {
		const double way = i * 0.05;
		for (size_t wheel = 1; wheel <= 8; wheel++) { // Rough ground.
			belt.set_lift(wheel, 0.08f * float(std::sin(way * 1.7 + double(wheel) * 0.9)));
		}
		worst = std::max(worst, phase_error(belt, way));
	}
	CHECK(worst < 0.010);
}

TEST(they_do_backwards_too) {
	Belt belt = make_belt();
	CHECK(phase_error(belt, -777.77) < 0.002);
}

TEST(a_lifted_wheel_bends_the_belt) {
	Belt belt = make_belt();
	belt.set_lift(4, 0.10f);
	std::vector<BeltLink> links;
	belt.lay(0.0, links);
	float highest = 0.0f;
	const float z = make_tank().wheels[4].z;
	for (const BeltLink &link : links) {
		if (link.y < 0.35f && std::fabs(link.z - z) < 0.2f) {
			highest = std::max(highest, link.y);
		}
	}
	CHECK(highest > 0.058f + 0.07f);
	CHECK(highest < 0.058f + 0.11f);
}

TEST(a_step_never_makes_links_jump) {
	Belt belt = make_belt();
	std::vector<BeltLink> before;
	std::vector<BeltLink> after;
	for (int i = 0; i <= 2000; i++) {
		const double way = i * 0.01;
		for (size_t wheel = 1; wheel <= 8; wheel++) {
			belt.set_lift(wheel, 0.08f * float(std::sin(way * 2.0 + double(wheel) * 1.3)));
		}
		belt.lay(way, after);
		// Every pitch the numbers of the links shift by one.
		const size_t shift = size_t(std::floor(way / double(PITCH)) - std::floor((way - 0.01) / double(PITCH)));
		for (size_t link = 0; link < before.size(); link++) {
			const BeltLink &old = before[(link + shift) % before.size()];
			CHECK(std::hypot(after[link].z - old.z, after[link].y - old.y) < 0.03f);
		}
		before = after;
	}
}

TEST(settings_without_sense_are_refused) {
	Belt belt;
	std::vector<BeltLink> links(5);
	CHECK(!belt.configure({}));
	belt.lay(0.0, links);
	CHECK(links.empty());
	BeltSettings settings = make_tank();
	settings.pitch = -0.1f;
	CHECK(!belt.configure(settings));
	settings = make_tank();
	settings.wheels[3].radius = std::numeric_limits<float>::quiet_NaN();
	CHECK(!belt.configure(settings));
	settings = make_tank();
	settings.wheels[3] = settings.wheels[2];
	CHECK(!belt.configure(settings));
}

TEST(a_belt_is_laid_in_no_time) {
	Belt belt = make_belt();
	std::vector<BeltLink> links;
	const auto start = std::chrono::steady_clock::now();
	for (int i = 0; i < 2000; i++) {
		belt.lay(i * 0.013, links);
	}
	const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - start;
	std::printf("%.2f us a belt of %zu links\n", took.count() / 2000.0, links.size());
	CHECK(links.size() > 80);
}

} // namespace test_belt
