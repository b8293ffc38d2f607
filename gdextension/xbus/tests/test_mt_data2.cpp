// SPDX-License-Identifier: MIT
#include "bus_streams.hpp"

#include "check.hpp"

namespace test_mt_data2 {

using namespace streams;

namespace {

/// Every type of item that a sample holds, and the bytes of one with floats.
struct KnownItem {
	uint16_t type;
	std::size_t size;
};

constexpr std::array<KnownItem, 52> ITEMS = { { { 0x0810, 4 }, { 0x1010, 12 }, { 0x1020, 2 }, { 0x1030, 4 },
		{ 0x1040, 1 }, { 0x1050, 1 }, { 0x1060, 4 }, { 0x1070, 4 }, { 0x1080, 4 }, { 0x1090, 1 }, { 0x10A0, 8 },
		{ 0x10B0, 4 }, { 0x2010, 16 }, { 0x2020, 36 }, { 0x2030, 12 }, { 0x3010, 4 }, { 0x4010, 12 }, { 0x4020, 12 },
		{ 0x4030, 12 }, { 0x4040, 12 }, { 0x4810, 8 }, { 0x4820, 8 }, { 0x4830, 8 }, { 0x5010, 4 }, { 0x5020, 4 },
		{ 0x5030, 12 }, { 0x5040, 8 }, { 0x7010, 94 }, { 0x7020, 8 }, { 0x7030, 4 }, { 0x8020, 12 }, { 0x8030, 16 },
		{ 0x8040, 12 }, { 0xA010, 20 }, { 0xA020, 6 }, { 0xA030, 6 }, { 0xA040, 6 }, { 0xA050, 6 }, { 0xA060, 16 },
		{ 0xA070, 12 }, { 0xB010, 2 }, { 0xB020, 2 }, { 0xC020, 12 }, { 0xC030, 12 }, { 0xC810, 46 }, { 0xC820, 70 },
		{ 0xD010, 12 }, { 0xE010, 1 }, { 0xE020, 4 }, { 0xE040, 1 }, { 0xE080, 4 }, { 0xE090, 2 } } };

/// Bytes that are as random as the item's form allows.
Bytes draw_item(std::mt19937 &r_random, uint16_t p_id, std::size_t p_size) {
	Bytes bytes = { uint8_t(p_id >> 8U), uint8_t(p_id), uint8_t(p_size) };
	for (std::size_t i = 0; i < p_size; i++) {
		bytes.push_back(uint8_t(r_random() & 0x3FU));
	}
	if ((p_id & 0xFFF0U) == item::GNSS_SAT_INFO) {
		bytes[7] = uint8_t((p_size - 8) / 4);
		bytes[8] = bytes[9] = bytes[10] = 0;
	}
	return bytes;
}

} // namespace

TEST(every_item_goes_both_ways_in_every_format) {
	std::mt19937 random(1);
	for (const KnownItem &known : ITEMS) {
		const bool reals = item_type(known.type).kind == ItemKind::REALS;
		for (uint32_t low = 0; low < (reals ? 12U : 1U); low++) {
			const std::size_t number = std::array<std::size_t, 4>{ 4, 4, 6, 8 }[low & 3U];
			const std::size_t size = reals ? known.size / 4 * number : known.size;
			const auto id = uint16_t(uint32_t(known.type) | low);
			const Bytes bytes = draw_item(random, id, size);
			FullSample sample;
			const ItemReport report = decode_mt_data2(bytes.data(), bytes.size(), sample);
			CHECK(report.is_clean() && report.decoded == 1 && !sample.is_empty());
			CHECK(!item_type(id).has_axes() || sample.axes == Axes(low >> 2U));
			Bytes again(300);
			again.resize(write_mt_data2(&id, 1, sample, again.data(), again.size()));
			CHECK(again == bytes);
			// Cut short, and with a length that it cannot have.
			CHECK(!decode_mt_data2(bytes.data(), bytes.size() - 1, sample).whole);
			Bytes longer = bytes;
			longer.push_back(0);
			longer[2]++;
			const ItemReport odd = decode_mt_data2(longer.data(), longer.size(), sample);
			CHECK(odd.whole && odd.misfits == 1 && odd.decoded == 0 && sample.is_empty());
		}
	}
}

TEST(counters_come_in_three_sizes) {
	const Bytes bytes = { 0x10, 0x90, 1, 0xF0 };
	FullSample sample;
	CHECK(decode_mt_data2(bytes.data(), bytes.size(), sample).is_clean());
	CHECK(sample.counter == 0xF0 && sample.counter_bits == 8);
	const Bytes wide = { 0x10, 0xB0, 4, 0x80, 0, 0, 1 };
	CHECK(decode_mt_data2(wide.data(), wide.size(), sample).is_clean());
	CHECK(sample.counter == 0x80000001U && sample.counter_bits == 32);
}

TEST(what_is_unknown_is_skipped_and_counted) {
	const Bytes bytes = { 0x66, 0x60, 3, 1, 2, 3, 0x10, 0x20, 2, 0, 9, 0xA0, 0x80, 0 };
	FullSample sample;
	const ItemReport report = decode_mt_data2(bytes.data(), bytes.size(), sample);
	CHECK(report.whole && report.unknown == 1 && report.decoded == 2 && report.misfits == 0);
	CHECK(sample.counter == 9 && sample.has(Field::COUNTER));
	std::size_t visited = 0;
	CHECK(visit_items(bytes.data(), bytes.size(), [&](const Item &) { visited++; }) && visited == 3);
}

TEST(items_that_the_product_does_not_read_are_skipped_by_it) {
	std::mt19937 random(4);
	const FullSample sent = draw_sample(random);
	const std::array<uint16_t, 3> ids = { item::FREE_ACCELERATION, item::QUATERNION, item::UTC_TIME };
	Bytes bytes(100);
	bytes.resize(write_mt_data2(ids.data(), ids.size(), sent, bytes.data(), bytes.size()));
	Sample sample;
	const ItemReport report = decode_mt_data2(bytes.data(), bytes.size(), sample);
	CHECK(report.whole && report.unknown == 2 && report.decoded == 1);
	CHECK(sample.has(Field::QUATERNION));
	CHECK_NEAR(sample.quaternion[0], sent.quaternion[0], 1e-6);
}

TEST(items_fill_their_message_exactly) {
	const Bytes bytes = { 0x10, 0x20, 2, 0, 9, 0x10 };
	FullSample sample;
	CHECK(!decode_mt_data2(bytes.data(), 6, sample).whole && !decode_mt_data2(bytes.data(), 4, sample).whole);
	CHECK(decode_mt_data2(bytes.data(), 5, sample).whole);
	// Nothing at all is whole, and holds nothing.
	CHECK(decode_mt_data2(bytes.data(), 0, sample).whole && sample.is_empty());
}

TEST(satellites_are_as_many_as_they_say) {
	Bytes bytes = { 0x70, 0x20, 16, 0, 0, 1, 0, 2, 0, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8 };
	FullSample sample;
	CHECK(decode_mt_data2(bytes.data(), bytes.size(), sample).is_clean());
	CHECK(sample.gnss_satellites.itow == 256 && sample.gnss_satellites.count == 2);
	CHECK(sample.gnss_satellites.satellites[1].number == 6 && sample.gnss_satellites.satellites[1].signal == 7);
	bytes[7] = 3;
	CHECK(decode_mt_data2(bytes.data(), bytes.size(), sample).misfits == 1);
}

TEST(a_message_has_room_or_is_not_written) {
	std::mt19937 random(2);
	const FullSample sample = draw_sample(random);
	Bytes bytes(31);
	const std::array<uint16_t, 2> ids = { 0x4020, 0x2010 };
	CHECK(write_mt_data2(ids.data(), 1, sample, bytes.data(), 15) == 15);
	CHECK(write_mt_data2(ids.data(), 2, sample, bytes.data(), 31) == 0);
	const uint16_t unknown = 0x6660;
	CHECK(write_mt_data2(&unknown, 1, sample, bytes.data(), bytes.size()) == 0);
}

TEST(orientations_are_the_same_in_every_form) {
	std::mt19937 random(3);
	for (int i = 0; i < 500; i++) {
		const std::array<double, 4> sent = draw_quaternion(random);
		FullSample sample;
		sample.matrix = matrix_of(sent);
		sample.set(Field::MATRIX);
		std::array<double, 4> found{};
		CHECK(sample.orientation(found));
		double dot = 0.0;
		for (std::size_t k = 0; k < 4; k++) {
			dot += found[k] * sent[k];
		}
		CHECK_NEAR(std::fabs(dot), 1.0, 1e-12);
	}
	// 90 degrees about Z turn X into Y: yaw, and the first column.
	FullSample sample;
	sample.euler = { 0.0, 0.0, 90.0 };
	sample.set(Field::EULER);
	std::array<double, 4> found{};
	CHECK(sample.orientation(found));
	const std::array<double, 9> matrix = matrix_of(found);
	CHECK_NEAR(matrix[0], 0.0, 1e-12);
	CHECK_NEAR(matrix[1], 1.0, 1e-12);
	CHECK(!FullSample().orientation(found));
}

} // namespace test_mt_data2
