// SPDX-License-Identifier: MIT
#include <light_coding.hpp>
#include <light_grid.hpp>

#include <check.hpp>

#include <cmath>

namespace test_light_grid {

using namespace level;

namespace {

constexpr std::array<int, 3> COUNTS{ 3, 2, 2 };
constexpr std::size_t POINTS = 12;

// Sky of 0.5 from above and 0.25 from below everywhere; the point in the middle of the first row is solid.
std::vector<uint8_t> points() {
	std::vector<uint8_t> bytes(POINTS * LightGrid::POINT_SIZE, 0);
	for (std::size_t point = 0; point < POINTS; point++) {
		uint8_t *at = bytes.data() + point * LightGrid::POINT_SIZE;
		at[0] = point == 1 ? 0 : 1;
		for (int channel = 0; channel < 3 && point != 1; channel++) {
			at[1 + channel] = encode_light(0.5f);
			at[1 + 3 * LIGHT_SETS + channel] = encode_light(0.25f);
		}
	}
	return bytes;
}

Light only_sky() {
	Light strengths{};
	strengths[LIGHT_SKY] = { 1.0f, 2.0f, 0.0f };
	return strengths;
}

} // namespace

TEST(sums_the_sources_as_strong_as_they_are) {
	LightGrid grid;
	const std::vector<uint8_t> bytes = points();
	CHECK(grid.set_points(bytes.data(), bytes.size(), COUNTS));
	std::vector<uint8_t> texels(POINTS * 4);
	grid.combine(only_sky(), texels.data());
	const auto light = [&](std::size_t p_point, int p_channel) {
		return double(decode_light(texels[p_point * 4 + p_channel]));
	};
	CHECK_NEAR(light(0, 0), 0.375, 0.01);
	CHECK_NEAR(light(0, 1), 0.75, 0.01);
	CHECK_NEAR(light(0, 2), 0.0, 1e-6);
	CHECK_NEAR(texels[3] / 255.0, 2.0 / 3.0, 0.01);
	// The point inside a wall takes the light beside it.
	CHECK_NEAR(light(1, 0), 0.375, 0.01);
	CHECK_NEAR(grid.mean_at({ 2.4f, 0.2f, 50.0f }, only_sky()).x, 0.375, 0.01);
}

TEST(refuses_sizes_that_do_not_fit) {
	LightGrid grid;
	const std::vector<uint8_t> bytes = points();
	CHECK(!grid.set_points(bytes.data(), bytes.size() - 1, COUNTS));
	CHECK(!grid.set_points(bytes.data(), bytes.size(), { 3, 2, 0 }));
	CHECK(!grid.set_points(bytes.data(), bytes.size(), { -3, -2, 2 }));
	CHECK(grid.size() == 0);
	CHECK_NEAR(grid.mean_at({}, only_sky()).x, 0.0, 0.0);
}

} // namespace test_light_grid
