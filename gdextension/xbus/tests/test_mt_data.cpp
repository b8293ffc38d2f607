// SPDX-License-Identifier: MIT
#include "bus_streams.hpp"

#include "device/number_writer.hpp"

#include "check.hpp"

#include <cmath>
#include <limits>

namespace test_mt_data {

using namespace streams;

namespace {

using namespace output_mode;
using namespace output_setting;

constexpr std::array<uint32_t, 8> PARTS = { TEMPERATURE, CALIBRATED, ORIENTATION, AUXILIARY, POSITION, VELOCITY, STATUS,
	GPS_PVT };

/// What one step of a number format is worth.
double step_of(NumberFormat p_format, double p_value) {
	switch (p_format) {
		case NumberFormat::FLOAT:
			return std::fabs(p_value) * 1.2e-7;
		case NumberFormat::FIXED_12_20:
			return 1.0 / 1048576.0;
		case NumberFormat::FIXED_16_32:
			return 1.0 / 4294967296.0;
		default:
			return 0.0;
	}
}

template <std::size_t N>
bool near_all(const std::array<double, N> &p_a, const std::array<double, N> &p_b, NumberFormat p_format) {
	bool near = true;
	for (std::size_t i = 0; i < N; i++) {
		near = near && std::fabs(p_a[i] - p_b[i]) <= step_of(p_format, p_b[i]);
	}
	return near;
}

/// The length as the manual adds it up, part by part.
std::size_t length_in_manual(const OutputFormat &p_format) {
	const std::size_t number =
			std::array<std::size_t, 4>{ 4, 4, 6, 8 }[(p_format.settings & NUMBER_MASK) >> NUMBER_SHIFT];
	const auto on = [&](uint32_t p_bit) { return (p_format.mode & p_bit) != 0; };
	const auto has = [&](uint32_t p_bit) { return (p_format.settings & p_bit) != 0; };
	std::size_t size = on(TEMPERATURE) ? number : 0;
	for (const uint32_t left_out : { NO_ACCELERATION, NO_RATE_OF_TURN, NO_MAGNETIC_FIELD }) {
		size += on(CALIBRATED) && !has(left_out) ? 3 * number : 0;
	}
	const std::array<std::size_t, 4> forms = { 4, 3, 9, 0 };
	size += on(ORIENTATION) ? forms[(p_format.settings & ORIENTATION_MASK) >> 2U] * number : 0;
	for (const uint32_t left_out : { NO_ANALOG_1, NO_ANALOG_2 }) {
		size += on(AUXILIARY) && !has(left_out) ? 2 : 0;
	}
	size += on(POSITION) ? 3 * number : 0;
	size += on(VELOCITY) ? 3 * number : 0;
	size += on(STATUS) ? 1 : 0;
	size += on(GPS_PVT) ? 44 : 0;
	size += has(SAMPLE_COUNTER) ? 2 : 0;
	size += has(UTC) ? 12 : 0;
	return size;
}

bool is_same(const FullSample &p_found, const FullSample &p_sent, NumberFormat p_format) {
	const auto good = [&](auto p_field, bool p_good) { return !p_found.has(p_field) || p_good; };
	return good(Further::TEMPERATURE,
				   std::fabs(p_found.temperature - p_sent.temperature) <= step_of(p_format, p_sent.temperature)) &&
			good(Field::ACCELERATION, near_all(p_found.acceleration, p_sent.acceleration, p_format)) &&
			good(Field::RATE_OF_TURN, near_all(p_found.rate_of_turn, p_sent.rate_of_turn, p_format)) &&
			good(Field::MAGNETIC_FIELD, near_all(p_found.magnetic_field, p_sent.magnetic_field, p_format)) &&
			good(Field::QUATERNION, near_all(p_found.quaternion, p_sent.quaternion, p_format)) &&
			good(Field::EULER, near_all(p_found.euler, p_sent.euler, p_format)) &&
			good(Field::MATRIX, near_all(p_found.matrix, p_sent.matrix, p_format)) &&
			good(Further::POSITION, near_all(p_found.position, p_sent.position, p_format)) &&
			good(Further::VELOCITY, near_all(p_found.velocity, p_sent.velocity, p_format)) &&
			good(Further::ANALOG_IN_1, p_found.analog_in_1 == p_sent.analog_in_1) &&
			good(Further::ANALOG_IN_2, p_found.analog_in_2 == p_sent.analog_in_2) &&
			good(Further::STATUS_BYTE, p_found.status_byte == p_sent.status_byte) &&
			good(Field::COUNTER, p_found.counter == uint16_t(p_sent.counter)) &&
			good(Further::UTC_TIME,
					p_found.utc.nanoseconds == p_sent.utc.nanoseconds && p_found.utc.year == p_sent.utc.year &&
							p_found.utc.second == p_sent.utc.second);
}

/// Fields that a format announces.
FullSample fields_of(const OutputFormat &p_format) {
	FullSample announced;
	const auto set = [&](bool p_on, auto p_field) {
		if (p_on) {
			announced.set(p_field);
		}
	};
	const auto on = [&](uint32_t p_bit) { return (p_format.mode & p_bit) != 0; };
	const auto has = [&](uint32_t p_bit) { return (p_format.settings & p_bit) != 0; };
	set(on(TEMPERATURE), Further::TEMPERATURE);
	set(on(CALIBRATED) && !has(NO_ACCELERATION), Field::ACCELERATION);
	set(on(CALIBRATED) && !has(NO_RATE_OF_TURN), Field::RATE_OF_TURN);
	set(on(CALIBRATED) && !has(NO_MAGNETIC_FIELD), Field::MAGNETIC_FIELD);
	const std::array<Field, 3> forms = { Field::QUATERNION, Field::EULER, Field::MATRIX };
	set(on(ORIENTATION), forms[(p_format.settings & ORIENTATION_MASK) >> 2U]);
	set(on(AUXILIARY) && !has(NO_ANALOG_1), Further::ANALOG_IN_1);
	set(on(AUXILIARY) && !has(NO_ANALOG_2), Further::ANALOG_IN_2);
	set(on(POSITION), Further::POSITION);
	set(on(VELOCITY), Further::VELOCITY);
	set(on(STATUS), Further::STATUS_BYTE);
	set(on(GPS_PVT), Further::GPS_PVT);
	set(has(SAMPLE_COUNTER), Field::COUNTER);
	set(has(UTC), Further::UTC_TIME);
	return announced;
}

bool is_all_there(const FullSample &p_found, const FullSample &p_announced) {
	return p_found.present == p_announced.present && p_found.further_present == p_announced.further_present;
}

} // namespace

TEST(every_mode_and_setting_goes_both_ways) {
	std::mt19937 random(1);
	Bytes bytes(600);
	std::size_t wrong = 0;
	std::size_t tried = 0;
	for (uint32_t modes = 1; modes < 256; modes++) {
		uint32_t mode = 0;
		for (std::size_t i = 0; i < PARTS.size(); i++) {
			mode |= (modes >> i & 1U) != 0 ? PARTS[i] : 0U;
		}
		for (uint32_t numbers = 0; numbers < 4; numbers++) {
			for (uint32_t form = 0; form < 3; form++) {
				const uint32_t left_out = (random() & 7U) << 4U | (random() & 3U) << 10U | (random() & 3U);
				const OutputFormat format = { uint16_t(mode), left_out | numbers << NUMBER_SHIFT | form << 2U };
				const FullSample sent = draw_sample(random);
				const std::size_t size = write_block(format, sent, true, bytes.data());
				FullSample found;
				const bool good = format.is_valid() && size == length_in_manual(format) && size == format.size() &&
						(size == 0 || decode_data(format, bytes.data(), size, found)) &&
						is_all_there(found, size == 0 ? FullSample() : fields_of(format)) &&
						is_same(found, sent, format.numbers());
				wrong += good ? 0U : 1U;
				tried++;
				// One byte more or less, and it is something else.
				wrong += decode_data(format, bytes.data(), size + 1, found) ? 1U : 0U;
				wrong += size > 0 && decode_data(format, bytes.data(), size - 1, found) ? 1U : 0U;
			}
		}
	}
	CHECK(tried == 3060 && wrong == 0);
}

TEST(raw_data_stand_alone) {
	std::mt19937 random(2);
	const FullSample sent = draw_sample(random);
	const OutputFormat format = { RAW, SAMPLE_COUNTER };
	Bytes bytes(64);
	CHECK(write_block(format, sent, true, bytes.data()) == 22);
	FullSample found;
	CHECK(decode_data(format, bytes.data(), 22, found));
	CHECK(found.raw_acceleration == sent.raw_acceleration && found.raw_magnetic_field == sent.raw_magnetic_field);
	CHECK(found.raw_rate_of_turn == sent.raw_rate_of_turn && found.raw_temperature == sent.raw_temperature);
	CHECK(found.counter == uint16_t(sent.counter));
	CHECK(!OutputFormat({ RAW | ORIENTATION, 0 }).is_valid());
	CHECK(!OutputFormat({ 0x8000, 0 }).is_valid() && !OutputFormat({ 0x0040, 0 }).is_valid());
	CHECK(!OutputFormat({ ORIENTATION, 0x0C }).is_valid());
}

TEST(the_settings_decide_the_axes) {
	const OutputFormat down = { ORIENTATION, NORTH_EAST_DOWN };
	const Bytes bytes(16, 0);
	FullSample found;
	CHECK(decode_data(down, bytes.data(), bytes.size(), found) && found.axes == Axes::NORTH_EAST_DOWN);
	const OutputFormat up = { ORIENTATION, 0 };
	CHECK(decode_data(up, bytes.data(), bytes.size(), found) && found.axes == Axes::NORTH_WEST_UP);
}

TEST(a_master_counts_in_front) {
	std::mt19937 random(3);
	for (const std::size_t trackers : { 1, 10, 15, 16, 17, 64 }) {
		// Trackers may be set to count: behind a master they do not.
		const MasterFormat format = suit_format(trackers, ORIENTATION, SAMPLE_COUNTER);
		CHECK(format.size() == 2 + 16 * trackers);
		std::vector<FullSample> sent(trackers);
		for (FullSample &sample : sent) {
			sample = draw_sample(random);
		}
		Bytes bytes(MAX_FRAME);
		bytes.resize(device::write_mt_data(format, 0xABCD, sent.data(), bytes.data()));
		CHECK((bytes[3] == EXTENDED) == (trackers >= 16));
		std::vector<FullSample> found(trackers);
		std::size_t seen = 0;
		Framer framer;
		framer.feed(bytes.data(), bytes.size(), [&](const Frame &p_frame) {
			CHECK(read_u16(p_frame.data) == 0xABCD);
			CHECK(decode_data(format, p_frame.data, p_frame.size, found.data()));
			CHECK(!decode_data(format, p_frame.data, p_frame.size - 1, found.data()));
			seen++;
		});
		CHECK(seen == 1);
		for (std::size_t i = 0; i < trackers; i++) {
			CHECK(found[i].bus_id == i + 1 && found[i].counter == 0xABCD && found[i].counter_bits == 16);
			CHECK(near_all(found[i].quaternion, sent[i].quaternion, NumberFormat::FLOAT));
		}
	}
}

TEST(trackers_of_a_master_may_differ) {
	std::mt19937 random(4);
	MasterFormat format;
	CHECK(format.add({ ORIENTATION, 0 }) && format.add({ CALIBRATED | ORIENTATION, 0x300U | MATRIX }));
	CHECK(format.add({ TEMPERATURE, 0x200 }) && !format.add({ RAW | STATUS, 0 }));
	CHECK(format.size() == 2 + 16 + 18 * 8 + 6);
	const std::array<FullSample, 3> sent = { draw_sample(random), draw_sample(random), draw_sample(random) };
	Bytes bytes(format.size());
	CHECK(write_data(format, 7, sent.data(), bytes.data()) == bytes.size());
	std::array<FullSample, 3> found;
	CHECK(decode_data(format, bytes.data(), bytes.size(), found.data()));
	CHECK(found[1].matrix == sent[1].matrix && found[1].acceleration == sent[1].acceleration);
	CHECK_NEAR(found[2].temperature, sent[2].temperature, 1e-9);
}

TEST(too_many_trackers_are_refused) {
	MasterFormat format;
	std::size_t added = 0;
	while (added < 100 && format.add({ CALIBRATED | ORIENTATION, 0x300U | MATRIX })) {
		added++;
	}
	CHECK(added == (MAX_DATA - 2) / 144 || added == MAX_DEVICES);
	CHECK(format.size() <= MAX_DATA);
}

TEST(fixed_point_keeps_within_its_range) {
	Bytes bytes(8);
	const auto through = [&](NumberFormat p_format, double p_value) {
		double found = 0.0;
		write_numbers(p_format, &p_value, 1, bytes.data());
		read_numbers(p_format, bytes.data(), 1, &found);
		return found;
	};
	CHECK(through(NumberFormat::FIXED_12_20, 1.0e9) == 2048.0 - 1.0 / 1048576.0);
	CHECK(through(NumberFormat::FIXED_12_20, -1.0e9) == -2048.0);
	CHECK(through(NumberFormat::FIXED_16_32, 1.0e9) == 32768.0 - 1.0 / 4294967296.0);
	CHECK(through(NumberFormat::FIXED_16_32, -std::numeric_limits<double>::infinity()) == -32768.0);
	CHECK(through(NumberFormat::FIXED_16_32, std::nan("")) == 0.0);
	CHECK(std::isinf(through(NumberFormat::FLOAT, 1.0e300)) && std::isnan(through(NumberFormat::DOUBLE, std::nan(""))));
	CHECK(through(NumberFormat::FIXED_16_32, -0.25) == -0.25 && through(NumberFormat::FIXED_12_20, -0.25) == -0.25);
	// 0B D2 D9 60 00 00, from a recording.
	const Bytes recorded = { 0x0B, 0xD2, 0xD9, 0x60, 0x00, 0x00 };
	CHECK_NEAR(read_fixed_16_32(recorded.data()), 0.0461860522627830, 1e-15);
}

} // namespace test_mt_data
