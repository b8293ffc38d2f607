// SPDX-License-Identifier: MIT
// Messages that were seen on real buses or stand in Xsens' manuals: read, and written byte by byte.
#include "bus_streams.hpp"

#include "bus/requests.hpp"

#include "check.hpp"

#include <algorithm>

namespace test_examples {

using namespace streams;

namespace {

bool is_request(const Request &p_request, const char *p_hex) {
	const Bytes wanted = hex(p_hex);
	return p_request.size == wanted.size() && std::equal(wanted.begin(), wanted.end(), p_request.bytes.begin());
}

/// The only message in these bytes; its data stay where they are.
Frame frame_in(const Bytes &p_bytes) {
	Frame found;
	std::size_t count = 0;
	Framer framer;
	framer.feed(p_bytes.data(), p_bytes.size(), [&](const Frame &p_frame) {
		found = p_frame;
		count++;
	});
	CHECK(count == 1 && framer.statistics().skipped_bytes == 0 && framer.pending() == 0);
	return found;
}

/// Decodes the MTData2 message and writes it again: the same bytes.
FullSample through(const char *p_hex, std::size_t p_items) {
	const Bytes bytes = hex(p_hex);
	const Frame frame = frame_in(bytes);
	CHECK(frame.message == Message::MT_DATA2 && frame.bus_id == MASTER);
	FullSample sample;
	const ItemReport report = decode_mt_data2(frame.data, frame.size, sample);
	CHECK(report.is_clean() && report.decoded == p_items);
	std::vector<uint16_t> ids;
	visit_items(frame.data, frame.size, [&](const Item &p_item) { ids.push_back(p_item.id); });
	Bytes again(MAX_FRAME);
	again.resize(device::write_mt_data2(ids.data(), ids.size(), sample, MASTER, again.data()));
	CHECK(again == bytes);
	return sample;
}

constexpr const char *OUTPUTS =
		"FA FF C0 2C 10 10 FF FF 40 20 00 64 40 30 00 64 80 20 00 64 50 43 00 0A C0 20 00 0A D0 10 00 0A 50 20 00 0A "
		"50 10 00 0A 20 30 00 0A 20 10 00 0A 72";
constexpr const char *CONFIGURATION =
		"FA FF 0D 76 03 60 08 A6 04 80 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 "
		"00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 "
		"00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 01 03 60 08 A6 00 00 "
		"00 00 00 00 00 00 00 27 01 04 0C 49 04 00 52";
constexpr const char *CALIBRATED =
		"FA FF 32 24 BE AB E3 71 BD E9 D2 C0 41 1D 11 0D B9 D6 91 F0 BC 01 90 57 BB 07 A3 35 BF 12 4C 38 3F F5 11 85 "
		"C2 E5 3D 09 E0";
constexpr const char *LIVE =
		"FA FF 32 36 3D 61 84 99 BD 25 59 AD 41 1D 13 ED 3B 1B 52 60 BA C1 12 34 BB 7F 21 3F BE 3A 38 CC 3E 49 C1 0C "
		"BE A3 FC DA 3E 8B AD 87 BB 53 02 CB 3B F3 D3 BA BF 76 47 E0 4B 33 41";
constexpr const char *LIVE_NEXT =
		"FA FF 32 36 3D A6 C6 84 BD 57 6F 7E 41 1D 09 6D 3C 08 2A 01 BC 07 80 3C 3A 60 94 CB BE 3A 15 78 3E 4A 34 50 "
		"BE A4 55 6A 3E 8B AE 07 BB 55 29 D1 3B F1 A4 08 BF 76 47 D5 4B 34 CE";

} // namespace

TEST(requests_are_as_in_the_manuals) {
	CHECK(is_request(host::go_to_config(), "FA FF 30 00 D1"));
	CHECK(is_request(host::go_to_measurement(), "FA FF 10 00 F1"));
	CHECK(is_request(host::request_device_id(), "FA FF 00 00 01"));
	CHECK(is_request(host::request(Message::SET_OUTPUT_MODE), "FA FF D0 00 31"));
	CHECK(is_request(host::request(Message::REQ_DATA, 1), "FA 01 34 00 CB"));
	CHECK(is_request(host::init_bus(), "FA FF 02 00 FF"));
	CHECK(is_request(host::wake_up_ack(), "FA FF 3F 00 C2"));
	CHECK(is_request(host::reset(), "FA FF 40 00 C1"));
	CHECK(is_request(host::request(Message::REQ_PRODUCT_CODE), "FA FF 1C 00 E5"));
	CHECK(is_request(host::request(Message::REQ_FIRMWARE_REVISION), "FA FF 12 00 EF"));
	CHECK(is_request(host::request_configuration(), "FA FF 0C 00 F5"));
	CHECK(is_request(host::set_output_mode(6, 1), "FA 01 D0 02 00 06 27"));
	CHECK(is_request(host::set_output_settings(0, 1), "FA 01 D2 04 00 00 00 00 29"));
	CHECK(is_request(host::set_period(1152), "FA FF 04 02 04 80 77"));
}

TEST(an_output_configuration_goes_both_ways) {
	const Bytes bytes = hex(OUTPUTS);
	const Frame frame = frame_in(bytes);
	std::array<OutputRequest, 32> outputs;
	std::size_t count = 0;
	CHECK(parse_output_configuration(frame.data, frame.size, outputs.data(), outputs.size(), count));
	CHECK(count == 11 && outputs[0].id == 0x1010 && outputs[0].rate == OutputRequest::EVERY);
	CHECK(outputs[4].id == 0x5043 && outputs[4].rate == 10);
	CHECK(is_request(host::set_output_configuration(outputs.data(), count), OUTPUTS));
	// Half a line, and more lines than there is room for.
	CHECK(!parse_output_configuration(frame.data, 43, outputs.data(), outputs.size(), count));
	CHECK(!parse_output_configuration(frame.data, frame.size, outputs.data(), 10, count) && count == 0);
}

TEST(answers_are_as_seen) {
	std::array<uint8_t, 64> bytes;
	const auto is = [&](std::size_t p_size, const char *p_hex) {
		const Bytes wanted = hex(p_hex);
		return p_size == wanted.size() && std::equal(wanted.begin(), wanted.end(), bytes.begin());
	};
	CHECK(is(device::write_ack(Message::GO_TO_CONFIG, MASTER, bytes.data()), "FA FF 31 00 D0"));
	CHECK(is(device::write_ack(Message::SET_OUTPUT_MODE, MASTER, bytes.data()), "FA FF D1 00 30"));
	CHECK(is(device::write_ack(Message::RESET, MASTER, bytes.data()), "FA FF 41 00 C0"));
	CHECK(is(device::write_wake_up(bytes.data()), "FA FF 3E 00 C3"));
	CHECK(is(device::write_device_id(0x036008A6, MASTER, bytes.data()), "FA FF 01 04 03 60 08 A6 EB"));
	CHECK(is(device::write_error(4, bytes.data()), "FA FF 42 01 04 BA"));
}

TEST(a_configuration_goes_both_ways) {
	const Bytes bytes = hex(CONFIGURATION);
	const Frame frame = frame_in(bytes);
	CHECK(frame.message == Message::CONFIGURATION && frame.size == 118);
	Configuration configuration;
	CHECK(configuration.parse(frame.data, frame.size) == ConfigurationFault::NONE);
	CHECK(configuration.master_id == 0x036008A6 && configuration.period == 1152);
	CHECK_NEAR(configuration.rate(), 100.0, 1e-9);
	CHECK(configuration.device_count == 1 && configuration.devices[0].device_id == 0x036008A6);
	CHECK(configuration.devices[0].scenario == 0x27);
	CHECK((configuration.devices[0].firmware == std::array<uint8_t, 3>{ 1, 4, 12 }));
	Bytes again(MAX_FRAME);
	again.resize(device::write_configuration(configuration, again.data()));
	CHECK(again == bytes);
}

TEST(calibrated_data_go_both_ways) {
	const Bytes bytes = hex(CALIBRATED);
	const Frame frame = frame_in(bytes);
	const OutputFormat format = { output_mode::CALIBRATED, 0 };
	FullSample sample;
	CHECK(decode_data(format, frame.data, frame.size, sample));
	CHECK_NEAR(sample.acceleration[2], 9.81666, 1e-5);
	CHECK(sample.has(Field::MAGNETIC_FIELD) && !sample.has(Field::COUNTER));
	Bytes again(MAX_FRAME);
	again.resize(device::write_mt_data(format, sample, MASTER, again.data()));
	CHECK(again == bytes);
	// One byte more or less is another format.
	CHECK(!decode_data(format, frame.data, frame.size - 1, sample) &&
			!decode_data(format, frame.data, frame.size + 1, sample));
}

TEST(a_live_tracker_counts_at_the_end) {
	const OutputFormat format = { output_mode::CALIBRATED | output_mode::ORIENTATION, output_setting::SAMPLE_COUNTER };
	StreamCheck check;
	check.expect_tracker(format);
	for (const char *text : { LIVE, LIVE_NEXT }) {
		const Bytes bytes = hex(text);
		const Frame frame = frame_in(bytes);
		CHECK(check.take(frame) == StreamCheck::Verdict::DATA);
		const FullSample sample(check.sample(0));
		CHECK(sample.counter == (text == LIVE ? 0x4B33U : 0x4B34U));
		CHECK_NEAR(norm_deviation(sample.quaternion), 0.0, 1e-6);
		Bytes again(MAX_FRAME);
		again.resize(device::write_mt_data(format, sample, MASTER, again.data()));
		CHECK(again == bytes);
	}
	CHECK(check.device(MASTER).received == 2 && check.device(MASTER).lost == 0);
}

TEST(items_go_both_ways) {
	const FullSample mti =
			through("FA FF 36 26 20 10 10 3E FC 23 42 3F 00 E0 28 BF 01 8F A7 3E FE EE B1 10 60 04 00 0A F8 "
					"4C E0 20 04 00 00 00 02 10 20 02 1B C5 D4",
					4);
	CHECK(mti.counter == 0x1BC5 && mti.counter_bits == 16 && mti.sample_time_fine == 718924 && mti.status_word == 2);
	CHECK_NEAR(norm_deviation(mti.quaternion), 0.0, 1e-6);
	through("FA FF 36 4E 10 60 04 02 53 35 CB 20 10 10 3F 7F FA 66 BB 40 34 B8 3C 49 96 2D 3B 5A 1F 82 80 20 0C 39 FF "
			"91 01 BA EC DD 81 BA 86 53 80 40 20 0C BE 64 DB 99 BC E7 FF 83 41 1D C2 CF C0 20 0C BE 90 48 80 3F 67 32 "
			"04 BF 54 89 04 E0 20 04 00 00 00 03 C9",
			6);
	through("FA FF 36 31 10 20 02 DF C5 10 60 04 00 45 9D A0 40 20 0C BE DC 9A FA 3F 54 9F 37 41 1C BB 70 80 20 0C BB "
			"AA 5C 80 3B 8C 55 01 BB 81 33 00 E0 20 04 00 00 00 81 45",
			5);
	through("FA FF 36 14 10 20 02 00 09 20 30 0C BF BC 67 E0 3E DF AE 81 40 A3 A9 DF A7", 2);
	through("FA FF 36 16 10 60 04 09 3A 7C B7 20 30 0C BF 49 1A 52 BE C3 6A 10 C3 2E E2 EF 3E", 2);
	const FullSample hr = through("FA FF 36 0F 80 40 0C 3B 8B BC 00 BB E2 4F 00 3B 4E 4A 00 AF", 1);
	CHECK(hr.has(Further::RATE_OF_TURN_HR) && !hr.has(Field::COUNTER));
	const FullSample live =
			through("FA FF 36 44 10 20 02 E6 86 10 60 04 00 57 51 26 20 10 10 3F 7F 1D DE BD A6 35 08 BC "
					"8E 1B CD 3A B3 C0 88 40 20 0C 3E B6 FC 53 BF C6 F4 B9 41 17 26 91 80 20 0C BB B3 84 "
					"00 3C 1F C8 BD BA 8D E7 8C E0 20 04 00 00 00 01 7A",
					6);
	CHECK(live.axes == Axes::EAST_NORTH_UP && live.counter == 0xE686);
	CHECK_NEAR(live.quaternion[0], 0.9965495, 1e-6);
}

} // namespace test_examples
