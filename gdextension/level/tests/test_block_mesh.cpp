// SPDX-License-Identifier: MIT
#include "boxes.hpp"

#include <check.hpp>

#include <cmath>

namespace test_block_mesh {

using namespace level;

namespace {

float area(const BlockMesh &p_mesh) {
	float sum = 0.0f;
	for (const Triangle &triangle : boxes::triangles(p_mesh)) {
		sum += triangle.normal().length() * 0.5f;
	}
	return sum;
}

// Corners run clockwise as they are seen from where the normals point.
bool faces_outwards(const BlockMesh &p_mesh) {
	for (std::size_t index = 0; index < p_mesh.indices().size(); index += 3) {
		const int32_t corner = p_mesh.indices()[index];
		const Triangle triangle{ p_mesh.points()[corner], p_mesh.points()[p_mesh.indices()[index + 1]],
			p_mesh.points()[p_mesh.indices()[index + 2]] };
		if (triangle.normal().dot(p_mesh.normals()[corner]) <= 0.0f) {
			return false;
		}
	}
	return true;
}

} // namespace

TEST(a_box_has_its_surface_and_looks_outwards) {
	BlockMesh mesh;
	mesh.set_place({ { Vec3{ 0.0f, 0.0f, -1.0f }, Vec3{ 0.0f, 1.0f, 0.0f }, Vec3{ 1.0f, 0.0f, 0.0f } },
			{ 5.0f, 0.0f, 2.0f } });
	mesh.box({ 0.0f, 0.0f, 0.0f }, { 4.0f, 3.0f, 0.5f }, { 2, 7 });
	CHECK_NEAR(area(mesh), 2.0 * (4.0 * 3.0 + 4.0 * 0.5 + 3.0 * 0.5), 1e-3);
	CHECK(faces_outwards(mesh));
	CHECK(mesh.styles()[0][0] == 2.0f && mesh.styles()[0][1] == 7.0f);
}

TEST(sides_that_are_never_seen_can_be_left_out) {
	BlockMesh mesh;
	mesh.box({ 0.0f, 0.0f, 0.0f }, { 1.0f, 2.0f, 3.0f }, {}, FACE_BOTTOM | FACE_LEFT);
	CHECK_NEAR(area(mesh), 2.0 * (2.0 + 3.0 + 6.0) - 3.0 - 6.0, 1e-4);
}

// What shadows are thrown by is the same surface, seen from the same side, in fewer triangles.
TEST(the_shadow_is_that_of_the_faces) {
	BlockMesh mesh;
	mesh.set_place({ { Vec3{ 0.0f, 0.0f, -1.0f }, Vec3{ 0.0f, 1.0f, 0.0f }, Vec3{ 1.0f, 0.0f, 0.0f } },
			{ 5.0f, 0.0f, 2.0f } });
	mesh.face({}, { 1.0f, 0.0f, 0.0f }, { 0.0f, 1.0f, 0.0f }, 6.0f, 3.0f, {},
			{ { 1.0f, 0.0f, 1.0f, 2.1f }, { 3.0f, 1.0f, 1.2f, 1.2f } });
	mesh.quad({ Vec3{ 0.0f, 0.0f, 0.0f }, { 0.0f, 0.0f, 3.0f }, { 0.0f, 4.0f, 3.0f }, { 0.0f, 4.0f, 0.0f } }, {});
	mesh.quad({ Vec3{ 0.0f, 3.0f, 0.0f }, { 4.0f, 3.5f, 0.0f }, { 4.0f, 3.0f, 4.0f }, { 0.0f, 3.5f, 4.0f } }, {});
	mesh.rod({ 0.0f, 0.0f, 0.0f }, { 1.0f, 4.0f, 2.0f }, 0.5f, 0.2f, {}, 8, true);
	mesh.triangle({}, { 0.0f, 0.0f, 1.0f }, { 0.0f, 1.0f, 0.0f }, {});
	Vec3 faces;
	for (const Triangle &triangle : boxes::triangles(mesh)) {
		faces = faces + triangle.normal();
	}
	Vec3 shadow;
	float shadow_area = 0.0f;
	for (std::size_t index = 0; index < mesh.shadow().size(); index += 3) {
		const Triangle triangle{ mesh.shadow()[index], mesh.shadow()[index + 1], mesh.shadow()[index + 2] };
		shadow = shadow + triangle.normal();
		shadow_area += triangle.normal().length() * 0.5f;
	}
	CHECK_NEAR(shadow_area, area(mesh), 0.002f * area(mesh));
	CHECK_NEAR((shadow - faces).length(), 0.0, 1e-2);
	CHECK(mesh.shadow().size() < mesh.indices().size() / 2);
}

TEST(openings_are_open) {
	BlockMesh mesh;
	mesh.face({}, { 1.0f, 0.0f, 0.0f }, { 0.0f, 1.0f, 0.0f }, 6.0f, 3.0f, {},
			{ { 1.0f, 0.0f, 1.0f, 2.1f }, { 3.0f, 1.0f, 1.2f, 1.2f } });
	CHECK_NEAR(area(mesh), 18.0 - 2.1 - 1.44, 1e-3);
	RayScene scene;
	scene.build(boxes::triangles(mesh));
	CHECK(!scene.is_blocked({ 1.5f, 1.0f, 1.0f }, { 1.5f, 1.0f, -1.0f }));
	CHECK(!scene.is_blocked({ 3.6f, 1.6f, 1.0f }, { 3.6f, 1.6f, -1.0f }));
	CHECK(scene.is_blocked({ 2.5f, 1.0f, 1.0f }, { 2.5f, 1.0f, -1.0f }));
	// Nothing is kept that no triangle uses.
	std::vector<bool> used(mesh.points().size(), false);
	for (const int32_t index : mesh.indices()) {
		used[index] = true;
	}
	CHECK(std::find(used.begin(), used.end(), false) == used.end());
}

TEST(faces_are_divided_so_that_light_has_places) {
	BlockMesh mesh;
	mesh.set_finest(0.5f);
	mesh.face({}, { 1.0f, 0.0f, 0.0f }, { 0.0f, 1.0f, 0.0f }, 5.0f, 5.0f, {});
	for (const Triangle &triangle : boxes::triangles(mesh)) {
		CHECK((triangle.b - triangle.a).length() < 0.75f && (triangle.c - triangle.a).length() < 0.75f);
	}
}

TEST(rods_and_quads_look_outwards) {
	BlockMesh rod;
	rod.rod({ 0.0f, 0.0f, 0.0f }, { 0.0f, 2.0f, 0.0f }, 0.5f, 0.2f, {}, 12, true);
	CHECK(faces_outwards(rod));
	rod.rod({ 1.0f, 0.0f, 0.0f }, { 3.0f, 0.5f, 1.0f }, 0.1f, 0.1f, {}, 7, true);
	CHECK(faces_outwards(rod));
	BlockMesh quad;
	quad.quad(
			{ Vec3{ 0.0f, 1.0f, 0.0f }, Vec3{ 1.0f, 1.0f, 0.0f }, Vec3{ 1.0f, 0.0f, 0.0f }, Vec3{ 0.0f, 0.0f, 0.0f } },
			{});
	CHECK(faces_outwards(quad));
	// Seen from +Z its corners run clockwise.
	CHECK_NEAR(quad.normals()[0].z, 1.0, 1e-5);
}

TEST(a_foreign_surface_with_wrong_indices_is_left_out) {
	BlockMesh mesh;
	const std::vector<Vec3> points{ {}, { 1.0f, 0.0f, 0.0f }, { 0.0f, 1.0f, 0.0f } };
	const std::vector<Vec3> normals(3, Vec3{ 0.0f, 0.0f, 1.0f });
	const std::vector<std::array<float, 2>> uvs(3);
	mesh.surface(points, normals, uvs, { 0, 1, 3 }, {});
	mesh.surface(points, normals, uvs, { 0, 1, -1 }, {});
	mesh.surface(points, normals, uvs, { 0, 1 }, {});
	CHECK(mesh.points().empty());
	mesh.surface(points, normals, uvs, { 0, 2, 1 }, {});
	CHECK(mesh.indices().size() == 3);
}

TEST(solids_stand_where_the_block_stands) {
	BlockMesh mesh;
	mesh.set_place({ { Vec3{ 0.0f, 0.0f, -1.0f }, Vec3{ 0.0f, 1.0f, 0.0f }, Vec3{ 1.0f, 0.0f, 0.0f } },
			{ 10.0f, 0.0f, 0.0f } });
	mesh.solid({ 0.0f, 0.0f, 0.0f }, { 4.0f, 2.0f, 1.0f });
	CHECK_NEAR(mesh.solids()[0].place.origin.x, 10.5, 1e-5);
	CHECK_NEAR(mesh.solids()[0].place.origin.z, -2.0, 1e-5);
	CHECK_NEAR(mesh.solids()[0].size.x, 4.0, 1e-5);
}

} // namespace test_block_mesh
