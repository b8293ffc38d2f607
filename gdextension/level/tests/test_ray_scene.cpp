// SPDX-License-Identifier: MIT
#include "boxes.hpp"

#include <ray_scene.hpp>

#include <check.hpp>

#include <random>

namespace test_ray_scene {

using namespace level;

namespace {

float draw(std::mt19937 &p_random, float p_most) {
	return std::uniform_real_distribution<float>(-p_most, p_most)(p_random);
}

Vec3 draw_point(std::mt19937 &p_random, float p_most) {
	return { draw(p_random, p_most), draw(p_random, p_most), draw(p_random, p_most) };
}

// Every triangle asked, one after the other, in double precision.
Hit slowly(const std::vector<Triangle> &p_triangles, const Vec3 &p_from, const Vec3 &p_way) {
	Hit nearest;
	nearest.distance = 1e30f;
	for (std::size_t number = 0; number < p_triangles.size(); number++) {
		const Triangle &triangle = p_triangles[number];
		const Vec3 normal = triangle.normal();
		const double speed = double(normal.dot(p_way));
		if (speed == 0.0) {
			continue;
		}
		const double distance = double(normal.dot(triangle.a - p_from)) / speed;
		const Vec3 at = p_from + p_way * float(distance);
		const bool is_in = normal.dot((triangle.b - triangle.a).cross(at - triangle.a)) <= 0.0f &&
				normal.dot((triangle.c - triangle.b).cross(at - triangle.b)) <= 0.0f &&
				normal.dot((triangle.a - triangle.c).cross(at - triangle.c)) <= 0.0f;
		if (is_in && distance > 1e-4 && distance < double(nearest.distance)) {
			nearest = { uint32_t(number), float(distance), speed > 0.0 };
		}
	}
	return nearest;
}

} // namespace

TEST(finds_what_asking_each_triangle_finds) {
	std::mt19937 random(5);
	std::vector<Triangle> triangles;
	for (int number = 0; number < 400; number++) {
		const Vec3 corner = draw_point(random, 10.0f);
		triangles.push_back({ corner, corner + draw_point(random, 2.0f), corner + draw_point(random, 2.0f) });
	}
	RayScene scene;
	scene.build(triangles);
	int same = 0;
	int met = 0;
	constexpr int RAYS = 2000;
	for (int ray = 0; ray < RAYS; ray++) {
		const Vec3 from = draw_point(random, 15.0f);
		const Vec3 way = draw_point(random, 1.0f);
		const Hit quick = scene.closest(from, way, 1000.0f);
		const Hit slow = slowly(triangles, from, way);
		const bool agrees =
				quick.triangle == slow.triangle && (quick.triangle == Hit::NOTHING || quick.is_back == slow.is_back);
		same += agrees ? 1 : 0;
		met += slow.triangle != Hit::NOTHING ? 1 : 0;
		CHECK(scene.is_blocked(from, from + way * 1000.0f) == (quick.triangle != Hit::NOTHING));
	}
	// Some rays pass within rounding of an edge.
	CHECK(same >= RAYS - 4);
	CHECK(met > RAYS / 10);
}

TEST(tells_the_front_from_the_back) {
	RayScene scene;
	scene.build(boxes::triangles(boxes::room(false)));
	const Hit outside = scene.closest({ 10.0f, 1.5f, 0.0f }, { -1.0f, 0.0f, 0.0f }, 100.0f);
	CHECK(!outside.is_back);
	CHECK_NEAR(outside.distance, 6.7, 1e-4);
	const Hit in_the_wall = scene.closest({ 3.15f, 1.5f, 0.0f }, { -1.0f, 0.0f, 0.0f }, 100.0f);
	CHECK(in_the_wall.is_back);
}

TEST(stops_at_the_farthest) {
	RayScene scene;
	scene.build(boxes::triangles(boxes::room(false)));
	CHECK(scene.closest({ 10.0f, 1.5f, 0.0f }, { -1.0f, 0.0f, 0.0f }, 6.0f).triangle == Hit::NOTHING);
	CHECK(!scene.is_blocked({ 10.0f, 1.5f, 0.0f }, { 3.4f, 1.5f, 0.0f }));
	CHECK(scene.is_blocked({ 10.0f, 1.5f, 0.0f }, { 2.0f, 1.5f, 0.0f }));
}

TEST(leaves_out_what_is_no_triangle) {
	const float nan = std::numeric_limits<float>::quiet_NaN();
	RayScene scene;
	scene.build({ { {}, {}, {} }, { { nan, 0.0f, 0.0f }, { 1.0f, 0.0f, 0.0f }, { 0.0f, 1.0f, 0.0f } } });
	CHECK(scene.closest({ 0.0f, 0.0f, 5.0f }, { 0.0f, 0.0f, -1.0f }, 10.0f).triangle == Hit::NOTHING);
	CHECK(!scene.is_blocked({ 0.0f, 0.0f, 5.0f }, { 0.0f, 0.0f, -5.0f }));
}

} // namespace test_ray_scene
