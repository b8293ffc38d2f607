// SPDX-License-Identifier: MIT
#pragma once

#include "bus/mt_data2.hpp"
#include "device/full_sample.hpp"

// All items of MTData2: their names, those that the product does not read, and how all are written.

namespace xbus {

namespace item {
constexpr uint16_t TEMPERATURE = 0x0810;
constexpr uint16_t UTC_TIME = 0x1010;
constexpr uint16_t ITOW = 0x1030;
constexpr uint16_t GNSS_AGE = 0x1040;
constexpr uint16_t PRESSURE_AGE = 0x1050;
constexpr uint16_t SAMPLE_TIME_COARSE = 0x1070;
constexpr uint16_t FRAME_RANGE = 0x1080;
constexpr uint16_t SAMPLE_TIME_64 = 0x10A0;
constexpr uint16_t BARO_PRESSURE = 0x3010;
constexpr uint16_t DELTA_V = 0x4010;
constexpr uint16_t FREE_ACCELERATION = 0x4030;
constexpr uint16_t ACCELERATION_HR = 0x4040;
constexpr uint16_t TRIGGER_IN_1 = 0x4810;
constexpr uint16_t TRIGGER_IN_2 = 0x4820;
constexpr uint16_t TRIGGER_IN_3 = 0x4830;
constexpr uint16_t ALTITUDE_MSL = 0x5010;
constexpr uint16_t ALTITUDE_ELLIPSOID = 0x5020;
constexpr uint16_t POSITION_ECEF = 0x5030;
constexpr uint16_t LAT_LON = 0x5040;
constexpr uint16_t GNSS_PVT_DATA = 0x7010;
constexpr uint16_t GNSS_SAT_INFO = 0x7020;
constexpr uint16_t GNSS_PVT_PULSE = 0x7030;
constexpr uint16_t DELTA_Q = 0x8030;
constexpr uint16_t RATE_OF_TURN_HR = 0x8040;
constexpr uint16_t RAW_ACC_GYR_MAG_TEMP = 0xA010;
constexpr uint16_t RAW_GYRO_TEMP = 0xA020;
constexpr uint16_t RAW_ACC = 0xA030;
constexpr uint16_t RAW_GYR = 0xA040;
constexpr uint16_t RAW_MAG = 0xA050;
constexpr uint16_t RAW_DELTA_Q = 0xA060;
constexpr uint16_t RAW_DELTA_V = 0xA070;
constexpr uint16_t RAW_BLOB = 0xA080;
constexpr uint16_t ANALOG_IN_1 = 0xB010;
constexpr uint16_t ANALOG_IN_2 = 0xB020;
constexpr uint16_t MAGNETIC_FIELD_CORRECTED = 0xC030;
constexpr uint16_t AWINDA_SNAPSHOT = 0xC810;
constexpr uint16_t FULL_SNAPSHOT = 0xC820;
constexpr uint16_t VELOCITY_XYZ = 0xD010;
constexpr uint16_t STATUS_BYTE = 0xE010;
constexpr uint16_t RSSI = 0xE040;
constexpr uint16_t DEVICE_ID = 0xE080;
constexpr uint16_t LOCATION_ID = 0xE090;
constexpr uint16_t EVERY = 0xFFFF;
} // namespace item

/// What an item's bytes are.
enum class ItemKind : uint8_t {
	UNKNOWN,
	/// Real numbers in the format that the identifier names.
	REALS,
	U8,
	U16,
	U32,
	U64,
	UTC,
	/// Two numbers of 16 bits.
	RANGE,
	TRIGGER,
	GNSS_PVT,
	SATELLITES,
	/// Accelerations, rates, magnetic field, temperature: ten numbers of 16 bits.
	RAW,
	/// Three numbers of 16 bits.
	RAW_VECTOR,
	AWINDA,
	FULL_SNAPSHOT,
	/// Known by name, but nothing that a sample holds.
	OPAQUE,
};

/// What is known of a type of item.
struct ItemType {
	uint16_t type = 0;
	ItemKind kind = ItemKind::UNKNOWN;
	/// Numbers, if they are REALS; else 1.
	uint8_t count = 1;
	/// COUNT for those of `Field`, and for what a sample does not hold.
	Further field = Further::COUNT;
	/// Of the value in FurtherValues.
	uint16_t offset = 0;
	/// As Xsens' manuals call it; null if unknown.
	const char *name = nullptr;

	bool is_known() const { return kind != ItemKind::UNKNOWN; }
	/// Whether the low bits of its identifier stand for axes.
	bool has_axes() const;
};

/// What is known of an identifier's type; UNKNOWN if nothing.
const ItemType &item_type(uint16_t p_id);

const char *axes_name(Axes p_axes);
const char *number_format_name(NumberFormat p_format);

/// Decodes one item into the sample, whatever it is: also for `decode_mt_data2`.
ItemFate decode_item(const Item &p_item, FullSample &r_sample);

/// Bytes of the longest item, head included.
constexpr std::size_t MAX_ITEM = 3 + 255;

/// Appends the item as the sample holds it, head included, to the data of an MTData2 message. Returns the bytes
/// written, 0 if the type is not one that a sample holds. `r_bytes` has room for MAX_ITEM.
std::size_t write_item(uint16_t p_id, const FullSample &p_sample, uint8_t *r_bytes);

/// Writes the data of an MTData2 message with these items of the sample. Returns its size; 0 if there is no
/// room or an identifier that a sample does not hold.
std::size_t write_mt_data2(
		const uint16_t *p_ids, std::size_t p_count, const FullSample &p_sample, uint8_t *r_bytes, std::size_t p_room);

} // namespace xbus
