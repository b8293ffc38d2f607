// SPDX-License-Identifier: MIT
#include "boxes.hpp"

#include <light_tracer.hpp>

#include <check.hpp>

#include <cmath>

namespace test_light_tracer {

using namespace level;

namespace {

constexpr Vec3 GREY{ 0.5f, 0.5f, 0.5f };

std::size_t nearest(const BlockMesh &p_mesh, const Vec3 &p_point, const Vec3 &p_normal) {
	std::size_t best = 0;
	float least = 1e30f;
	for (std::size_t index = 0; index < p_mesh.points().size(); index++) {
		const float distance = (p_mesh.points()[index] - p_point).length();
		if (distance < least && p_mesh.normals()[index].dot(p_normal) > 0.9f) {
			least = distance;
			best = index;
		}
	}
	return best;
}

void prepare(LightTracer &r_tracer, const BlockMesh &p_mesh) {
	r_tracer.suns = { Vec3{ 0.966f, 0.259f, 0.0f }, Vec3{ 0.0f, 0.906f, 0.423f }, Vec3{ -0.966f, 0.259f, 0.0f } };
	r_tracer.add(p_mesh.points(), p_mesh.normals(), p_mesh.indices(), boxes::colours(p_mesh, GREY));
}

} // namespace

TEST(an_open_plane_gets_the_whole_sky_and_nothing_else) {
	BlockMesh mesh;
	mesh.face({ -50.0f, 0.0f, 50.0f }, { 1.0f, 0.0f, 0.0f }, { 0.0f, 0.0f, -1.0f }, 100.0f, 100.0f, {});
	LightTracer tracer;
	prepare(tracer, mesh);
	tracer.bake();
	const Light &light = tracer.light(nearest(mesh, {}, { 0.0f, 1.0f, 0.0f }));
	CHECK_NEAR(light[LIGHT_SKY].x, 1.0, 1e-3);
	CHECK_NEAR(light[LIGHT_NOON].x, 0.0, 1e-3);
	CHECK_NEAR(light[LIGHT_LAMPS].x, 0.0, 1e-6);
}

TEST(a_wall_sees_half_the_sky_and_half_the_ground) {
	BlockMesh mesh;
	mesh.face({ -60.0f, 0.0f, 60.0f }, { 1.0f, 0.0f, 0.0f }, { 0.0f, 0.0f, -1.0f }, 120.0f, 120.0f, {});
	mesh.box({ -0.2f, 0.0f, -3.0f }, { 0.2f, 3.0f, 3.0f }, {});
	LightTracer tracer;
	tracer.rays = 256;
	tracer.bounces = 0;
	prepare(tracer, mesh);
	tracer.bake();
	// Half of the sky; the ground below throws back albedo times what it gets, 0.5 of 1, into the other half.
	// (Without bounces the ground has not been lit by the sky yet.)
	const std::size_t wall = nearest(mesh, { 0.2f, 1.5f, 0.0f }, { 1.0f, 0.0f, 0.0f });
	CHECK_NEAR(tracer.light(wall)[LIGHT_SKY].x, 0.5, 0.03);
	// The noon's sun falls on the ground with the sine of its height; half of what the ground throws back.
	CHECK_NEAR(tracer.light(wall)[LIGHT_NOON].x, 0.5 * 0.5 * 0.906, 0.04);
	LightTracer more;
	more.rays = 256;
	more.bounces = 1;
	prepare(more, mesh);
	more.bake();
	CHECK_NEAR(more.light(wall)[LIGHT_SKY].x, 0.75, 0.06);
}

TEST(a_closed_room_is_dark_and_a_door_lets_light_in) {
	const Vec3 middle{ 0.0f, 0.05f, 0.0f };
	float sky[2] = {};
	for (int door = 0; door < 2; door++) {
		const BlockMesh mesh = boxes::room(door == 1);
		LightTracer tracer;
		prepare(tracer, mesh);
		tracer.bake();
		sky[door] = tracer.light(nearest(mesh, middle, { 0.0f, 1.0f, 0.0f }))[LIGHT_SKY].x;
	}
	CHECK_NEAR(sky[0], 0.0, 1e-3);
	CHECK(sky[1] > 0.01f && sky[1] < 0.4f);
}

TEST(a_lamp_lights_its_room_and_no_other) {
	const BlockMesh mesh = boxes::room(false);
	LightTracer tracer;
	prepare(tracer, mesh);
	tracer.lamps.push_back({ { 0.0f, 2.0f, 0.0f }, { 4.0f, 2.0f, 1.0f }, 20.0f });
	tracer.bake();
	const Light &inside = tracer.light(nearest(mesh, { 0.0f, 0.05f, 0.0f }, { 0.0f, 1.0f, 0.0f }));
	// Straight from it, 2 m away, 4 / 2^2, faded a little, and thrown back from six walls.
	CHECK(inside[LIGHT_LAMPS].x > 0.95f && inside[LIGHT_LAMPS].x < 2.0f);
	CHECK_NEAR(inside[LIGHT_LAMPS].x / inside[LIGHT_LAMPS].y, 2.0, 1e-3);
	const Light &outside = tracer.light(nearest(mesh, { 10.0f, 0.0f, 0.0f }, { 0.0f, 1.0f, 0.0f }));
	CHECK_NEAR(outside[LIGHT_LAMPS].x, 0.0, 1e-3);
	// What moves in the room is lit too.
	Light above;
	Light below;
	CHECK(tracer.gather_at({ 0.0f, 1.0f, 1.0f }, above, below));
	CHECK(above[LIGHT_LAMPS].x > 0.3f);
	CHECK(!tracer.gather_at({ 3.15f, 1.0f, 0.0f }, above, below));
}

TEST(threads_do_not_change_the_light) {
	const BlockMesh mesh = boxes::room(true);
	LightTracer one;
	LightTracer four;
	one.threads = 1;
	four.threads = 4;
	prepare(one, mesh);
	prepare(four, mesh);
	one.bake();
	four.bake();
	bool same = true;
	for (std::size_t index = 0; index < one.vertex_count(); index++) {
		for (int set = 0; set < LIGHT_SETS; set++) {
			same = same && (one.light(index)[set] - four.light(index)[set]).length() == 0.0f;
		}
	}
	CHECK(same);
	CHECK_NEAR(four.progress(), 1.0, 0.0);
}

TEST(corners_inside_a_wall_take_the_light_of_their_neighbours) {
	// A post stands on a vertex of the ground: without care it would draw a dark star around itself.
	BlockMesh mesh;
	mesh.face({ -10.0f, 0.0f, 10.0f }, { 1.0f, 0.0f, 0.0f }, { 0.0f, 0.0f, -1.0f }, 20.0f, 20.0f, {});
	mesh.box({ -0.3f, -0.5f, -0.3f }, { 0.3f, 0.6f, 0.3f }, {});
	LightTracer tracer;
	prepare(tracer, mesh);
	tracer.bake();
	CHECK(tracer.light(nearest(mesh, {}, { 0.0f, 1.0f, 0.0f }))[LIGHT_SKY].x > 0.6f);
}

} // namespace test_light_tracer
