// SPDX-License-Identifier: MIT
// Recordings of real trackers against the decodes that came with them: every field of every message, exactly.
#include "bus_streams.hpp"

#include "check.hpp"
#include <test_data.hpp>

#include <cinttypes>
#include <fstream>
#include <sstream>

namespace test_golden {

using namespace streams;

namespace {

/// An item as the golden files have it: "Acceleration(Float32)" and its values.
struct GoldenItem {
	std::string head;
	std::vector<std::string> values;
};

using GoldenMessage = std::vector<GoldenItem>;

std::string path_of(int p_set, const char *p_name) {
	return std::string(test_data::SOURCES) + "/../tests/data/xbus/" + std::to_string(p_set) + "/" + p_name;
}

/// Messages are apart by an empty line; values are indented, after "X:" or the like if they have names.
std::vector<GoldenMessage> read_golden(const std::string &p_path) {
	std::vector<GoldenMessage> messages(1);
	std::ifstream file(p_path);
	std::string line;
	while (std::getline(file, line)) {
		if (line.empty()) {
			messages.emplace_back();
		} else if (line[0] != ' ') {
			messages.back().push_back({ line.substr(0, line.rfind(':')), {} });
		} else {
			const std::string value = line.substr(2);
			const bool named = std::isalpha(uint8_t(value[0])) != 0 && value.find(':') != std::string::npos;
			messages.back().back().values.push_back(named ? value.substr(value.find(':') + 1) : value);
		}
	}
	while (!messages.empty() && messages.back().empty()) {
		messages.pop_back();
	}
	return messages;
}

std::string head_of(uint16_t p_id) {
	const ItemType &type = item_type(p_id);
	static const std::array<const char *, 4> FORMATS = { "Float32", "FP1220", "FP1632", "Float64" };
	static const std::array<const char *, 4> AXES = { "EastNorthUp", "NorthEastDown", "NorthWestUp", "?" };
	std::string head = type.name == nullptr ? "?" : type.name;
	if (type.kind == ItemKind::REALS) {
		const std::string axes = type.has_axes() ? std::string(AXES[std::size_t(Item{ p_id }.axes())]) + "," : "";
		head += "(" + axes + FORMATS[std::size_t(Item{ p_id }.format())] + ")";
	}
	return head;
}

std::string bits(uint32_t p_value, unsigned p_count) {
	std::string text;
	for (unsigned i = p_count; i > 0; i--) {
		text += (p_value >> (i - 1U) & 1U) != 0 ? '1' : '0';
	}
	return text;
}

/// As RFC 3339 has it, without zeros at the end of the fraction.
std::string utc_text(const UtcTime &p_utc) {
	std::array<char, 64> text;
	std::snprintf(text.data(), text.size(), "%04d-%02d-%02dT%02d:%02d:%02d.%09" PRIu32, p_utc.year, p_utc.month,
			p_utc.day, p_utc.hour, p_utc.minute, p_utc.second, p_utc.nanoseconds);
	std::string made = text.data();
	made.erase(made.find_last_not_of('0') + 1);
	made.erase(made.find_last_not_of('.') + 1);
	return made + "Z";
}

std::vector<double> gnss_numbers(const GnssPvt &p) {
	std::vector<double> numbers = { double(p.itow), double(p.utc.year), double(p.utc.month), double(p.utc.day),
		double(p.utc.hour), double(p.utc.minute), double(p.utc.second), double(p.utc.validity), double(p.time_accuracy),
		double(p.nanoseconds), double(p.fix_type), double(p.flags), double(p.satellites), double(p.reserved),
		double(p.longitude), double(p.latitude), double(p.height), double(p.height_msl), double(p.horizontal_accuracy),
		double(p.vertical_accuracy), double(p.velocity_north), double(p.velocity_east), double(p.velocity_down),
		double(p.ground_speed), double(p.heading_of_motion), double(p.speed_accuracy), double(p.heading_accuracy),
		double(p.heading_of_vehicle) };
	numbers.insert(numbers.end(), p.dilutions.begin(), p.dilutions.end());
	return numbers;
}

/// The numbers of an item that holds nothing else.
std::vector<double> numbers_of(uint16_t p_type, const FullSample &p) {
	const auto all = [](const auto &p_values) { return std::vector<double>(p_values.begin(), p_values.end()); };
	switch (p_type) {
		case item::PACKET_COUNTER:
			return { double(p.counter) };
		case item::SAMPLE_TIME_FINE:
			return { double(p.sample_time_fine) };
		case item::SAMPLE_TIME_COARSE:
			return { double(p.sample_time_coarse) };
		case item::EULER_ANGLES:
			return all(p.euler);
		case item::QUATERNION:
			return all(p.quaternion);
		case item::ROTATION_MATRIX:
			return all(p.matrix);
		case item::ACCELERATION:
			return all(p.acceleration);
		case item::FREE_ACCELERATION:
			return all(p.free_acceleration);
		case item::DELTA_V:
			return all(p.delta_v);
		case item::RATE_OF_TURN:
			return all(p.rate_of_turn);
		case item::DELTA_Q:
			return all(p.delta_q);
		case item::MAGNETIC_FIELD:
			return all(p.magnetic_field);
		case item::LAT_LON:
			return all(p.lat_lon);
		case item::ALTITUDE_ELLIPSOID:
			return { p.altitude_ellipsoid };
		case item::POSITION_ECEF:
			return all(p.position_ecef);
		case item::VELOCITY_XYZ:
			return all(p.velocity);
		case item::TEMPERATURE:
			return { p.temperature };
		case item::BARO_PRESSURE:
			return { double(p.pressure) };
		case item::GNSS_PVT_DATA:
			return gnss_numbers(p.gnss_pvt);
		default:
			return {};
	}
}

bool is_same(const GoldenItem &p_golden, const Item &p_item, const FullSample &p_sample) {
	if (p_golden.head != head_of(p_item.id)) {
		return false;
	}
	switch (p_item.type()) {
		case item::UTC_TIME:
			return p_golden.values == std::vector<std::string>{ utc_text(p_sample.utc) };
		case item::STATUS_BYTE:
			return p_golden.values == std::vector<std::string>{ bits(p_sample.status_byte, 8) };
		case item::STATUS_WORD:
			return p_golden.values == std::vector<std::string>{ bits(p_sample.status_word, 32) };
		default:
			break;
	}
	const std::vector<double> numbers = numbers_of(p_item.type(), p_sample);
	bool same = !numbers.empty() && numbers.size() == p_golden.values.size();
	for (std::size_t i = 0; same && i < numbers.size(); i++) {
		// Written with as many digits as distinguish one number from all others.
		same = std::strtod(p_golden.values[i].c_str(), nullptr) == numbers[i];
	}
	return same;
}

void check_message(const Frame &p_frame, const GoldenMessage &p_golden) {
	CHECK(p_frame.message == Message::MT_DATA2);
	FullSample whole;
	CHECK(decode_mt_data2(p_frame.data, p_frame.size, whole).is_clean());
	std::size_t at = 0;
	visit_items(p_frame.data, p_frame.size, [&](const Item &p_item) {
		FullSample sample;
		CHECK(decode_item(p_item, sample) == ItemFate::DECODED);
		CHECK(at < p_golden.size() && is_same(p_golden[at], p_item, sample));
		CHECK(at < p_golden.size() && is_same(p_golden[at], p_item, whole));
		at++;
	});
	CHECK(at == p_golden.size());
}

void check_set(int p_set) {
	const Bytes bytes = read_file(path_of(p_set, "output.bin"));
	const std::vector<GoldenMessage> golden = read_golden(path_of(p_set, "output.golden"));
	CHECK(golden.size() == 100);
	std::size_t message = 0;
	StreamCheck check;
	Framer framer;
	framer.feed(bytes.data(), bytes.size(), [&](const Frame &p_frame) {
		CHECK(check.take(p_frame) == StreamCheck::Verdict::DATA);
		CHECK(message < golden.size());
		if (message < golden.size()) {
			check_message(p_frame, golden[message]);
		}
		message++;
	});
	CHECK(message == golden.size());
	CHECK(framer.statistics().skipped_bytes == 0 && framer.pending() == 0);
	CHECK(check.device(MASTER).received == 100 && check.device(MASTER).lost == 0);
}

void check_outputs(int p_set) {
	const Bytes bytes = read_file(path_of(p_set, "outputconfig.bin"));
	const std::vector<GoldenMessage> golden = read_golden(path_of(p_set, "outputconfig.golden"));
	std::array<OutputRequest, 32> outputs;
	std::size_t count = 0;
	CHECK(parse_output_configuration(bytes.data(), bytes.size(), outputs.data(), outputs.size(), count));
	CHECK(golden.size() == 1 && golden[0].size() == count);
	for (std::size_t i = 0; i < count && i < golden[0].size(); i++) {
		const std::string rate =
				outputs[i].rate == OutputRequest::EVERY ? "Max" : std::to_string(outputs[i].rate) + " Hz";
		CHECK(golden[0][i].head == head_of(outputs[i].id) && golden[0][i].values[0] == rate);
	}
	std::array<uint8_t, 128> again;
	CHECK(write_output_configuration(outputs.data(), count, again.data(), again.size()) == bytes.size());
	CHECK(std::memcmp(again.data(), bytes.data(), bytes.size()) == 0);
}

} // namespace

TEST(recordings_in_floats_are_exact) {
	check_set(1);
}

TEST(recordings_in_fixed_point_12_20_are_exact) {
	check_set(2);
}

TEST(recordings_in_fixed_point_16_32_are_exact) {
	check_set(3);
}

TEST(output_configurations_are_exact) {
	for (int set = 1; set <= 3; set++) {
		check_outputs(set);
	}
}

} // namespace test_golden
