// SPDX-License-Identifier: MIT
#include "suit/tracker.hpp"

#include "device/number_writer.hpp"

#include <cmath>
#include <cstring>

namespace emulator {
namespace {

using kinematics::Quat;
using kinematics::Vec3;

constexpr double GRAVITY = 9.81;
constexpr double DEGREES = 57.29577951308232;

// Bits of the output mode.
constexpr uint16_t TEMPERATURE = 0x0001;
constexpr uint16_t CALIBRATED = 0x0002;
constexpr uint16_t ORIENTATION = 0x0004;
constexpr uint16_t AUXILIARY = 0x0008;
constexpr uint16_t POSITION = 0x0010;
constexpr uint16_t VELOCITY = 0x0020;
constexpr uint16_t STATUS = 0x0800;
constexpr uint16_t RAW = 0x4000;

std::array<double, 3> array_of(const Vec3 &p_vector) {
	return { double(p_vector.x), double(p_vector.y), double(p_vector.z) };
}

Quat turn_about_up(double p_angle) {
	return { 0.0F, 0.0F, float(std::sin(p_angle / 2.0)), float(std::cos(p_angle / 2.0)) };
}

/// Where a sensor's X axis points to, seen from above, rad.
double heading_of(const Quat &p_orientation) {
	const Vec3 along = p_orientation.rotate({ 1.0F, 0.0F, 0.0F });
	return std::atan2(double(along.y), double(along.x));
}

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

} // namespace

Mounting Mounting::random(Random &r_random, double p_heading) {
	Mounting mounting;
	const auto part = [&r_random]() { return float(r_random.normal()); };
	mounting.rotation = Quat{ part(), part(), part(), part() }.normalized();
	mounting.heading = r_random.between(-p_heading, p_heading);
	return mounting;
}

Reading Tracker::read(const MotionStream &p_stream, double p_time_s, Random &r_random) const {
	const LimbMotion motion = p_stream.at(limb, p_time_s);
	const Quat north = turn_about_up(mounting.heading + mounting.drift * p_time_s);
	Quat sensor = north * motion.orientation * mounting.rotation;
	if (mounting.noise > 0.0) {
		const auto part = [&]() { return float(r_random.normal() * mounting.noise); };
		sensor = sensor * kinematics::exp(Vec3{ part(), part(), part() });
	}
	const Vec3 push = motion.acceleration + Vec3{ 0.0F, 0.0F, float(GRAVITY) };
	const Vec3 field = { 0.5F, 0.0F, -0.85F };
	Reading reading;
	const Quat own = (sensor * _object).inverse();
	reading.orientation = (_world * sensor * _object).normalized();
	reading.acceleration = array_of(own.rotate(north.rotate(push)));
	reading.magnetic = array_of(own.rotate(north.rotate(field)));
	reading.rate = array_of((mounting.rotation * _object).inverse().rotate(motion.rate));
	reading.temperature = 31.5;
	return reading;
}

bool Tracker::reset_orientation(uint16_t p_kind, const Quat &p_now) {
	if (p_kind > uint16_t(Reset::ALIGN)) {
		return false;
	}
	// `p_now` is what the tracker says with the present resets: they are taken out of it first.
	const Quat sensor = _world.inverse() * p_now * _object.inverse();
	const double heading = heading_of(sensor);
	switch (Reset(p_kind)) {
		case Reset::STORE:
			_stored_world = _world;
			_stored_object = _object;
			return true;
		case Reset::HEADING:
			_world = turn_about_up(-heading_of(sensor * _object));
			return true;
		case Reset::GLOBAL:
			_world = (sensor * _object).inverse();
			return true;
		case Reset::OBJECT:
			_object = sensor.inverse() * turn_about_up(heading);
			return true;
		case Reset::ALIGN:
			_object = sensor.inverse() * turn_about_up(heading);
			_world = turn_about_up(-heading);
			return true;
	}
	return false;
}

void Tracker::restart() {
	_world = _stored_world;
	_object = _stored_object;
}

std::size_t Tracker::_write_inertial(const Reading &p_reading, uint8_t *r_bytes) const {
	std::size_t at = 0;
	const std::array<double, 3> *parts[] = { &p_reading.acceleration, &p_reading.rate, &p_reading.magnetic };
	for (unsigned i = 0; i < 3; i++) {
		if ((settings >> (4U + i) & 1U) == 0) {
			at += xbus::write_numbers(number_format(), parts[i]->data(), 3, r_bytes + at);
		}
	}
	return at;
}

std::size_t Tracker::_write_orientation(const Reading &p_reading, uint8_t *r_bytes) const {
	// North-east-down: half a turn about the north.
	const Quat half = (settings >> 31U) != 0 ? Quat{ 1.0F, 0.0F, 0.0F, 0.0F } : Quat{};
	const Quat turn = half * p_reading.orientation;
	switch (settings >> 2U & 3U) {
		case 0: {
			const double values[] = { turn.w, turn.x, turn.y, turn.z };
			return xbus::write_numbers(number_format(), values, 4, r_bytes);
		}
		case 1:
			return xbus::write_numbers(number_format(), euler_of(turn).data(), 3, r_bytes);
		case 2:
			return xbus::write_numbers(number_format(), matrix_of(turn).data(), 9, r_bytes);
		default:
			return 0;
	}
}

std::size_t Tracker::write_data(
		const Reading &p_reading, bool p_is_behind_master, uint16_t p_counter, uint8_t *r_bytes) const {
	std::size_t at = 0;
	const auto zeros = [&](std::size_t p_count) {
		std::memset(r_bytes + at, 0, p_count);
		at += p_count;
	};
	if ((mode & RAW) != 0) {
		zeros(20);
	} else {
		if ((mode & TEMPERATURE) != 0) {
			at += xbus::write_numbers(number_format(), &p_reading.temperature, 1, r_bytes + at);
		}
		at += (mode & CALIBRATED) != 0 ? _write_inertial(p_reading, r_bytes + at) : 0;
		at += (mode & ORIENTATION) != 0 ? _write_orientation(p_reading, r_bytes + at) : 0;
		if ((mode & AUXILIARY) != 0) {
			zeros(((settings & 0x400U) == 0 ? 2 : 0) + ((settings & 0x800U) == 0 ? 2 : 0));
		}
		const std::size_t three = 3 * xbus::number_size(number_format());
		zeros((mode & POSITION) != 0 ? three : 0);
		zeros((mode & VELOCITY) != 0 ? three : 0);
		if ((mode & STATUS) != 0) {
			r_bytes[at++] = 0x03;
		}
	}
	if (!p_is_behind_master && (settings & 1U) != 0) {
		xbus::write_u16(p_counter, r_bytes + at);
		at += 2;
	}
	if (!p_is_behind_master && (settings & 2U) != 0) {
		zeros(12);
	}
	return at;
}

std::size_t Tracker::data_size(bool p_is_behind_master) const {
	std::array<uint8_t, LONGEST> bytes{};
	return write_data({}, p_is_behind_master, 0, bytes.data());
}

} // namespace emulator
