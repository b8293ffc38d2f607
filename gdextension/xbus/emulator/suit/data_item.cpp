// SPDX-License-Identifier: MIT
#include "bus/bytes.hpp"
#include "device/number_writer.hpp"
#include "suit/stand_alone.hpp"

#include <cmath>

namespace emulator {
namespace {

using kinematics::Quat;
using kinematics::Vec3;

constexpr double GRAVITY = 9.81;

/// An item under construction: identifier, length, values.
class Item {
public:
	Item(Data &r_data, uint16_t p_identifier) : _data(r_data), _begin(r_data.size()) {
		append_u16(_data, p_identifier);
		_data.push_back(0);
	}
	Item(const Item &) = delete;
	Item &operator=(const Item &) = delete;
	~Item() { _data[_begin + 2] = uint8_t(_data.size() - _begin - 3); }

	void add(const double *p_values, std::size_t p_count, xbus::NumberFormat p_format) {
		const std::size_t at = _data.size();
		_data.resize(at + p_count * 8);
		_data.resize(at + xbus::write_numbers(p_format, p_values, p_count, _data.data() + at));
	}

private:
	Data &_data;
	std::size_t _begin;
};

/// The orientation in the axes that the identifier asks for: 0 east-north-up, 4 north-east-down, 8 as it is.
Quat in_axes(const Quat &p_orientation, unsigned p_axes) {
	const float half = std::sqrt(0.5F);
	if (p_axes == 0) {
		return Quat{ 0.0F, 0.0F, half, half } * p_orientation;
	}
	return p_axes == 4 ? Quat{ 1.0F, 0.0F, 0.0F, 0.0F } * p_orientation : p_orientation;
}

bool append_orientation(Data &r_data, uint16_t p_identifier, const Reading &p_reading) {
	const auto format = xbus::NumberFormat(p_identifier & 3U);
	const Quat turn = in_axes(p_reading.orientation, p_identifier & 0xCU);
	Item item(r_data, p_identifier);
	switch (p_identifier & 0xFFF0U) {
		case 0x2010: {
			const double values[] = { turn.w, turn.x, turn.y, turn.z };
			item.add(values, 4, format);
			return true;
		}
		case 0x2020: {
			const double values[] = { 1.0 - 2.0 * double(turn.y * turn.y + turn.z * turn.z),
				2.0 * double(turn.x * turn.y + turn.w * turn.z), 2.0 * double(turn.x * turn.z - turn.w * turn.y),
				2.0 * double(turn.x * turn.y - turn.w * turn.z), 1.0 - 2.0 * double(turn.x * turn.x + turn.z * turn.z),
				2.0 * double(turn.y * turn.z + turn.w * turn.x), 2.0 * double(turn.x * turn.z + turn.w * turn.y),
				2.0 * double(turn.y * turn.z - turn.w * turn.x),
				1.0 - 2.0 * double(turn.x * turn.x + turn.y * turn.y) };
			item.add(values, 9, format);
			return true;
		}
		default: {
			constexpr double DEGREES = 57.29577951308232;
			const double sine = std::fmin(1.0, std::fmax(-1.0, 2.0 * double(turn.w * turn.y - turn.x * turn.z)));
			const double roll = std::atan2(2.0 * double(turn.w * turn.x + turn.y * turn.z),
					1.0 - 2.0 * double(turn.x * turn.x + turn.y * turn.y));
			const double yaw = std::atan2(2.0 * double(turn.w * turn.z + turn.x * turn.y),
					1.0 - 2.0 * double(turn.y * turn.y + turn.z * turn.z));
			const double values[] = { roll * DEGREES, std::asin(sine) * DEGREES, yaw * DEGREES };
			item.add(values, 3, format);
			return true;
		}
	}
}

/// What is not a number of a chosen format; false if it is none of them.
bool append_plain(Data &r_data, uint16_t p_identifier, uint16_t p_counter, double p_time_s) {
	const auto start = [&](uint8_t p_size) {
		append_u16(r_data, p_identifier);
		r_data.push_back(p_size);
	};
	switch (p_identifier) {
		case 0x1020:
			start(2);
			append_u16(r_data, p_counter);
			return true;
		case 0x1060:
			start(4);
			append_u32(r_data, uint32_t(uint64_t(std::fmax(p_time_s, 0.0) * 1e4)));
			return true;
		case 0x1070:
			start(4);
			append_u32(r_data, uint32_t(std::fmax(p_time_s, 0.0)));
			return true;
		case 0x3010:
			start(4);
			append_u32(r_data, 101325);
			return true;
		case 0xE010:
			start(1);
			r_data.push_back(3);
			return true;
		case 0xE020:
			start(4);
			append_u32(r_data, 3);
			return true;
		default:
			return false;
	}
}

} // namespace

void append_item(Data &r_data, uint16_t p_identifier, const Reading &p_reading, uint16_t p_counter, double p_time_s) {
	const unsigned kind = p_identifier & 0xFFF0U;
	if (kind == 0x2010 || kind == 0x2020 || kind == 0x2030) {
		append_orientation(r_data, p_identifier, p_reading);
		return;
	}
	if (append_plain(r_data, p_identifier, p_counter, p_time_s)) {
		return;
	}
	const double *values = nullptr;
	std::array<double, 3> free_acceleration{};
	std::size_t count = 3;
	switch (kind) {
		case 0x0810:
			values = &p_reading.temperature;
			count = 1;
			break;
		case 0x4020:
			values = p_reading.acceleration.data();
			break;
		case 0x4030: {
			const Vec3 felt = { float(p_reading.acceleration[0]), float(p_reading.acceleration[1]),
				float(p_reading.acceleration[2]) };
			const Vec3 world = p_reading.orientation.rotate(felt);
			free_acceleration = { world.x, world.y, double(world.z) - GRAVITY };
			values = free_acceleration.data();
			break;
		}
		case 0x8020:
			values = p_reading.rate.data();
			break;
		case 0xC020:
			values = p_reading.magnetic.data();
			break;
		default:
			return;
	}
	Item(r_data, p_identifier).add(values, count, xbus::NumberFormat(p_identifier & 3U));
}

} // namespace emulator
