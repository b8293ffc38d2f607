// SPDX-License-Identifier: MIT
#include "motion_cueing.hpp"

#include "triple.hpp"

#include <godot_cpp/core/error_macros.hpp>

#include <initializer_list>

namespace godot {

namespace {

/// The slowest third pole that leaves 1 mm after 30 s, rad/s.
constexpr double SLOWEST_THIRD_POLE = 0.2;
constexpr double SLOWEST = 0.01;
/// The fastest that steps of 5 ms are exact for, rad/s.
constexpr double FASTEST = 50.0;
constexpr double MAX_STEP_S = 10.0;

/// Written so that NaN is no number of a range either.
bool is_within(double p_value, double p_lowest, double p_highest) {
	return p_value >= p_lowest && p_value <= p_highest;
}

bool are_limits(const Vector3 &p_vector) {
	bool all = true;
	for (int axis = 0; axis < 3; axis++) {
		all = all && is_within(p_vector[axis], 0.0, 1000.0);
	}
	return all;
}

std::array<cueing::AxisLimits, 3> to_limits(
		const Vector3 &p_travel, const Vector3 &p_speed, const Vector3 &p_acceleration) {
	std::array<cueing::AxisLimits, 3> limits{};
	for (int axis = 0; axis < 3; axis++) {
		limits[axis] = { p_travel[axis], p_speed[axis], p_acceleration[axis] };
	}
	return limits;
}

} // namespace

void MotionCueing::set_translation_limits(
		const Vector3 &p_travel, const Vector3 &p_speed, const Vector3 &p_acceleration) {
	ERR_FAIL_COND_MSG(!are_limits(p_travel) || !are_limits(p_speed) || !are_limits(p_acceleration),
			"A platform's travel, speed and acceleration are 0 to 1000 m, m/s and m/s^2.");
	_travel = to_limits(p_travel, p_speed, p_acceleration);
	_core.set_limits(_travel, _attitude);
}

void MotionCueing::set_rotation_limits(const Vector3 &p_angle, const Vector3 &p_rate, const Vector3 &p_acceleration) {
	ERR_FAIL_COND_MSG(!are_limits(p_angle) || !are_limits(p_rate) || !are_limits(p_acceleration),
			"A platform's angles, rates and angular accelerations are 0 to 1000 rad, rad/s and rad/s^2.");
	_attitude = to_limits(p_angle, p_rate, p_acceleration);
	_core.set_limits(_travel, _attitude);
}

void MotionCueing::set_translation(Direction p_direction, double p_scale, double p_limit, double p_frequency,
		double p_damping, double p_third_pole) {
	ERR_FAIL_COND_MSG(!is_within(p_scale, 0.0, 2.0), "The scale of specific force is 0 to 2.");
	ERR_FAIL_COND_MSG(!is_within(p_limit, 0.0, 1000.0), "The limit of specific force is 0 to 1000 m/s^2.");
	ERR_FAIL_COND_MSG(!is_within(p_frequency, 0.2, FASTEST), "The high-pass has a frequency of 0.2 to 50 rad/s.");
	ERR_FAIL_COND_MSG(!is_within(p_damping, 0.3, 3.0), "The high-pass has a damping ratio of 0.3 to 3.");
	ERR_FAIL_COND_MSG(!is_within(p_third_pole, SLOWEST_THIRD_POLE, FASTEST),
			"The third pole is at 0.2 to 50 rad/s: slower ones are not back within 30 s.");
	cueing::WashoutParameters &all = _core.washout.parameters;
	(p_direction == DIRECTION_VERTICAL ? all.vertical : all.horizontal) = { p_scale, p_limit, p_frequency, p_damping,
		p_third_pole };
}

void MotionCueing::set_tilt(double p_frequency, double p_damping, double p_max_rate, double p_max_angle) {
	ERR_FAIL_COND_MSG(!is_within(p_frequency, 0.2, FASTEST), "The low-pass has a frequency of 0.2 to 50 rad/s.");
	ERR_FAIL_COND_MSG(!is_within(p_damping, 0.3, 3.0), "The low-pass has a damping ratio of 0.3 to 3.");
	ERR_FAIL_COND_MSG(!is_within(p_max_rate, 0.0, 1.0), "Tilt has a rate of 0 to 1 rad/s.");
	ERR_FAIL_COND_MSG(!is_within(p_max_angle, 0.0, 1.0), "Tilt has an angle of 0 to 1 rad.");
	_core.washout.parameters.tilt = { p_frequency, p_damping, p_max_rate, p_max_angle };
}

void MotionCueing::set_rotation(double p_scale, double p_limit, double p_frequency, double p_damping, int64_t p_order) {
	ERR_FAIL_COND_MSG(!is_within(p_scale, 0.0, 2.0), "The scale of rates is 0 to 2.");
	ERR_FAIL_COND_MSG(!is_within(p_limit, 0.0, 100.0), "The limit of rates is 0 to 100 rad/s.");
	ERR_FAIL_COND_MSG(!is_within(p_frequency, 0.2, FASTEST), "The high-pass has a frequency of 0.2 to 50 rad/s.");
	ERR_FAIL_COND_MSG(!is_within(p_damping, 0.3, 3.0), "The high-pass has a damping ratio of 0.3 to 3.");
	ERR_FAIL_COND_MSG(p_order != 1 && p_order != 2, "The high-pass of rotation has order 1 or 2.");
	_core.washout.parameters.rotation = { p_scale, p_limit, p_frequency, p_damping, int(p_order) };
}

void MotionCueing::set_ramps(double p_dead_man, double p_leave, double p_enter, double p_teleport) {
	for (const double time : { p_dead_man, p_leave, p_enter, p_teleport }) {
		ERR_FAIL_COND_MSG(!is_within(time, SLOWEST, 60.0), "A ramp lasts 0.01 to 60 s.");
	}
	_core.ramps = { p_dead_man, p_leave, p_enter, p_teleport };
}

void MotionCueing::step(const Vector3 &p_specific_force, const Vector3 &p_rates, double p_seconds) {
	ERR_FAIL_COND_MSG(!is_within(p_seconds, 0.0, MAX_STEP_S), "A step lasts 0 to 10 s.");
	const cueing::Motion motion = { to_triple(p_specific_force), to_triple(p_rates) };
	_core.step(&motion, p_seconds);
}

void MotionCueing::step_without_news(double p_seconds) {
	ERR_FAIL_COND_MSG(!is_within(p_seconds, 0.0, MAX_STEP_S), "A step lasts 0 to 10 s.");
	_core.step(nullptr, p_seconds);
}

Vector3 MotionCueing::get_position() const {
	return from_triple(_core.pose().position);
}

Vector3 MotionCueing::get_attitude() const {
	return from_triple(_core.pose().attitude);
}

Vector3 MotionCueing::get_filtered_position() const {
	return from_triple(_core.washout.pose().position);
}

Vector3 MotionCueing::get_filtered_velocity() const {
	return from_triple(_core.washout.velocity());
}

Vector3 MotionCueing::get_filtered_acceleration() const {
	return from_triple(_core.washout.acceleration());
}

Vector3 MotionCueing::get_filtered_attitude() const {
	return from_triple(_core.washout.pose().attitude);
}

Vector3 MotionCueing::get_tilt() const {
	return from_triple(_core.washout.tilt());
}

void MotionCueing::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_translation_limits", "travel", "speed", "acceleration"),
			&MotionCueing::set_translation_limits);
	ClassDB::bind_method(
			D_METHOD("set_rotation_limits", "angle", "rate", "acceleration"), &MotionCueing::set_rotation_limits);
	ClassDB::bind_method(
			D_METHOD("set_translation", "direction", "scale", "limit", "frequency", "damping", "third_pole"),
			&MotionCueing::set_translation);
	ClassDB::bind_method(
			D_METHOD("set_tilt", "frequency", "damping", "max_rate", "max_angle"), &MotionCueing::set_tilt);
	ClassDB::bind_method(
			D_METHOD("set_rotation", "scale", "limit", "frequency", "damping", "order"), &MotionCueing::set_rotation);
	ClassDB::bind_method(D_METHOD("set_ramps", "dead_man", "leave", "enter", "teleport"), &MotionCueing::set_ramps);
	ClassDB::bind_method(D_METHOD("reset"), &MotionCueing::reset);
	ClassDB::bind_method(D_METHOD("set_paused", "paused"), &MotionCueing::set_paused);
	ClassDB::bind_method(D_METHOD("teleport"), &MotionCueing::teleport);
	ClassDB::bind_method(D_METHOD("step", "specific_force", "rates", "seconds"), &MotionCueing::step);
	ClassDB::bind_method(D_METHOD("step_without_news", "seconds"), &MotionCueing::step_without_news);
	ClassDB::bind_method(D_METHOD("get_position"), &MotionCueing::get_position);
	ClassDB::bind_method(D_METHOD("get_attitude"), &MotionCueing::get_attitude);
	ClassDB::bind_method(D_METHOD("get_filtered_position"), &MotionCueing::get_filtered_position);
	ClassDB::bind_method(D_METHOD("get_filtered_velocity"), &MotionCueing::get_filtered_velocity);
	ClassDB::bind_method(D_METHOD("get_filtered_acceleration"), &MotionCueing::get_filtered_acceleration);
	ClassDB::bind_method(D_METHOD("get_filtered_attitude"), &MotionCueing::get_filtered_attitude);
	ClassDB::bind_method(D_METHOD("get_tilt"), &MotionCueing::get_tilt);
	ClassDB::bind_method(D_METHOD("get_gain"), &MotionCueing::get_gain);
	BIND_ENUM_CONSTANT(DIRECTION_HORIZONTAL);
	BIND_ENUM_CONSTANT(DIRECTION_VERTICAL);
}

} // namespace godot
