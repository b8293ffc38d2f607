// SPDX-License-Identifier: MIT
#pragma once

#include "bus/number.hpp"
#include "bus/sample.hpp"

// The items of MTData2: what they are called, how long they are and where in a sample they go.

namespace xbus {

/// Types of items: the data identifier without its low four bits.
namespace item {
constexpr uint16_t TEMPERATURE = 0x0810;
constexpr uint16_t UTC_TIME = 0x1010;
constexpr uint16_t PACKET_COUNTER = 0x1020;
constexpr uint16_t ITOW = 0x1030;
constexpr uint16_t GNSS_AGE = 0x1040;
constexpr uint16_t PRESSURE_AGE = 0x1050;
constexpr uint16_t SAMPLE_TIME_FINE = 0x1060;
constexpr uint16_t SAMPLE_TIME_COARSE = 0x1070;
constexpr uint16_t FRAME_RANGE = 0x1080;
constexpr uint16_t PACKET_COUNTER_8 = 0x1090;
constexpr uint16_t SAMPLE_TIME_64 = 0x10A0;
constexpr uint16_t PACKET_COUNTER_32 = 0x10B0;
constexpr uint16_t QUATERNION = 0x2010;
constexpr uint16_t ROTATION_MATRIX = 0x2020;
constexpr uint16_t EULER_ANGLES = 0x2030;
constexpr uint16_t BARO_PRESSURE = 0x3010;
constexpr uint16_t DELTA_V = 0x4010;
constexpr uint16_t ACCELERATION = 0x4020;
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
constexpr uint16_t RATE_OF_TURN = 0x8020;
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
constexpr uint16_t MAGNETIC_FIELD = 0xC020;
constexpr uint16_t MAGNETIC_FIELD_CORRECTED = 0xC030;
constexpr uint16_t AWINDA_SNAPSHOT = 0xC810;
constexpr uint16_t FULL_SNAPSHOT = 0xC820;
constexpr uint16_t VELOCITY_XYZ = 0xD010;
constexpr uint16_t STATUS_BYTE = 0xE010;
constexpr uint16_t STATUS_WORD = 0xE020;
constexpr uint16_t RSSI = 0xE040;
constexpr uint16_t DEVICE_ID = 0xE080;
constexpr uint16_t LOCATION_ID = 0xE090;
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
	Field field = Field::COUNT;
	/// Of the value in Sample, for numbers.
	uint16_t offset = 0;
	/// As Xsens' manuals call it; null if unknown.
	const char *name = nullptr;

	bool is_known() const { return kind != ItemKind::UNKNOWN; }
	/// Whether the low bits of its identifier stand for axes.
	bool has_axes() const;
};

/// What is known of an identifier's type; UNKNOWN if nothing.
const ItemType &item_type(uint16_t p_id);

/// One item of MTData2 where it lies in its message.
struct Item {
	uint16_t id = 0;
	const uint8_t *data = nullptr;
	uint8_t size = 0;

	uint16_t type() const { return id & 0xFFF0U; }
	NumberFormat format() const { return NumberFormat(id & 3U); }
	Axes axes() const { return Axes(unsigned(id) >> 2U & 3U); }
};

/// Whether an item of this type and format can be so long.
bool is_item_size(const ItemType &p_type, const Item &p_item);

/// Decodes one item into the sample; false if its type is unknown, or its length wrong.
bool decode_item(const Item &p_item, Sample &r_sample);

/// Appends the item as the sample holds it, head included, to the data of an MTData2 message. Returns the bytes
/// written, 0 if the type is not one that a sample holds. `r_bytes` has room for 258 bytes.
std::size_t write_item(uint16_t p_id, const Sample &p_sample, uint8_t *r_bytes);

/// One line of SetOutputConfiguration (0xC0).
struct OutputRequest {
	/// Rate that stands for "with every message".
	static constexpr uint16_t EVERY = 0xFFFF;

	uint16_t id = 0;
	/// Hz.
	uint16_t rate = 0;
};

/// Reads a SetOutputConfiguration or its acknowledgement; false if its length cannot be, or if there are more
/// than `p_most` lines.
bool parse_output_configuration(
		const uint8_t *p_data, std::size_t p_size, OutputRequest *r_outputs, std::size_t p_most, std::size_t &r_count);

/// Writes as many lines as there is room for; returns the bytes written.
std::size_t write_output_configuration(
		const OutputRequest *p_outputs, std::size_t p_count, uint8_t *r_bytes, std::size_t p_room);

} // namespace xbus
