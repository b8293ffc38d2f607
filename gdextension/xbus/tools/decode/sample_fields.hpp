// SPDX-License-Identifier: MIT
#pragma once

#include "bus/sample.hpp"

/// Tells a visitor all that a sample holds: `numbers(key, values, count)` for real numbers,
/// `integer(key, value)`, `integers(key, values)`, and structures by themselves. The keys are documented in
/// docs/xbus.md.
template <class V>
void visit_sample(const xbus::Sample &p, V &r_visitor) {
	using F = xbus::Field;
	const auto integer = [&](F p_field, const char *p_key, int64_t p_value) {
		if (p.has(p_field)) {
			r_visitor.integer(p_key, p_value);
		}
	};
	const auto real = [&](F p_field, const char *p_key, const double &p_value) {
		if (p.has(p_field)) {
			r_visitor.numbers(p_key, &p_value, 1);
		}
	};
	const auto reals = [&](F p_field, const char *p_key, const auto &p_values) {
		if (p.has(p_field)) {
			r_visitor.numbers(p_key, p_values.data(), p_values.size());
		}
	};
	const auto integers = [&](F p_field, const char *p_key, const auto &p_values) {
		if (p.has(p_field)) {
			r_visitor.integers(p_key, p_values);
		}
	};
	const auto structure = [&](F p_field, const char *p_key, const auto &p_value) {
		if (p.has(p_field)) {
			r_visitor.structure(p_key, p_value);
		}
	};
	integer(F::COUNTER, "counter", p.counter);
	integer(F::SAMPLE_TIME_FINE, "sample_time_fine", p.sample_time_fine);
	integer(F::SAMPLE_TIME_COARSE, "sample_time_coarse", p.sample_time_coarse);
	integer(F::SAMPLE_TIME_64, "sample_time_64", int64_t(p.sample_time_64));
	structure(F::UTC_TIME, "utc_time", p.utc);
	integers(F::FRAME_RANGE, "frame_range", p.frame_range);
	integer(F::ITOW, "itow", p.itow);
	integer(F::GNSS_AGE, "gnss_age", p.gnss_age);
	integer(F::PRESSURE_AGE, "pressure_age", p.pressure_age);
	reals(F::QUATERNION, "quaternion", p.quaternion);
	reals(F::MATRIX, "rotation_matrix", p.matrix);
	reals(F::EULER, "euler_angles", p.euler);
	reals(F::ACCELERATION, "acceleration", p.acceleration);
	reals(F::FREE_ACCELERATION, "free_acceleration", p.free_acceleration);
	reals(F::ACCELERATION_HR, "acceleration_hr", p.acceleration_hr);
	reals(F::DELTA_V, "delta_v", p.delta_v);
	reals(F::RATE_OF_TURN, "rate_of_turn", p.rate_of_turn);
	reals(F::RATE_OF_TURN_HR, "rate_of_turn_hr", p.rate_of_turn_hr);
	reals(F::DELTA_Q, "delta_q", p.delta_q);
	reals(F::MAGNETIC_FIELD, "magnetic_field", p.magnetic_field);
	reals(F::MAGNETIC_FIELD_CORRECTED, "magnetic_field_corrected", p.magnetic_field_corrected);
	real(F::TEMPERATURE, "temperature", p.temperature);
	integer(F::PRESSURE, "pressure", p.pressure);
	real(F::ALTITUDE_MSL, "altitude_msl", p.altitude_msl);
	real(F::ALTITUDE_ELLIPSOID, "altitude_ellipsoid", p.altitude_ellipsoid);
	reals(F::POSITION_ECEF, "position_ecef", p.position_ecef);
	reals(F::LAT_LON, "lat_lon", p.lat_lon);
	reals(F::POSITION, "position", p.position);
	reals(F::VELOCITY, "velocity", p.velocity);
	integers(F::RAW_ACCELERATION, "raw_acceleration", p.raw_acceleration);
	integers(F::RAW_RATE_OF_TURN, "raw_rate_of_turn", p.raw_rate_of_turn);
	integers(F::RAW_MAGNETIC_FIELD, "raw_magnetic_field", p.raw_magnetic_field);
	integer(F::RAW_TEMPERATURE, "raw_temperature", p.raw_temperature);
	integers(F::RAW_GYRO_TEMPERATURE, "raw_gyro_temperature", p.raw_gyro_temperature);
	reals(F::RAW_DELTA_Q, "raw_delta_q", p.raw_delta_q);
	reals(F::RAW_DELTA_V, "raw_delta_v", p.raw_delta_v);
	integer(F::ANALOG_IN_1, "analog_in_1", p.analog_in_1);
	integer(F::ANALOG_IN_2, "analog_in_2", p.analog_in_2);
	integer(F::STATUS_BYTE, "status_byte", p.status_byte);
	integer(F::STATUS_WORD, "status_word", p.status_word);
	integer(F::RSSI, "rssi", p.rssi);
	integer(F::DEVICE_ID, "device_id", p.device_id);
	integer(F::LOCATION_ID, "location_id", p.location_id);
	structure(F::GNSS_PVT, "gnss_pvt", p.gnss_pvt);
	structure(F::GNSS_SATELLITES, "gnss_satellites", p.gnss_satellites);
	integer(F::GNSS_PULSE, "gnss_pulse", p.gnss_pulse);
	structure(F::GPS_PVT, "gps_pvt", p.gps_pvt);
	structure(F::TRIGGER_1, "trigger_1", p.triggers[0]);
	structure(F::TRIGGER_2, "trigger_2", p.triggers[1]);
	structure(F::TRIGGER_3, "trigger_3", p.triggers[2]);
	structure(F::SNAPSHOT, "snapshot", p.snapshot);
}
