// SPDX-License-Identifier: MIT
// What survives a bad line: framer and judge together.
#include "bus_streams.hpp"

#include "check.hpp"

namespace test_corruption {

using namespace streams;

namespace {

constexpr std::size_t MESSAGES = 40000;
constexpr int RUNS = 4;

Survival survive_often(const Stream &p_stream, const MasterFormat *p_format, double p_rate) {
	Survival all;
	for (int run = 0; run < RUNS; run++) {
		all.add(survive(p_stream, p_format, p_rate, uint32_t(100 + run)));
	}
	std::printf("  at %g: %zu of %zu clean messages, %zu wrong in %zu stretches\n", p_rate, all.regained, all.clean,
			all.wrong, all.stretches);
	return all;
}

void check_line(const Stream &p_stream, const MasterFormat *p_format, double p_most_wrong = 1.0e-4) {
	const Survival rare = survive_often(p_stream, p_format, 1.0e-4);
	CHECK(rare.clean > MESSAGES && rare.regained == rare.clean);
	const Survival often = survive_often(p_stream, p_format, 1.0e-3);
	CHECK(often.regained_share() >= 0.999);
	Survival both = rare;
	both.add(often);
	CHECK(both.wrong_share() <= p_most_wrong);
}

} // namespace

TEST(a_suit_with_orientations_survives) {
	const MasterFormat format = suit_format(15, output_mode::ORIENTATION);
	check_line(suit_stream(format, MESSAGES, 1), &format);
}

// Nothing distinguishes a slightly wrong acceleration from a right one: what an eight-bit checksum misses in the long
// messages of a suit that sends all measurements stays unnoticed.
TEST(a_suit_with_all_measurements_survives_with_more_errors) {
	const MasterFormat format = suit_format(10, output_mode::CALIBRATED | output_mode::ORIENTATION);
	check_line(suit_stream(format, MESSAGES / 2, 2), &format, 2.0e-3);
}

TEST(a_tracker_with_items_survives) {
	check_line(imu_stream(MESSAGES, 3), nullptr);
}

} // namespace test_corruption
