// SPDX-License-Identifier: MIT
#include "bus/data_item.hpp"

#include "bus/item_structs.hpp"

namespace xbus {

namespace {

template <typename T>
T &member(Sample &r_sample, const ItemType &p_type) {
	return *reinterpret_cast<T *>(reinterpret_cast<uint8_t *>(&r_sample) + p_type.offset);
}

template <typename T>
const T &member(const Sample &p_sample, const ItemType &p_type) {
	return *reinterpret_cast<const T *>(reinterpret_cast<const uint8_t *>(&p_sample) + p_type.offset);
}

uint8_t counter_bits(uint16_t p_type) {
	return p_type == item::PACKET_COUNTER_8 ? 8 : (p_type == item::PACKET_COUNTER ? 16 : 32);
}

void decode_integer(const ItemType &p_type, const uint8_t *p_data, Sample &r_sample) {
	if (p_type.field == Field::COUNTER) {
		r_sample.counter_bits = counter_bits(p_type.type);
		r_sample.counter = p_type.kind == ItemKind::U8 ? read_u8(p_data)
				: p_type.kind == ItemKind::U16		   ? read_u16(p_data)
													   : read_u32(p_data);
		return;
	}
	switch (p_type.kind) {
		case ItemKind::U8:
			member<uint8_t>(r_sample, p_type) = read_u8(p_data);
			break;
		case ItemKind::U16:
			member<uint16_t>(r_sample, p_type) = read_u16(p_data);
			break;
		case ItemKind::U32:
			member<uint32_t>(r_sample, p_type) = read_u32(p_data);
			break;
		default:
			member<uint64_t>(r_sample, p_type) = read_u64(p_data);
			break;
	}
}

void read_raw_vector(const uint8_t *p_data, std::array<uint16_t, 3> &r_vector) {
	for (std::size_t i = 0; i < r_vector.size(); i++) {
		r_vector[i] = read_u16(p_data + i * 2);
	}
}

void decode_raw(const uint8_t *p_data, Sample &r_sample) {
	read_raw_vector(p_data, r_sample.raw_acceleration);
	read_raw_vector(p_data + 6, r_sample.raw_rate_of_turn);
	read_raw_vector(p_data + 12, r_sample.raw_magnetic_field);
	r_sample.raw_temperature = read_u16(p_data + 18);
	r_sample.set(Field::RAW_RATE_OF_TURN);
	r_sample.set(Field::RAW_MAGNETIC_FIELD);
	r_sample.set(Field::RAW_TEMPERATURE);
}

void decode_struct(const ItemType &p_type, const Item &p_item, Sample &r_sample) {
	switch (p_type.kind) {
		case ItemKind::UTC:
			read_utc(p_item.data, r_sample.utc);
			break;
		case ItemKind::RANGE:
			r_sample.frame_range = { read_u16(p_item.data), read_u16(p_item.data + 2) };
			break;
		case ItemKind::TRIGGER:
			read_trigger(p_item.data, member<Trigger>(r_sample, p_type));
			break;
		case ItemKind::GNSS_PVT:
			read_gnss_pvt(p_item.data, r_sample.gnss_pvt);
			break;
		case ItemKind::SATELLITES:
			read_satellites(p_item.data, r_sample.gnss_satellites);
			break;
		case ItemKind::RAW:
			decode_raw(p_item.data, r_sample);
			break;
		case ItemKind::RAW_VECTOR:
			read_raw_vector(p_item.data, member<std::array<uint16_t, 3>>(r_sample, p_type));
			break;
		case ItemKind::AWINDA:
			read_awinda_snapshot(p_item.data, r_sample.snapshot);
			r_sample.snapshot.is_retransmission = (p_item.id & 1U) != 0;
			break;
		case ItemKind::FULL_SNAPSHOT:
			read_full_snapshot(p_item.data, r_sample.snapshot);
			r_sample.snapshot.is_retransmission = (p_item.id & 1U) != 0;
			break;
		default:
			break;
	}
}

std::size_t write_raw_vector(const std::array<uint16_t, 3> &p_vector, uint8_t *r_bytes) {
	for (std::size_t i = 0; i < p_vector.size(); i++) {
		write_u16(p_vector[i], r_bytes + i * 2);
	}
	return p_vector.size() * 2;
}

std::size_t write_raw(const Sample &p_sample, uint8_t *r_bytes) {
	write_raw_vector(p_sample.raw_acceleration, r_bytes);
	write_raw_vector(p_sample.raw_rate_of_turn, r_bytes + 6);
	write_raw_vector(p_sample.raw_magnetic_field, r_bytes + 12);
	write_u16(p_sample.raw_temperature, r_bytes + 18);
	return 20;
}

std::size_t write_integer(const ItemType &p_type, const Sample &p_sample, uint8_t *r_bytes) {
	// The three counters are one number in a sample.
	const bool counter = p_type.field == Field::COUNTER;
	switch (p_type.kind) {
		case ItemKind::U8:
			*r_bytes = counter ? uint8_t(p_sample.counter) : member<uint8_t>(p_sample, p_type);
			return 1;
		case ItemKind::U16:
			write_u16(counter ? uint16_t(p_sample.counter) : member<uint16_t>(p_sample, p_type), r_bytes);
			return 2;
		case ItemKind::U32:
			write_u32(member<uint32_t>(p_sample, p_type), r_bytes);
			return 4;
		default:
			write_u64(member<uint64_t>(p_sample, p_type), r_bytes);
			return 8;
	}
}

std::size_t write_value(const ItemType &p_type, NumberFormat p_format, const Sample &p_sample, uint8_t *r_bytes) {
	switch (p_type.kind) {
		case ItemKind::REALS:
			return write_numbers(p_format, &member<double>(p_sample, p_type), p_type.count, r_bytes);
		case ItemKind::U8:
		case ItemKind::U16:
		case ItemKind::U32:
		case ItemKind::U64:
			return write_integer(p_type, p_sample, r_bytes);
		case ItemKind::UTC:
			return write_utc(p_sample.utc, r_bytes);
		case ItemKind::RANGE:
			write_u16(p_sample.frame_range[0], r_bytes);
			write_u16(p_sample.frame_range[1], r_bytes + 2);
			return 4;
		case ItemKind::TRIGGER:
			return write_trigger(member<Trigger>(p_sample, p_type), r_bytes);
		case ItemKind::GNSS_PVT:
			return write_gnss_pvt(p_sample.gnss_pvt, r_bytes);
		case ItemKind::SATELLITES:
			return write_satellites(p_sample.gnss_satellites, r_bytes);
		case ItemKind::RAW:
			return write_raw(p_sample, r_bytes);
		case ItemKind::RAW_VECTOR:
			return write_raw_vector(member<std::array<uint16_t, 3>>(p_sample, p_type), r_bytes);
		case ItemKind::AWINDA:
			return write_awinda_snapshot(p_sample.snapshot, r_bytes);
		case ItemKind::FULL_SNAPSHOT:
			return write_full_snapshot(p_sample.snapshot, r_bytes);
		default:
			return 0;
	}
}

} // namespace

bool is_item_size(const ItemType &p_type, const Item &p_item) {
	switch (p_type.kind) {
		case ItemKind::REALS:
			return p_item.size == p_type.count * number_size(p_item.format());
		case ItemKind::U8:
			return p_item.size == 1;
		case ItemKind::U16:
			return p_item.size == 2;
		case ItemKind::U32:
		case ItemKind::RANGE:
			return p_item.size == 4;
		case ItemKind::U64:
		case ItemKind::TRIGGER:
			return p_item.size == 8;
		case ItemKind::UTC:
			return p_item.size == 12;
		case ItemKind::GNSS_PVT:
			return p_item.size == GNSS_PVT_SIZE;
		case ItemKind::SATELLITES:
			return p_item.size >= 8 && p_item.size == 8 + 4 * p_item.data[4];
		case ItemKind::RAW:
			return p_item.size == 20;
		case ItemKind::RAW_VECTOR:
			return p_item.size == 6;
		case ItemKind::AWINDA:
			return p_item.size == AWINDA_SNAPSHOT_SIZE;
		case ItemKind::FULL_SNAPSHOT:
			return p_item.size == FULL_SNAPSHOT_SIZE;
		case ItemKind::OPAQUE:
			return true;
		case ItemKind::UNKNOWN:
			break;
	}
	return false;
}

bool decode_item(const Item &p_item, Sample &r_sample) {
	const ItemType &type = item_type(p_item.id);
	if (!is_item_size(type, p_item)) {
		return false;
	}
	if (type.kind == ItemKind::REALS) {
		read_numbers(p_item.format(), p_item.data, type.count, &member<double>(r_sample, type));
		r_sample.axes = type.has_axes() ? p_item.axes() : r_sample.axes;
	} else if (type.kind <= ItemKind::U64) {
		decode_integer(type, p_item.data, r_sample);
	} else {
		decode_struct(type, p_item, r_sample);
	}
	if (type.field != Field::COUNT) {
		r_sample.set(type.field);
	}
	return true;
}

std::size_t write_item(uint16_t p_id, const Sample &p_sample, uint8_t *r_bytes) {
	constexpr std::size_t HEAD = 3;
	const std::size_t size = write_value(item_type(p_id), NumberFormat(p_id & 3U), p_sample, r_bytes + HEAD);
	if (size == 0) {
		return 0;
	}
	write_u16(p_id, r_bytes);
	r_bytes[2] = uint8_t(size);
	return HEAD + size;
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
