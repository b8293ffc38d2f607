// SPDX-License-Identifier: MIT
#include "suit/tracker.hpp"

#include "device/full_mt_data.hpp"

#include <cmath>

namespace emulator {
namespace {

using kinematics::Quat;
using kinematics::Vec3;

std::array<double, 3> array_of(const Vec3 &p_vector) {
	return { double(p_vector.x), double(p_vector.y), double(p_vector.z) };
}

Quat turn_about_up(double p_angle) {
	return { 0.0F, 0.0F, float(std::sin(p_angle / 2.0)), float(std::cos(p_angle / 2.0)) };
}

} // namespace

Mounting Mounting::random(Random &r_random, double p_heading) {
	Mounting mounting;
	const auto part = [&r_random]() { return float(r_random.normal()); };
	mounting.rotation = Quat{ part(), part(), part(), part() }.normalized();
	mounting.heading = r_random.between(-p_heading, p_heading);
	return mounting;
}

Reading Tracker::read(const MotionStream &p_stream, double p_time_s, bool p_runs, Random &r_random) const {
	LimbMotion motion = p_stream.at(limb, p_time_s);
	if (!p_runs) {
		motion.rate = Vec3();
		motion.acceleration = Vec3();
	}
	const Quat north = turn_about_up(mounting.heading + mounting.drift * p_time_s);
	Quat sensor = north * motion.orientation * mounting.rotation;
	if (mounting.noise > 0.0) {
		const auto part = [&]() { return float(r_random.normal() * mounting.noise); };
		sensor = sensor * kinematics::exp(Vec3{ part(), part(), part() });
	}
	const Vec3 push = motion.acceleration + Vec3{ 0.0F, 0.0F, float(GRAVITY) };
	const Vec3 field = { 0.5F, 0.0F, -0.85F };
	Reading reading;
	const Quat own = sensor.inverse();
	reading.orientation = sensor.normalized();
	reading.acceleration = array_of(own.rotate(north.rotate(push)));
	reading.magnetic = array_of(own.rotate(north.rotate(field)));
	reading.rate = array_of(mounting.rotation.inverse().rotate(motion.rate));
	reading.temperature = 31.5;
	return reading;
}

xbus::OutputFormat Tracker::format() const {
	using namespace xbus::output_mode;
	using namespace xbus::output_setting;
	xbus::OutputFormat format = { mode, settings };
	if ((settings & ORIENTATION_MASK) == ORIENTATION_MASK) {
		format.mode &= uint16_t(~ORIENTATION);
	}
	if ((mode & RAW) != 0) {
		format.mode = uint16_t(RAW);
	}
	return format;
}

std::size_t Tracker::write_data(
		const Reading &p_reading, bool p_is_behind_master, uint16_t p_counter, uint8_t *r_bytes) const {
	const bool is_down = (settings & xbus::output_setting::NORTH_EAST_DOWN) != 0;
	const xbus::Axes axes = is_down ? xbus::Axes::NORTH_EAST_DOWN : xbus::Axes::NORTH_WEST_UP;
	return xbus::write_block(format(), sample_of(p_reading, axes, p_counter, 0.0), !p_is_behind_master, r_bytes);
}

std::size_t Tracker::data_size(bool p_is_behind_master) const {
	return p_is_behind_master ? format().size_behind_master() : format().size();
}

} // namespace emulator
