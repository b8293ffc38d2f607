// SPDX-License-Identifier: MIT
#include "device/items.hpp"
#include "suit/stand_alone.hpp"

#include <algorithm>
#include <cmath>

namespace emulator {
namespace {

using kinematics::Quat;
using kinematics::Vec3;

constexpr double DEGREES = 57.29577951308232;
constexpr uint8_t STATUS = 0x03;
/// Pa.
constexpr uint32_t PRESSURE = 101325;

/// What a tracker measures and tells, of all items that there are.
constexpr uint16_t OFFERED[] = { xbus::item::TEMPERATURE, xbus::item::PACKET_COUNTER, xbus::item::SAMPLE_TIME_FINE,
	xbus::item::SAMPLE_TIME_COARSE, xbus::item::QUATERNION, xbus::item::ROTATION_MATRIX, xbus::item::EULER_ANGLES,
	xbus::item::BARO_PRESSURE, xbus::item::ACCELERATION, xbus::item::FREE_ACCELERATION, xbus::item::RATE_OF_TURN,
	xbus::item::MAGNETIC_FIELD, xbus::item::STATUS_BYTE, xbus::item::STATUS_WORD };

std::array<double, 9> matrix_of(const Quat &p_rotation) {
	const Vec3 x = p_rotation.rotate({ 1.0F, 0.0F, 0.0F });
	const Vec3 y = p_rotation.rotate({ 0.0F, 1.0F, 0.0F });
	const Vec3 z = p_rotation.rotate({ 0.0F, 0.0F, 1.0F });
	// Row by row, the second index first to change: a, d, g, b, ... of the manual is what MTData holds.
	return { x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z };
}

std::array<double, 3> euler_of(const Quat &p_rotation) {
	const double x = p_rotation.x;
	const double y = p_rotation.y;
	const double z = p_rotation.z;
	const double w = p_rotation.w;
	const double sine = std::fmin(1.0, std::fmax(-1.0, 2.0 * (w * y - x * z)));
	const double roll = std::atan2(2.0 * (w * x + y * z), 1.0 - 2.0 * (x * x + y * y));
	const double yaw = std::atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z));
	return { roll * DEGREES, std::asin(sine) * DEGREES, yaw * DEGREES };
}

/// The orientation, which is north-west-up, in other axes.
Quat in_axes(const Quat &p_orientation, xbus::Axes p_axes) {
	const float half = std::sqrt(0.5F);
	switch (p_axes) {
		case xbus::Axes::EAST_NORTH_UP:
			return Quat{ 0.0F, 0.0F, half, half } * p_orientation;
		case xbus::Axes::NORTH_EAST_DOWN:
			return Quat{ 1.0F, 0.0F, 0.0F, 0.0F } * p_orientation;
		default:
			return p_orientation;
	}
}

} // namespace

xbus::FullSample sample_of(const Reading &p_reading, xbus::Axes p_axes, uint16_t p_counter, double p_time_s) {
	xbus::FullSample sample;
	sample.axes = p_axes;
	sample.counter = p_counter;
	sample.sample_time_fine = uint32_t(uint64_t(std::fmax(p_time_s, 0.0) * 1e4));
	sample.sample_time_coarse = uint32_t(std::fmax(p_time_s, 0.0));
	const Quat turn = in_axes(p_reading.orientation, p_axes);
	sample.quaternion = { turn.w, turn.x, turn.y, turn.z };
	sample.matrix = matrix_of(turn);
	sample.euler = euler_of(turn);
	sample.acceleration = p_reading.acceleration;
	const Vec3 felt = { float(p_reading.acceleration[0]), float(p_reading.acceleration[1]),
		float(p_reading.acceleration[2]) };
	const Vec3 world = p_reading.orientation.rotate(felt);
	sample.free_acceleration = { world.x, world.y, double(world.z) - GRAVITY };
	sample.rate_of_turn = p_reading.rate;
	sample.magnetic_field = p_reading.magnetic;
	sample.temperature = p_reading.temperature;
	sample.pressure = PRESSURE;
	sample.status_byte = STATUS;
	sample.status_word = STATUS;
	return sample;
}

bool offers_item(uint16_t p_identifier) {
	const xbus::ItemType &type = xbus::item_type(p_identifier);
	const bool has_form = type.kind == xbus::ItemKind::REALS;
	return std::find(std::begin(OFFERED), std::end(OFFERED), type.type) != std::end(OFFERED) &&
			(has_form || p_identifier == type.type);
}

void append_item(Data &r_data, uint16_t p_identifier, const xbus::FullSample &p_sample) {
	const std::size_t at = r_data.size();
	r_data.resize(at + xbus::MAX_ITEM);
	r_data.resize(at + xbus::write_item(p_identifier, p_sample, r_data.data() + at));
}

} // namespace emulator
