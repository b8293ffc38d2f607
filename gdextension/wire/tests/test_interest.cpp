// SPDX-License-Identifier: MIT
#include <replication/interest.hpp>

#include <check.hpp>

#include <limits>

namespace test_interest {

using namespace wire;

namespace {

const float NOT_A_NUMBER = std::numeric_limits<float>::quiet_NaN();
const float INFINITE = std::numeric_limits<float>::infinity();

std::vector<uint8_t> table(std::size_t p_cells, uint8_t p_value) {
	return std::vector<uint8_t>(p_cells * p_cells, p_value);
}

bool set(Interest &r_interest, const std::array<int, 3> &p_counts, const std::vector<uint8_t> &p_table) {
	return r_interest.set_cells({ -1.0f, 0.0f, 10.0f }, 2.0f, p_counts, p_table.data(), p_table.size());
}

} // namespace

TEST(cells_are_numbered_by_x_then_z_then_y) {
	Interest interest;
	CHECK(set(interest, { 2, 3, 4 }, table(24, 1)));
	int expected = 0;
	for (int x = 0; x < 2; x++) {
		for (int z = 0; z < 4; z++) {
			for (int y = 0; y < 3; y++) {
				const Vec3 middle{ -1.0f + 2.0f * float(x) + 1.0f, 2.0f * float(y) + 1.0f,
					10.0f + 2.0f * float(z) + 1.0f };
				CHECK(interest.cell(middle) == expected);
				expected++;
			}
		}
	}
	// The lower edge belongs to a cell, the upper one to the next.
	CHECK(interest.cell({ -1.0f, 0.0f, 10.0f }) == 0);
	CHECK(interest.cell({ 1.0f, 0.0f, 10.0f }) == 12);
}

TEST(outside_is_in_no_cell) {
	Interest interest;
	CHECK(set(interest, { 2, 3, 4 }, table(24, 0)));
	const Vec3 inside{ 0.0f, 1.0f, 11.0f };
	for (const Vec3 &position : { Vec3{ -1.01f, 1.0f, 11.0f }, Vec3{ 3.0f, 1.0f, 11.0f }, Vec3{ 0.0f, -0.01f, 11.0f },
				 Vec3{ 0.0f, 6.0f, 11.0f }, Vec3{ 0.0f, 1.0f, 9.9f }, Vec3{ 0.0f, 1.0f, 18.0f },
				 Vec3{ NOT_A_NUMBER, 1.0f, 11.0f }, Vec3{ 0.0f, INFINITE, 11.0f }, Vec3{ 0.0f, 1.0f, -1e30f } }) {
		CHECK(interest.cell(position) == -1);
		// Nothing is known of it, so it is not hidden.
		CHECK(interest.weight(inside, position) >= Interest::FAR);
		CHECK(interest.weight(position, inside) >= Interest::FAR);
	}
	CHECK(interest.weight(inside, inside) == Interest::HIDDEN);
}

TEST(the_table_is_read_from_the_viewpoint_to_what_is_seen) {
	Interest interest;
	// The first cell sees the second, but not the other way round.
	const std::vector<uint8_t> one_way{ 1, 1, 0, 1 };
	CHECK(set(interest, { 2, 1, 1 }, one_way));
	const Vec3 first{ 0.0f, 1.0f, 11.0f };
	const Vec3 second{ 2.0f, 1.0f, 11.0f };
	CHECK(interest.weight(first, second) > Interest::FAR);
	CHECK(interest.weight(second, first) == Interest::HIDDEN);
}

TEST(a_bad_table_hides_nothing) {
	Interest interest;
	const std::vector<uint8_t> hidden = table(8, 0);
	const Vec3 origin{ -1.0f, 0.0f, 10.0f };
	const Vec3 inside{ 0.0f, 1.0f, 11.0f };
	const auto is_refused = [&](const Vec3 &p_origin, float p_size, const std::array<int, 3> &p_counts,
									std::size_t p_bytes) {
		// Over a table that was good.
		bool good = interest.set_cells(origin, 2.0f, { 2, 2, 2 }, hidden.data(), hidden.size());
		good = good && interest.weight(inside, inside) == Interest::HIDDEN;
		const bool taken = interest.set_cells(p_origin, p_size, p_counts, hidden.data(), p_bytes);
		return good && !taken && interest.weight(inside, inside) > 0.99f;
	};
	CHECK(is_refused(origin, 2.0f, { 2, 2, 2 }, 63));
	CHECK(is_refused(origin, 2.0f, { 2, 2, 2 }, 0));
	CHECK(is_refused(origin, 2.0f, { 0, 2, 2 }, 0));
	CHECK(is_refused(origin, 2.0f, { -2, -2, 2 }, 64));
	CHECK(is_refused(origin, 2.0f, { 1000000000, 1000000000, 1000000000 }, 64));
	CHECK(is_refused(origin, 2.0f, { 1024, 1024, 1024 }, 64));
	CHECK(is_refused(origin, 0.0f, { 2, 2, 2 }, 64));
	CHECK(is_refused(origin, -1.0f, { 2, 2, 2 }, 64));
	CHECK(is_refused(origin, NOT_A_NUMBER, { 2, 2, 2 }, 64));
	CHECK(is_refused(origin, INFINITE, { 2, 2, 2 }, 64));
	CHECK(is_refused({ NOT_A_NUMBER, 0.0f, 0.0f }, 2.0f, { 2, 2, 2 }, 64));
	CHECK(is_refused({ 0.0f, INFINITE, 0.0f }, 2.0f, { 2, 2, 2 }, 64));
}

TEST(the_largest_table) {
	Interest interest;
	const std::size_t most = std::size_t(Interest::MAX_CELLS);
	const int count = Interest::MAX_CELLS;
	CHECK(set(interest, { count, 1, 1 }, table(most, 0)));
	CHECK(interest.cell({ 2.0f * float(count) - 2.0f, 1.0f, 11.0f }) == count - 1);
	CHECK(!set(interest, { count + 1, 1, 1 }, table(most + 1, 0)));
}

TEST(weight_falls_with_the_distance) {
	const Interest interest;
	float before = 1.1f;
	for (int step = 0; step < 1000; step++) {
		const float distance = float(step);
		const float weight = interest.weight({}, { distance, 0.0f, 0.0f });
		CHECK(weight <= before && weight >= Interest::FAR);
		before = weight;
	}
	CHECK_NEAR(interest.weight({}, { Interest::HALF_DISTANCE_M, 0.0f, 0.0f }), 0.5, 1e-6);
	CHECK(interest.weight({}, { NOT_A_NUMBER, 0.0f, 0.0f }) == Interest::FAR);
	CHECK(interest.weight({ INFINITE, 0.0f, 0.0f }, {}) == Interest::FAR);
}

} // namespace test_interest
