// SPDX-License-Identifier: MIT
#include "bus/mt_data.hpp"

namespace xbus {

namespace {

using namespace output_mode;
using namespace output_setting;

constexpr uint32_t KNOWN_MODES =
		TEMPERATURE | CALIBRATED | ORIENTATION | AUXILIARY | POSITION | VELOCITY | STATUS | GPS_PVT | RAW;

/// Of a part: numbers in the format that the settings name, and bytes that are the same in every format.
struct PartLayout {
	DataPart part;
	Field field;
	uint8_t numbers;
	uint8_t bytes;
};

/// In the order of `DataPart`.
constexpr PartLayout LAYOUTS[] = {
	{ DataPart::RAW, Field::COUNT, 0, 20 },
	{ DataPart::GPS_PVT, Field::COUNT, 0, 44 },
	{ DataPart::TEMPERATURE, Field::COUNT, 1, 0 },
	{ DataPart::ACCELERATION, Field::ACCELERATION, 3, 0 },
	{ DataPart::RATE_OF_TURN, Field::RATE_OF_TURN, 3, 0 },
	{ DataPart::MAGNETIC_FIELD, Field::MAGNETIC_FIELD, 3, 0 },
	{ DataPart::QUATERNION, Field::QUATERNION, 4, 0 },
	{ DataPart::EULER, Field::EULER, 3, 0 },
	{ DataPart::MATRIX, Field::MATRIX, 9, 0 },
	{ DataPart::ANALOG_1, Field::COUNT, 0, 2 },
	{ DataPart::ANALOG_2, Field::COUNT, 0, 2 },
	{ DataPart::POSITION, Field::COUNT, 3, 0 },
	{ DataPart::VELOCITY, Field::COUNT, 3, 0 },
	{ DataPart::STATUS, Field::COUNT, 0, 1 },
	{ DataPart::COUNTER, Field::COUNTER, 0, 2 },
	{ DataPart::UTC, Field::COUNT, 0, 12 },
};

constexpr bool is_in_order() {
	std::size_t at = 0;
	for (const PartLayout &layout : LAYOUTS) {
		if (std::size_t(layout.part) != at++) {
			return false;
		}
	}
	return true;
}

static_assert(is_in_order());

std::size_t measure(const OutputFormat &p_format, bool p_with_time) {
	std::size_t size = 0;
	visit_parts(p_format, p_with_time, [&](DataPart p_part) { size += part_size(p_part, p_format.numbers()); });
	return size;
}

void decode_block(const OutputFormat &p_format, bool p_with_time, const uint8_t *p_data, Sample &r_sample) {
	r_sample.clear();
	r_sample.axes = (p_format.settings & NORTH_EAST_DOWN) != 0 ? Axes::NORTH_EAST_DOWN : Axes::NORTH_WEST_UP;
	visit_parts(p_format, p_with_time, [&](DataPart p_part) {
		const Field field = part_field(p_part);
		if (field == Field::COUNTER) {
			r_sample.counter = read_u16(p_data);
			r_sample.counter_bits = 16;
		} else if (field != Field::COUNT) {
			const Numbers found = r_sample.numbers(field);
			read_numbers(p_format.numbers(), p_data, found.count, found.values);
		}
		if (field != Field::COUNT) {
			r_sample.set(field);
		}
		p_data += part_size(p_part, p_format.numbers());
	});
}

} // namespace

std::size_t part_size(DataPart p_part, NumberFormat p_numbers) {
	const PartLayout &layout = LAYOUTS[std::size_t(p_part)];
	return layout.numbers * number_size(p_numbers) + layout.bytes;
}

Field part_field(DataPart p_part) {
	return LAYOUTS[std::size_t(p_part)].field;
}

bool OutputFormat::is_valid() const {
	const uint32_t others = KNOWN_MODES & ~(RAW | GPS_PVT);
	const bool mixed = (mode & RAW) != 0 && (mode & others) != 0;
	const bool unknown = (mode & ~KNOWN_MODES) != 0;
	const uint32_t form = settings & ORIENTATION_MASK;
	const bool no_form = (mode & ORIENTATION) != 0 && form == ORIENTATION_MASK;
	return !mixed && !unknown && !no_form;
}

std::size_t OutputFormat::size() const {
	return measure(*this, true);
}

std::size_t OutputFormat::size_behind_master() const {
	return measure(*this, false);
}

bool OutputFormat::decode(const uint8_t *p_data, std::size_t p_size, Sample &r_sample) const {
	if (!is_valid() || p_size == 0 || p_size != size()) {
		return false;
	}
	decode_block(*this, true, p_data, r_sample);
	return true;
}

bool OutputFormat::decode_behind_master(const uint8_t *p_data, std::size_t p_size, Sample &r_sample) const {
	if (!is_valid() || p_size != size_behind_master()) {
		return false;
	}
	decode_block(*this, false, p_data, r_sample);
	return true;
}

void MasterFormat::clear() {
	_count = 0;
	_size = HEAD;
}

bool MasterFormat::add(const OutputFormat &p_format) {
	const std::size_t size = p_format.size_behind_master();
	if (_count == MAX_DEVICES || !p_format.is_valid() || _size + size > MAX_DATA) {
		return false;
	}
	_formats[_count] = p_format;
	_sizes[_count] = size;
	_count++;
	_size += size;
	return true;
}

bool MasterFormat::decode(const uint8_t *p_data, std::size_t p_size, Sample *r_samples) const {
	if (p_size != _size || _count == 0) {
		return false;
	}
	const uint16_t counter = read_u16(p_data);
	const uint8_t *block = p_data + HEAD;
	for (std::size_t i = 0; i < _count; i++) {
		Sample &sample = r_samples[i];
		decode_block(_formats[i], false, block, sample);
		sample.bus_id = uint8_t(i + 1);
		sample.counter = counter;
		sample.counter_bits = 16;
		sample.set(Field::COUNTER);
		block += _sizes[i];
	}
	return true;
}

} // namespace xbus
