// SPDX-License-Identifier: MIT
#include "boxes.hpp"

#include <visibility.hpp>

#include <check.hpp>

namespace test_visibility {

using namespace level;

namespace {

/// Rooms of 8 m side by side along X, with doors of 1 m between the first two and the last two; each has
/// a crate, which is a part.
struct Rooms {
	std::vector<Triangle> triangles;
	std::vector<int32_t> part_of;
	RayScene scene;
	CellGrid grid{ { -12.0f, 0.0f, -4.0f }, 4.0f, { 8, 1, 2 } };

	void add(const BlockMesh &p_mesh, int p_part) {
		for (const Triangle &triangle : boxes::triangles(p_mesh)) {
			triangles.push_back(triangle);
			part_of.push_back(p_part);
		}
	}

	Rooms() {
		BlockMesh walls;
		walls.box({ -13.0f, -1.0f, -5.0f }, { 21.0f, 0.0f, 5.0f }, {});
		walls.box({ -13.0f, 4.0f, -5.0f }, { 21.0f, 5.0f, 5.0f }, {});
		walls.box({ -13.0f, 0.0f, -5.0f }, { 21.0f, 4.0f, -4.0f }, {});
		walls.box({ -13.0f, 0.0f, 4.0f }, { 21.0f, 4.0f, 5.0f }, {});
		for (int wall = 0; wall < 5; wall++) {
			const float x = -12.0f + 8.0f * float(wall);
			const bool has_door = wall == 1 || wall == 3;
			walls.box({ x - 0.2f, 0.0f, -4.0f }, { x + 0.2f, 4.0f, has_door ? -0.5f : 4.0f }, {});
			if (has_door) {
				walls.box({ x - 0.2f, 0.0f, 0.5f }, { x + 0.2f, 4.0f, 4.0f }, {});
			}
		}
		add(walls, -1);
		for (int room = 0; room < 4; room++) {
			BlockMesh crate;
			const float x = -8.0f + 8.0f * float(room);
			crate.box({ x - 0.3f, 0.0f, -0.3f }, { x + 0.3f, 0.6f, 0.3f }, {});
			add(crate, room);
		}
		scene.build(triangles);
	}
};

/// What a part is for the small cell in which a place lies.
uint8_t seen(const Visibility &p_visibility, const Vec3 &p_place, int p_parts, int p_part) {
	const CellGrid &small = p_visibility.small_cells();
	const Vec3 at = (p_place - small.origin) * (1.0f / small.size);
	const std::size_t cell = small.number_of({ int(at.x), int(at.y), int(at.z) });
	return p_visibility.parts()[cell * p_parts + p_part];
}

} // namespace

TEST(rooms_see_through_doors_and_not_through_walls) {
	const Rooms rooms;
	Visibility visibility(rooms.scene, rooms.triangles, rooms.part_of, 4, rooms.grid);
	visibility.survey();
	const std::size_t first = rooms.grid.number_of({ 1, 0, 0 });
	const std::size_t last = rooms.grid.number_of({ 6, 0, 1 });
	const Vec3 in_first{ -5.0f, 1.5f, -0.4f };
	const Vec3 in_last{ 13.0f, 1.5f, 0.4f };
	for (int part = 0; part < 4; part++) {
		CHECK(seen(visibility, in_first, 4, part) == (part < 2 ? 1 : 0));
		CHECK(seen(visibility, in_last, 4, part) == (part < 2 ? 0 : 1));
	}
	const std::size_t count = rooms.grid.cell_count();
	CHECK(visibility.cells()[first * count + first] == 1);
	CHECK(visibility.cells()[first * count + rooms.grid.number_of({ 2, 0, 1 })] == 1);
	CHECK(visibility.cells()[first * count + last] == 0);
	CHECK(visibility.cells()[last * count + first] == 0);
}

TEST(sight_is_mutual_and_the_same_with_any_number_of_threads) {
	const Rooms rooms;
	Visibility one(rooms.scene, rooms.triangles, rooms.part_of, 4, rooms.grid);
	Visibility four(rooms.scene, rooms.triangles, rooms.part_of, 4, rooms.grid);
	one.threads = 1;
	four.threads = 4;
	one.survey();
	four.survey();
	CHECK(one.parts() == four.parts());
	CHECK(one.cells() == four.cells());
	const std::size_t count = rooms.grid.cell_count();
	bool mutual = true;
	for (std::size_t from = 0; from < count; from++) {
		for (std::size_t to = 0; to < count; to++) {
			mutual = mutual && one.cells()[from * count + to] == one.cells()[to * count + from];
		}
	}
	CHECK(mutual);
}

TEST(what_is_seen_through_a_slit_only_is_found) {
	// A wall with a slit of 8 cm; each of ten posts behind it is a part.
	BlockMesh wall;
	wall.box({ 2.0f, -1.0f, -20.0f }, { 2.02f, 6.0f, -0.04f }, {});
	wall.box({ 2.0f, -1.0f, 0.04f }, { 2.02f, 6.0f, 20.0f }, {});
	std::vector<Triangle> triangles = boxes::triangles(wall);
	std::vector<int32_t> part_of(triangles.size(), -1);
	for (int part = 0; part < 10; part++) {
		BlockMesh post;
		const float z = 1.2f * (float(part) - 4.5f);
		post.box({ 12.0f, 0.0f, z - 0.3f }, { 12.4f, 2.0f, z + 0.3f }, {});
		for (const Triangle &triangle : boxes::triangles(post)) {
			triangles.push_back(triangle);
			part_of.push_back(part);
		}
	}
	RayScene scene;
	scene.build(triangles);
	Visibility visibility(scene, triangles, part_of, 10, { { -2.0f, 0.0f, -2.0f }, 4.0f, { 1, 1, 1 } });
	visibility.survey();
	for (int part = 0; part < 10; part++) {
		CHECK(seen(visibility, { 1.0f, 1.0f, part < 5 ? 0.5f : -0.5f }, 10, part) == 1);
	}
}

TEST(what_is_solid_through_and_through_has_no_air) {
	BlockMesh mesh;
	mesh.box({ 0.0f, 0.0f, 0.0f }, { 8.0f, 4.0f, 4.0f }, {});
	mesh.box({ -8.0f, 0.0f, 0.0f }, { -7.0f, 1.0f, 1.0f }, {});
	RayScene scene;
	const std::vector<Triangle> triangles = boxes::triangles(mesh);
	scene.build(triangles);
	const std::vector<int32_t> part_of(triangles.size(), 0);
	Visibility visibility(scene, triangles, part_of, 1, { { -8.0f, 0.0f, 0.0f }, 4.0f, { 4, 1, 1 } });
	visibility.survey();
	CHECK(visibility.open()[0] == 1);
	CHECK(visibility.open()[1] == 1);
	CHECK(visibility.open()[2] == 0);
	CHECK(visibility.open()[3] == 0);
}

} // namespace test_visibility
