// SPDX-License-Identifier: MIT
#include "device/items.hpp"

#include "device/item_structs.hpp"
#include "device/number_writer.hpp"

namespace xbus {

namespace {

template <typename T>
T &member(FullSample &r_sample, const ItemType &p_type) {
	auto &values = static_cast<FurtherValues &>(r_sample);
	return *reinterpret_cast<T *>(reinterpret_cast<uint8_t *>(&values) + p_type.offset);
}

template <typename T>
const T &member(const FullSample &p_sample, const ItemType &p_type) {
	const auto &values = static_cast<const FurtherValues &>(p_sample);
	return *reinterpret_cast<const T *>(reinterpret_cast<const uint8_t *>(&values) + p_type.offset);
}

void decode_integer(const ItemType &p_type, const uint8_t *p_data, FullSample &r_sample) {
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

void decode_struct(const ItemType &p_type, const Item &p_item, FullSample &r_sample) {
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
			read_raw(p_item.data, r_sample);
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

std::size_t write_integer(const ItemType &p_type, const FullSample &p_sample, uint8_t *r_bytes) {
	switch (p_type.kind) {
		case ItemKind::U8:
			*r_bytes = member<uint8_t>(p_sample, p_type);
			return 1;
		case ItemKind::U16:
			write_u16(member<uint16_t>(p_sample, p_type), r_bytes);
			return 2;
		case ItemKind::U32:
			write_u32(member<uint32_t>(p_sample, p_type), r_bytes);
			return 4;
		default:
			write_u64(member<uint64_t>(p_sample, p_type), r_bytes);
			return 8;
	}
}

/// An integer of so many bytes: one that every sample has.
void write_known_integer(uint32_t p_value, std::size_t p_size, uint8_t *r_bytes) {
	if (p_size == 1) {
		*r_bytes = uint8_t(p_value);
	} else if (p_size == 2) {
		write_u16(uint16_t(p_value), r_bytes);
	} else {
		write_u32(p_value, r_bytes);
	}
}

/// Of the items that the product reads.
std::size_t write_known(uint16_t p_id, const FullSample &p_sample, uint8_t *r_bytes) {
	const Item item = { p_id };
	const Field field = item_field(p_id);
	const std::size_t written = write_field(item.format(), p_sample, field, r_bytes);
	if (written > 0) {
		return written;
	}
	write_known_integer(field == Field::COUNTER		   ? p_sample.counter
					: field == Field::SAMPLE_TIME_FINE ? p_sample.sample_time_fine
													   : p_sample.status_word,
			item_size(item), r_bytes);
	return item_size(item);
}

std::size_t write_further(const ItemType &p_type, NumberFormat p_format, const FullSample &p_sample, uint8_t *r_bytes) {
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

/// Whether an item of this type and format can be so long.
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

} // namespace

ItemFate decode_item(const Item &p_item, FullSample &r_sample) {
	if (item_field(p_item.id) != Field::COUNT) {
		return decode_item(p_item, static_cast<Sample &>(r_sample));
	}
	const ItemType &type = item_type(p_item.id);
	if (!is_item_size(type, p_item)) {
		return type.is_known() ? ItemFate::MISFIT : ItemFate::UNKNOWN;
	}
	if (type.kind == ItemKind::REALS) {
		read_numbers(p_item.format(), p_item.data, type.count, &member<double>(r_sample, type));
		r_sample.axes = type.has_axes() ? p_item.axes() : r_sample.axes;
	} else if (type.kind <= ItemKind::U64) {
		decode_integer(type, p_item.data, r_sample);
	} else {
		decode_struct(type, p_item, r_sample);
	}
	if (type.field != Further::COUNT) {
		r_sample.set(type.field);
	}
	return ItemFate::DECODED;
}

std::size_t write_item(uint16_t p_id, const FullSample &p_sample, uint8_t *r_bytes) {
	constexpr std::size_t HEAD = 3;
	const std::size_t size = item_field(p_id) != Field::COUNT
			? write_known(p_id, p_sample, r_bytes + HEAD)
			: write_further(item_type(p_id), Item{ p_id }.format(), p_sample, r_bytes + HEAD);
	if (size == 0) {
		return 0;
	}
	write_u16(p_id, r_bytes);
	r_bytes[2] = uint8_t(size);
	return HEAD + size;
}

std::size_t write_mt_data2(
		const uint16_t *p_ids, std::size_t p_count, const FullSample &p_sample, uint8_t *r_bytes, std::size_t p_room) {
	std::array<uint8_t, MAX_ITEM> bytes;
	std::size_t at = 0;
	for (std::size_t i = 0; i < p_count; i++) {
		const std::size_t size = write_item(p_ids[i], p_sample, bytes.data());
		if (size == 0 || size > p_room - at) {
			return 0;
		}
		std::memcpy(r_bytes + at, bytes.data(), size);
		at += size;
	}
	return at;
}

} // namespace xbus
