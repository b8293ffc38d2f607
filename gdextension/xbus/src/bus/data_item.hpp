// SPDX-License-Identifier: MIT
#pragma once

#include "bus/number.hpp"
#include "bus/sample.hpp"

// The items of MTData2 that are read: how long they are and where in a sample they go.

namespace xbus {

/// Types of items: the data identifier without its low four bits.
namespace item {
constexpr uint16_t PACKET_COUNTER = 0x1020;
constexpr uint16_t SAMPLE_TIME_FINE = 0x1060;
constexpr uint16_t PACKET_COUNTER_8 = 0x1090;
constexpr uint16_t PACKET_COUNTER_32 = 0x10B0;
constexpr uint16_t QUATERNION = 0x2010;
constexpr uint16_t ROTATION_MATRIX = 0x2020;
constexpr uint16_t EULER_ANGLES = 0x2030;
constexpr uint16_t ACCELERATION = 0x4020;
constexpr uint16_t RATE_OF_TURN = 0x8020;
constexpr uint16_t MAGNETIC_FIELD = 0xC020;
constexpr uint16_t STATUS_WORD = 0xE020;
} // namespace item

/// One item of MTData2 where it lies in its message.
struct Item {
	uint16_t id = 0;
	const uint8_t *data = nullptr;
	uint8_t size = 0;

	uint16_t type() const { return id & 0xFFF0U; }
	NumberFormat format() const { return NumberFormat(id & 3U); }
	Axes axes() const { return Axes(unsigned(id) >> 2U & 3U); }
};

/// What became of an item.
enum class ItemFate : uint8_t {
	DECODED,
	/// Of a type that is not known.
	UNKNOWN,
	/// Of a length that its type cannot have.
	MISFIT,
};

/// The field that an identifier's type fills; COUNT for a type that is not read.
Field item_field(uint16_t p_id);

/// Bytes of an item of a type that is read, in the format that its identifier names.
std::size_t item_size(const Item &p_item);

/// Decodes one item into the sample.
ItemFate decode_item(const Item &p_item, Sample &r_sample);

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
