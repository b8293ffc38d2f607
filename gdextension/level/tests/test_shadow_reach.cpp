// SPDX-License-Identifier: MIT
#include <shadow_reach.hpp>

#include <check.hpp>

using namespace level;

namespace {

using Bytes = std::vector<uint8_t>;

const Bytes ALL{ 1, 1, 1 };

// A floor square of 2 m with its middle at a place; caster -1 for one that throws no shadow.
void add_square(ShadowReach &r_reach, const Vec3 &p_middle, int p_caster) {
	const std::vector<Vec3> points{ p_middle + Vec3{ -1.0f, 0.0f, -1.0f }, p_middle + Vec3{ 1.0f, 0.0f, -1.0f },
		p_middle + Vec3{ 1.0f, 0.0f, 1.0f }, p_middle + Vec3{ -1.0f, 0.0f, 1.0f } };
	r_reach.add_part(points, { 0, 1, 2, 0, 2, 3 }, p_caster);
}

// The ground, a roof 10 m above it and another one 30 m to the east.
ShadowReach ground_and_roofs() {
	ShadowReach reach;
	add_square(reach, { 2.0f, 0.0f, 2.0f }, -1);
	add_square(reach, { 2.0f, 10.0f, 2.0f }, 0);
	add_square(reach, { 32.0f, 10.0f, 2.0f }, 1);
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
	reach.set_light({ 3.0f, 1.0f, 0.0f });
	CHECK(reach.look({ 1, 0, 0 }, {}) == (Bytes{ 0, 1 }));
	reach.set_light({ -3.0f, 1.0f, 0.0f });
	CHECK(reach.look({ 1, 0, 0 }, {}) == (Bytes{ 0, 0 }));
}

TEST(what_lies_below_throws_nothing_upwards) {
	ShadowReach reach;
	add_square(reach, { 2.0f, 10.0f, 2.0f }, -1);
	add_square(reach, { 2.0f, 0.0f, 2.0f }, 0);
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

TEST(casters_beyond_a_word_are_told_apart) {
	ShadowReach reach;
	for (int number = 0; number < 70; number++) {
		add_square(reach, { 10.0f * float(number) + 2.0f, 0.0f, 2.0f }, number);
	}
	reach.set_light({ 0.0f, 1.0f, 0.0f });
	Bytes seen(70, 0);
	seen[66] = 1;
	CHECK(reach.look(seen, {}) == seen);
}

TEST_MAIN()
