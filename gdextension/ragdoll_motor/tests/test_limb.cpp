// SPDX-License-Identifier: MIT
#include "body/limb.hpp"

#include "check.hpp"

#include <limits>

namespace test_limb {

using namespace ragdoll;

namespace {

constexpr float NOTHING = std::numeric_limits<float>::quiet_NaN();
constexpr float ENDLESS = std::numeric_limits<float>::infinity();

Limb make_limb(const char *p_bone, const char *p_parent, float p_mass_fraction) {
	Limb limb;
	limb.bone = p_bone;
	limb.parent_bone = p_parent;
	limb.group = "trunk";
	limb.mass_fraction = p_mass_fraction;
	return limb;
}

std::vector<Limb> make_body() {
	return { make_limb("Hips", "", 0.5f), make_limb("Spine", "Hips", 0.25f), make_limb("Head", "Spine", 0.25f) };
}

bool contains(const std::string &p_text, const char *p_part) {
	const bool found = p_text.find(p_part) != std::string::npos;
	if (!found) {
		std::printf("'%s' is not in '%s'\n", p_part, p_text.c_str());
	}
	return found;
}

/// Moments of a shape of 5 kg by adding up the points of a grid.
Vec3 integrate(const Limb &p_limb) {
	constexpr int GRID = 80;
	const bool is_box = p_limb.type == Limb::BOX;
	const float half_length = p_limb.length / 2.0f;
	const Vec3 half = is_box ? p_limb.size * 0.5f : Vec3{ p_limb.radius, p_limb.radius + half_length, p_limb.radius };
	double sum[3] = {};
	int count = 0;
	for (int i = 0; i < GRID * GRID * GRID; i++) { // By symmetry one eighth is enough.
		const int steps[3] = { i % GRID, i / GRID % GRID, i / GRID / GRID };
		const Vec3 point{ half.x * (float(steps[0]) + 0.5f) / GRID, half.y * (float(steps[1]) + 0.5f) / GRID,
			half.z * (float(steps[2]) + 0.5f) / GRID };
		const Vec3 from_core{ point.x, std::fmax(point.y - half_length, 0.0f), point.z };
		if (!is_box && from_core.length() > p_limb.radius) {
			continue;
		}
		sum[0] += double(point.y * point.y + point.z * point.z);
		sum[1] += double(point.x * point.x + point.z * point.z);
		sum[2] += double(point.x * point.x + point.y * point.y);
		count++;
	}
	return Vec3{ float(sum[0] / count), float(sum[1] / count), float(sum[2] / count) } * 5.0f;
}

void check_inertia(const Limb &p_limb) {
	const Vec3 found = shape_inertia(p_limb, 5.0f);
	const Vec3 wanted = integrate(p_limb);
	CHECK_NEAR(double(found.x / wanted.x), 1.0, 0.01);
	CHECK_NEAR(double(found.y / wanted.y), 1.0, 0.01);
	CHECK_NEAR(double(found.z / wanted.z), 1.0, 0.01);
}

} // namespace

TEST(inertia_agrees_with_integration) {
	Limb limb;
	const float sizes[3][2] = { { 0.05f, 0.3f }, { 0.15f, 0.0f }, { 0.1f, 0.02f } };
	for (const auto &[radius, length] : sizes) {
		limb.radius = radius;
		limb.length = length;
		check_inertia(limb);
	}
	limb.type = Limb::BOX;
	limb.size = { 0.1f, 0.4f, 0.25f };
	check_inertia(limb);
}

TEST(known_inertia) {
	Limb ball;
	ball.radius = 0.5f;
	ball.length = 0.0f;
	CHECK_NEAR(double(shape_inertia(ball, 10.0f).x), 1.0, 1e-5); // 2/5 m r^2
	CHECK_NEAR(double(shape_inertia(ball, 10.0f).y), 1.0, 1e-5);
	Limb rod;
	rod.radius = 0.001f;
	rod.length = 2.0f;
	CHECK_NEAR(double(shape_inertia(rod, 3.0f).x), 1.0, 0.01); // 1/12 m l^2
	CHECK_NEAR(double(shape_inertia(rod, 3.0f).y), 0.0, 1e-4);
	Limb cube;
	cube.type = Limb::BOX;
	cube.size = { 1.0f, 1.0f, 1.0f };
	CHECK_NEAR(double(shape_inertia(cube, 6.0f).z), 1.0, 1e-5); // 1/6 m a^2
}

TEST(joint_axes_run_along_the_limb) {
	const Vec3 directions[6] = { { 1, 0.2f, 0 }, { -1, 0, 0.3f }, { 0, 1, 0 }, { 0.1f, -1, 0 }, { 0, -0.4f, 1 },
		{ 0, 0, -1 } };
	const Vec3 along[6] = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } };
	for (int i = 0; i < 6; i++) {
		Limb limb;
		limb.rest_orientation = exp({ 0.3f, 0.2f, -0.9f });
		limb.reset_orientation = exp({ 0.0f, 0.0f, 0.7f }) * limb.rest_orientation;
		limb.anchor = { 0.1f, 0.2f, 0.3f };
		limb.position = limb.anchor + exp({ 0.0f, 0.0f, -0.7f }).rotate(directions[i]);
		const Quat axes = joint_axes(limb);
		CHECK_NEAR(double(axes.dot(axes)), 1.0, 1e-6);
		CHECK_NEAR(double((axes.rotate({ 1, 0, 0 }) - along[i]).length()), 0.0, 1e-6);
		const Vec3 side = along[i].y != 0.0f ? Vec3{ 0, 0, 1 } : Vec3{ 0, 1, 0 };
		CHECK_NEAR(double((axes.rotate({ 0, 1, 0 }) - side).length()), 0.0, 1e-6);
	}
}

TEST(faults_of_a_limb_are_named) {
	CHECK(find_fault(make_limb("Head", "", 0.5f)).empty());
	using Change = void (*)(Limb &);
	const std::pair<Change, const char *> cases[] = {
		{ [](Limb &limb) { limb.bone = ""; }, "names no bone" },
		{ [](Limb &limb) { limb.group = ""; }, "Head is in no strength group" },
		{ [](Limb &limb) { limb.position.y = NOTHING; }, "Head has a position that is not finite" },
		{ [](Limb &limb) { limb.anchor.x = ENDLESS; }, "Head has a position that is not finite" },
		{ [](Limb &limb) { limb.orientation.w = 0.5f; }, "Head's orientation is not a rotation (norm 0.5" },
		{ [](Limb &limb) { limb.rest_orientation.w = 2.0f; }, "Head's rest_orientation is not a rotation" },
		{ [](Limb &limb) { limb.reset_orientation.x = NOTHING; }, "Head's reset_orientation is not finite" },
		{ [](Limb &limb) { limb.anchor.x = 1e30f; }, "Head has a position or anchor further than 100 m" },
		{ [](Limb &limb) { limb.mass_fraction = 1e-30f; }, "Head's mass_fraction is 0.0" },
		{ [](Limb &limb) { limb.mass_fraction = 0.0f; }, "Head's mass_fraction is 0.0" },
		{ [](Limb &limb) { limb.mass_fraction = NOTHING; }, "mass_fraction" },
		{ [](Limb &limb) { limb.max_torque = 0.0f; }, "Head's max_torque is 0.0" },
		{ [](Limb &limb) { limb.max_torque = -1.0f; }, "max_torque" },
		{ [](Limb &limb) { limb.max_torque = ENDLESS; }, "max_torque" },
		{ [](Limb &limb) { limb.radius = NOTHING; }, "Head's radius or length" },
		{ [](Limb &limb) { limb.length = -0.1f; }, "radius or length" },
		{ [](Limb &limb) { limb.type = Limb::Type(7); }, "Head's type is 7 instead of PILL (0) or BOX (1)" },
		{ [](Limb &limb) { limb.type = Limb::BOX, limb.size.z = -1.0f; }, "Head's sizes must be above 0" },
		{ [](Limb &limb) { limb.type = Limb::BOX, limb.size.x = ENDLESS; }, "sizes" },
		{ [](Limb &limb) { limb.contact_radius = -0.1f; }, "Head's contact_radius is -0.1" },
		{ [](Limb &limb) { limb.contact_points = { { 0, NOTHING, 0 } }; },
				"Head has a contact point that is not finite" },
		{ [](Limb &limb) { limb.contact_points.resize(1000); }, "Head has 1000 contact points, at most 64" },
		{ [](Limb &limb) { limb.min_angles.y = 0.1f; }, "Head's Y angles are 0.1" },
		{ [](Limb &limb) { limb.max_angles.z = 4.0f; }, "Z angles" },
		{ [](Limb &limb) { limb.max_angles.x = NOTHING; }, "X angles" },
	};
	for (const auto &[change, part] : cases) {
		Limb limb = make_limb("Head", "Spine", 0.5f);
		change(limb);
		CHECK(contains(find_fault(limb), part));
	}
}

TEST(faults_of_a_body_are_named) {
	CHECK(find_fault(make_body(), 80.0).empty());
	CHECK(contains(find_fault({}, 80.0), "there are no limbs"));
	CHECK(contains(find_fault(make_body(), 0.0), "the mass is 0.0"));
	CHECK(contains(find_fault(make_body(), double(NOTHING)), "the mass is"));
	CHECK(contains(find_fault(std::vector<Limb>(10000), 80.0), "there are 10000 limbs, at most 64"));
	std::vector<Limb> body = make_body();
	body[2].bone = "Spine";
	CHECK(contains(find_fault(body, 80.0), "Spine is there twice"));
	body = make_body();
	body[1].parent_bone = "";
	CHECK(contains(find_fault(body, 80.0), "Spine: the first limb, and only the first"));
	body = make_body();
	body[1].parent_bone = "Head";
	CHECK(contains(find_fault(body, 80.0), "Spine comes before its parent Head"));
	body = make_body();
	body[1].bone = "";
	CHECK(contains(find_fault(body, 80.0), "limb 1: it names no bone"));
	body = make_body();
	body[1].mass_fraction = 0.5f;
	CHECK(contains(find_fault(body, 80.0), "add up to 1.25"));
	body = make_body();
	body[1].bone = std::string(100000, 'x');
	body[1].max_torque = 0.0f;
	CHECK(find_fault(body, 80.0).size() < 300);
}

} // namespace test_limb
