// SPDX-License-Identifier: MIT
#include <shadow_reach.hpp>

#include <check.hpp>

namespace test_shadow_reach {

using namespace level;

namespace {

using Bytes = std::vector<uint8_t>;

const Bytes ALL{ 1, 1, 1 };

// A floor square of 2 m with its middle at a place.
void add_square(ShadowReach &r_reach, const Vec3 &p_middle, bool p_throws) {
	const std::vector<Vec3> points{ p_middle + Vec3{ -1.0f, 0.0f, -1.0f }, p_middle + Vec3{ 1.0f, 0.0f, -1.0f },
		p_middle + Vec3{ 1.0f, 0.0f, 1.0f }, p_middle + Vec3{ -1.0f, 0.0f, 1.0f } };
	std::vector<Vec3> shadow{ points[0], points[1], points[2], points[0], points[2], points[3] };
	r_reach.add_part(points, { 0, 1, 2, 0, 2, 3 }, p_throws ? shadow : std::vector<Vec3>{});
}

// The ground, a roof 10 m above it and another one 40 m to the east, in the next square.
ShadowReach ground_and_roofs() {
	ShadowReach reach;
	reach.few = 0;
	add_square(reach, { 2.0f, 0.0f, 2.0f }, false);
	add_square(reach, { 2.0f, 10.0f, 2.0f }, true);
	add_square(reach, { 42.0f, 10.0f, 2.0f }, true);
	reach.gather();
	return reach;
}

} // namespace

TEST(all_are_needed_before_there_is_light) {
	ShadowReach reach = ground_and_roofs();
	CHECK(reach.caster_count() == 2);
	CHECK(reach.look(ALL, {}) == (Bytes{ 1, 1 }));
	reach.set_light({ 0.0f, 0.0f, 0.0f });
	CHECK(reach.look(ALL, {}) == (Bytes{ 1, 1 }));
}

TEST(needs_what_stands_between_the_light_and_what_is_seen) {
	ShadowReach reach = ground_and_roofs();
	reach.set_light({ 0.0f, 1.0f, 0.0f });
	CHECK(reach.look({ 1, 0, 0 }, {}) == (Bytes{ 1, 0 }));
	CHECK(reach.look({ 0, 1, 0 }, {}) == (Bytes{ 1, 0 }));
	CHECK(reach.look({ 0, 0, 0 }, {}) == (Bytes{ 0, 0 }));
	CHECK(reach.look({ 1, 0, 1 }, {}) == (Bytes{ 1, 1 }));
	// From the east the far roof shades the ground, and the near roof none of it.
	reach.set_light({ 4.0f, 1.0f, 0.0f });
	CHECK(reach.look({ 1, 0, 0 }, {}) == (Bytes{ 0, 1 }));
	reach.set_light({ -4.0f, 1.0f, 0.0f });
	CHECK(reach.look({ 1, 0, 0 }, {}) == (Bytes{ 0, 0 }));
}

TEST(what_lies_below_throws_nothing_upwards) {
	ShadowReach reach;
	add_square(reach, { 2.0f, 10.0f, 2.0f }, false);
	add_square(reach, { 2.0f, 0.0f, 2.0f }, true);
	reach.gather();
	reach.set_light({ 0.0f, 1.0f, 0.0f });
	CHECK(reach.look({ 1, 0 }, {}) == (Bytes{ 0 }));
	CHECK(reach.look({ 0, 1 }, {}) == (Bytes{ 1 }));
}

TEST(only_what_is_inside_the_bounds_counts) {
	ShadowReach reach = ground_and_roofs();
	reach.set_light({ 0.0f, 1.0f, 0.0f });
	// Only what is east of 20 m, then only what is west of it.
	CHECK(reach.look(ALL, { { { -1.0f, 0.0f, 0.0f }, -20.0f } }) == (Bytes{ 0, 1 }));
	CHECK(reach.look(ALL, { { { 1.0f, 0.0f, 0.0f }, 20.0f } }) == (Bytes{ 1, 0 }));
	// Somebody stands on the ground: there is room for that.
	const std::vector<ShadowReach::Bound> breast{ { { 0.0f, -1.0f, 0.0f }, -1.5f }, { { 0.0f, 1.0f, 0.0f }, 3.0f } };
	CHECK(reach.look(ALL, breast) == (Bytes{ 1, 0 }));
	const std::vector<ShadowReach::Bound> above{ { { 0.0f, -1.0f, 0.0f }, -3.0f }, { { 0.0f, 1.0f, 0.0f }, 5.0f } };
	CHECK(reach.look(ALL, above) == (Bytes{ 0, 0 }));
}

TEST(finds_boxes_inside_bounds) {
	const std::vector<std::array<Vec3, 2>> boxes{ { { { 0.0f, 0.0f, 0.0f }, { 1.0f, 1.0f, 1.0f } } },
		{ { { 4.0f, 0.0f, 0.0f }, { 6.0f, 1.0f, 1.0f } } }, { { { 7.0f, 0.0f, 0.0f }, { 8.0f, 1.0f, 1.0f } } } };
	CHECK(ShadowReach::inside(boxes, { { { 1.0f, 0.0f, 0.0f }, 5.0f } }) == (Bytes{ 1, 1, 0 }));
	CHECK(ShadowReach::inside(boxes, {}) == (Bytes{ 1, 1, 1 }));
}

TEST(casters_beyond_a_word_are_told_apart) {
	ShadowReach reach;
	reach.few = 0;
	for (int number = 0; number < 70; number++) {
		add_square(reach, { 32.0f * float(number) + 2.0f, 0.0f, 2.0f }, true);
	}
	reach.gather();
	CHECK(reach.caster_count() == 70);
	reach.set_light({ 0.0f, 1.0f, 0.0f });
	Bytes seen(70, 0);
	seen[66] = 1;
	CHECK(reach.look(seen, {}) == seen);
}

TEST(squares_with_few_triangles_are_part_of_the_nearest) {
	ShadowReach reach;
	reach.few = 3;
	add_square(reach, { 2.0f, 0.0f, 2.0f }, true);
	add_square(reach, { 4.0f, 0.0f, 2.0f }, true);
	add_square(reach, { 42.0f, 0.0f, 2.0f }, true);
	add_square(reach, { 202.0f, 0.0f, 2.0f }, true);
	add_square(reach, { 204.0f, 0.0f, 2.0f }, true);
	reach.gather();
	CHECK(reach.caster_count() == 2);
	CHECK(reach.caster(0).size() == 18);
	reach.set_light({ 0.0f, 1.0f, 0.0f });
	CHECK(reach.look({ 0, 0, 1, 0, 0 }, {}) == (Bytes{ 1, 0 }));
	CHECK(reach.look({ 0, 0, 0, 0, 1 }, {}) == (Bytes{ 0, 1 }));
}

TEST(what_is_within_shades_only_what_is_within) {
	ShadowReach reach;
	reach.few = 0;
	const std::vector<Vec3> table{ { 1.0f, 1.0f, 1.0f }, { 3.0f, 1.0f, 1.0f }, { 3.0f, 1.0f, 3.0f } };
	add_square(reach, { 2.0f, 0.0f, 2.0f }, false);
	reach.add_part(table, { 0, 1, 2 }, table, true);
	add_square(reach, { 2.0f, 9.0f, 2.0f }, true);
	reach.gather();
	CHECK(reach.caster_count() == 2);
	reach.set_light({ 0.0f, 1.0f, 0.0f });
	CHECK(reach.look({ 1, 0, 0 }, {}) == (Bytes{ 1, 0 }));
	CHECK(reach.look({ 0, 1, 0 }, {}) == (Bytes{ 1, 1 }));
}

TEST(large_triangles_shade_only_what_lies_below_them) {
	ShadowReach reach;
	reach.few = 0;
	reach.square_m = 1000.0f;
	const std::vector<Vec3> roof{ { 0.0f, 10.0f, 0.0f }, { 100.0f, 10.0f, 0.0f }, { 100.0f, 10.0f, 100.0f } };
	reach.add_part({}, {}, roof);
	add_square(reach, { 90.0f, 0.0f, 10.0f }, false);
	add_square(reach, { 10.0f, 0.0f, 90.0f }, false);
	reach.gather();
	reach.set_light({ 0.0f, 1.0f, 0.0f });
	CHECK(reach.look({ 0, 1, 0 }, {}) == (Bytes{ 1 }));
	CHECK(reach.look({ 0, 0, 1 }, {}) == (Bytes{ 0 }));
}

} // namespace test_shadow_reach
