// SPDX-License-Identifier: MIT
#include "bus/data_item.hpp"

namespace xbus {

namespace {

void decode_counter(const Item &p_item, Sample &r_sample) {
	r_sample.counter_bits = uint8_t(p_item.size * 8U);
	r_sample.counter = p_item.size == 1 ? read_u8(p_item.data)
			: p_item.size == 2			? read_u16(p_item.data)
										: read_u32(p_item.data);
}

void decode_value(Field p_field, const Item &p_item, Sample &r_sample) {
	switch (p_field) {
		case Field::COUNTER:
			decode_counter(p_item, r_sample);
			break;
		case Field::SAMPLE_TIME_FINE:
			r_sample.sample_time_fine = read_u32(p_item.data);
			break;
		case Field::STATUS_WORD:
			r_sample.status_word = read_u32(p_item.data);
			break;
		default: {
			const Numbers found = r_sample.numbers(p_field);
			read_numbers(p_item.format(), p_item.data, found.count, found.values);
		}
	}
}

} // namespace

Field item_field(uint16_t p_id) {
	switch (p_id & 0xFFF0U) {
		case item::PACKET_COUNTER:
		case item::PACKET_COUNTER_8:
		case item::PACKET_COUNTER_32:
			return Field::COUNTER;
		case item::SAMPLE_TIME_FINE:
			return Field::SAMPLE_TIME_FINE;
		case item::QUATERNION:
			return Field::QUATERNION;
		case item::ROTATION_MATRIX:
			return Field::MATRIX;
		case item::EULER_ANGLES:
			return Field::EULER;
		case item::ACCELERATION:
			return Field::ACCELERATION;
		case item::RATE_OF_TURN:
			return Field::RATE_OF_TURN;
		case item::MAGNETIC_FIELD:
			return Field::MAGNETIC_FIELD;
		case item::STATUS_WORD:
			return Field::STATUS_WORD;
		default:
			return Field::COUNT;
	}
}

std::size_t item_size(const Item &p_item) {
	switch (item_field(p_item.id)) {
		case Field::COUNTER:
			return p_item.type() == item::PACKET_COUNTER_8 ? 1 : (p_item.type() == item::PACKET_COUNTER ? 2 : 4);
		case Field::SAMPLE_TIME_FINE:
		case Field::STATUS_WORD:
			return 4;
		case Field::QUATERNION:
			return 4 * number_size(p_item.format());
		case Field::MATRIX:
			return 9 * number_size(p_item.format());
		default:
			return 3 * number_size(p_item.format());
	}
}

ItemFate decode_item(const Item &p_item, Sample &r_sample) {
	const Field field = item_field(p_item.id);
	if (field == Field::COUNT) {
		return ItemFate::UNKNOWN;
	}
	if (p_item.size != item_size(p_item)) {
		return ItemFate::MISFIT;
	}
	decode_value(field, p_item, r_sample);
	r_sample.set(field);
	if (field == Field::QUATERNION || field == Field::MATRIX || field == Field::EULER) {
		r_sample.axes = p_item.axes();
	}
	return ItemFate::DECODED;
}

bool parse_output_configuration(
		const uint8_t *p_data, std::size_t p_size, OutputRequest *r_outputs, std::size_t p_most, std::size_t &r_count) {
	r_count = 0;
	if (p_size % 4 != 0 || p_size / 4 > p_most) {
		return false;
	}
	for (std::size_t i = 0; i < p_size / 4; i++) {
		r_outputs[i] = { read_u16(p_data + i * 4), read_u16(p_data + i * 4 + 2) };
	}
	r_count = p_size / 4;
	return true;
}

std::size_t write_output_configuration(
		const OutputRequest *p_outputs, std::size_t p_count, uint8_t *r_bytes, std::size_t p_room) {
	const std::size_t count = p_count < p_room / 4 ? p_count : p_room / 4;
	for (std::size_t i = 0; i < count; i++) {
		write_u16(p_outputs[i].id, r_bytes + i * 4);
		write_u16(p_outputs[i].rate, r_bytes + i * 4 + 2);
	}
	return count * 4;
}

} // namespace xbus
