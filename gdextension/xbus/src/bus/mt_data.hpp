// SPDX-License-Identifier: MIT
#pragma once

#include "bus/number.hpp"
#include "bus/sample.hpp"

namespace xbus {

/// Bits of OutputMode (0xD0).
namespace output_mode {
constexpr uint32_t TEMPERATURE = 0x0001;
constexpr uint32_t CALIBRATED = 0x0002;
constexpr uint32_t ORIENTATION = 0x0004;
constexpr uint32_t AUXILIARY = 0x0008;
constexpr uint32_t POSITION = 0x0010;
constexpr uint32_t VELOCITY = 0x0020;
constexpr uint32_t STATUS = 0x0800;
constexpr uint32_t GPS_PVT = 0x1000;
/// Not together with the others, except GPS_PVT.
constexpr uint32_t RAW = 0x4000;
/// Of the MT9, older than the bus.
constexpr uint32_t MT9 = 0x8000;
} // namespace output_mode

/// Bits of OutputSettings (0xD2).
namespace output_setting {
constexpr uint32_t TIMESTAMP_MASK = 0x00000003;
constexpr uint32_t SAMPLE_COUNTER = 0x00000001;
constexpr uint32_t UTC = 0x00000002;
constexpr uint32_t ORIENTATION_MASK = 0x0000000C;
constexpr uint32_t QUATERNION = 0x00000000;
constexpr uint32_t EULER = 0x00000004;
constexpr uint32_t MATRIX = 0x00000008;
constexpr uint32_t NO_ACCELERATION = 0x00000010;
constexpr uint32_t NO_RATE_OF_TURN = 0x00000020;
constexpr uint32_t NO_MAGNETIC_FIELD = 0x00000040;
constexpr uint32_t NUMBER_MASK = 0x00000300;
constexpr unsigned NUMBER_SHIFT = 8;
constexpr uint32_t NO_ANALOG_1 = 0x00000400;
constexpr uint32_t NO_ANALOG_2 = 0x00000800;
constexpr uint32_t NORTH_EAST_DOWN = 0x80000000;
} // namespace output_setting

/// What a legacy tracker puts into MTData (0x32).
struct OutputFormat {
	uint16_t mode = 0;
	uint32_t settings = 0;

	NumberFormat numbers() const {
		return NumberFormat((settings & output_setting::NUMBER_MASK) >> output_setting::NUMBER_SHIFT);
	}
	/// Whether any device could send this, and all that it holds is understood.
	bool is_valid() const;
	/// Data bytes of one sample, of a tracker that stands alone.
	std::size_t size() const;
	/// The same without time stamps, which a master sends once, in front, for all its trackers.
	std::size_t size_behind_master() const;

	/// Decodes the block of one tracker, of exactly the size given; false if it is not.
	bool decode(const uint8_t *p_data, std::size_t p_size, Sample &r_sample) const;
	bool decode_behind_master(const uint8_t *p_data, std::size_t p_size, Sample &r_sample) const;
};

/// What a tracker's block in MTData is made of.
enum class DataPart : uint8_t {
	RAW,
	GPS_PVT,
	TEMPERATURE,
	ACCELERATION,
	RATE_OF_TURN,
	MAGNETIC_FIELD,
	QUATERNION,
	EULER,
	MATRIX,
	ANALOG_1,
	ANALOG_2,
	POSITION,
	VELOCITY,
	STATUS,
	COUNTER,
	UTC,
};

/// Bytes of a part.
std::size_t part_size(DataPart p_part, NumberFormat p_numbers);

/// Calls `p_visit(DataPart)` for each part of a tracker's block in their order; `p_with_time`: of one that stands
/// alone. This is the only place that knows the order: it serves reading, writing and measuring.
template <class V>
void visit_parts(const OutputFormat &p_format, bool p_with_time, V &&p_visit) {
	using namespace output_mode;
	using namespace output_setting;
	const auto visit_if = [&](bool p_is, DataPart p_part) {
		if (p_is) {
			p_visit(p_part);
		}
	};
	const auto on = [&](uint32_t p_bit) { return (p_format.mode & p_bit) != 0; };
	const auto has = [&](uint32_t p_bit) { return (p_format.settings & p_bit) != 0; };
	const uint32_t form = p_format.settings & ORIENTATION_MASK;
	visit_if(on(RAW), DataPart::RAW);
	visit_if(on(GPS_PVT), DataPart::GPS_PVT);
	visit_if(on(TEMPERATURE), DataPart::TEMPERATURE);
	visit_if(on(CALIBRATED) && !has(NO_ACCELERATION), DataPart::ACCELERATION);
	visit_if(on(CALIBRATED) && !has(NO_RATE_OF_TURN), DataPart::RATE_OF_TURN);
	visit_if(on(CALIBRATED) && !has(NO_MAGNETIC_FIELD), DataPart::MAGNETIC_FIELD);
	visit_if(on(ORIENTATION),
			form == EULER			 ? DataPart::EULER
					: form == MATRIX ? DataPart::MATRIX
									 : DataPart::QUATERNION);
	visit_if(on(AUXILIARY) && !has(NO_ANALOG_1), DataPart::ANALOG_1);
	visit_if(on(AUXILIARY) && !has(NO_ANALOG_2), DataPart::ANALOG_2);
	visit_if(on(POSITION), DataPart::POSITION);
	visit_if(on(VELOCITY), DataPart::VELOCITY);
	visit_if(on(STATUS), DataPart::STATUS);
	visit_if(p_with_time && has(SAMPLE_COUNTER), DataPart::COUNTER);
	visit_if(p_with_time && has(UTC), DataPart::UTC);
}

/// The field that a part fills; COUNT for one that is not read.
Field part_field(DataPart p_part);

/// What a master sends: a counter, then a block for each of its trackers in the order of their identifiers.
class MasterFormat {
public:
	/// Bytes of the counter.
	static constexpr std::size_t HEAD = 2;

	/// Forgets all trackers.
	void clear();
	/// The next tracker's format; false if there are too many, or if it is not valid.
	bool add(const OutputFormat &p_format);

	std::size_t count() const { return _count; }
	const OutputFormat &format(std::size_t p_tracker) const { return _formats[p_tracker]; }
	/// Data bytes of a message.
	std::size_t size() const { return _size; }

	/// Decodes a message into as many samples as there are trackers, their bus identifiers and counters
	/// included; false if its size is not exactly right.
	bool decode(const uint8_t *p_data, std::size_t p_size, Sample *r_samples) const;

private:
	std::array<OutputFormat, MAX_DEVICES> _formats{};
	std::array<std::size_t, MAX_DEVICES> _sizes{};
	std::size_t _count = 0;
	std::size_t _size = HEAD;
};

} // namespace xbus
