// SPDX-License-Identifier: MIT
#pragma once

#include "device/full_sample.hpp"

/// Passes on those fields, of `xbus::Field` or `xbus::Further`, that a sample holds.
template <class V>
class FieldVisit {
public:
	FieldVisit(const xbus::FullSample &p_sample, V &r_visitor) : _sample(p_sample), _visitor(r_visitor) {}

	template <class F>
	void integer(F p_field, const char *p_key, int64_t p_value) {
		if (_sample.has(p_field)) {
			_visitor.integer(p_key, p_value);
		}
	}
	template <class F>
	void real(F p_field, const char *p_key, const double &p_value) {
		if (_sample.has(p_field)) {
			_visitor.numbers(p_key, &p_value, 1);
		}
	}
	template <class F, class A>
	void reals(F p_field, const char *p_key, const A &p_values) {
		if (_sample.has(p_field)) {
			_visitor.numbers(p_key, p_values.data(), p_values.size());
		}
	}
	template <class F, class A>
	void integers(F p_field, const char *p_key, const A &p_values) {
		if (_sample.has(p_field)) {
			_visitor.integers(p_key, p_values);
		}
	}
	template <class F, class T>
	void structure(F p_field, const char *p_key, const T &p_value) {
		if (_sample.has(p_field)) {
			_visitor.structure(p_key, p_value);
		}
	}

private:
	const xbus::FullSample &_sample;
	V &_visitor;
};

template <class V>
void visit_times(const xbus::FullSample &p, V &r_visitor) {
	FieldVisit<V> fields(p, r_visitor);
	fields.integer(xbus::Field::COUNTER, "counter", p.counter);
	fields.integer(xbus::Field::SAMPLE_TIME_FINE, "sample_time_fine", p.sample_time_fine);
	fields.integer(xbus::Further::SAMPLE_TIME_COARSE, "sample_time_coarse", p.sample_time_coarse);
	fields.integer(xbus::Further::SAMPLE_TIME_64, "sample_time_64", int64_t(p.sample_time_64));
	fields.structure(xbus::Further::UTC_TIME, "utc_time", p.utc);
	fields.integers(xbus::Further::FRAME_RANGE, "frame_range", p.frame_range);
	fields.integer(xbus::Further::ITOW, "itow", p.itow);
	fields.integer(xbus::Further::GNSS_AGE, "gnss_age", p.gnss_age);
	fields.integer(xbus::Further::PRESSURE_AGE, "pressure_age", p.pressure_age);
}

template <class V>
void visit_motion(const xbus::FullSample &p, V &r_visitor) {
	FieldVisit<V> fields(p, r_visitor);
	fields.reals(xbus::Field::QUATERNION, "quaternion", p.quaternion);
	fields.reals(xbus::Field::MATRIX, "rotation_matrix", p.matrix);
	fields.reals(xbus::Field::EULER, "euler_angles", p.euler);
	fields.reals(xbus::Field::ACCELERATION, "acceleration", p.acceleration);
	fields.reals(xbus::Further::FREE_ACCELERATION, "free_acceleration", p.free_acceleration);
	fields.reals(xbus::Further::ACCELERATION_HR, "acceleration_hr", p.acceleration_hr);
	fields.reals(xbus::Further::DELTA_V, "delta_v", p.delta_v);
	fields.reals(xbus::Field::RATE_OF_TURN, "rate_of_turn", p.rate_of_turn);
	fields.reals(xbus::Further::RATE_OF_TURN_HR, "rate_of_turn_hr", p.rate_of_turn_hr);
	fields.reals(xbus::Further::DELTA_Q, "delta_q", p.delta_q);
	fields.reals(xbus::Field::MAGNETIC_FIELD, "magnetic_field", p.magnetic_field);
	fields.reals(xbus::Further::MAGNETIC_FIELD_CORRECTED, "magnetic_field_corrected", p.magnetic_field_corrected);
	fields.real(xbus::Further::TEMPERATURE, "temperature", p.temperature);
	fields.integer(xbus::Further::PRESSURE, "pressure", p.pressure);
}

template <class V>
void visit_position(const xbus::FullSample &p, V &r_visitor) {
	FieldVisit<V> fields(p, r_visitor);
	fields.real(xbus::Further::ALTITUDE_MSL, "altitude_msl", p.altitude_msl);
	fields.real(xbus::Further::ALTITUDE_ELLIPSOID, "altitude_ellipsoid", p.altitude_ellipsoid);
	fields.reals(xbus::Further::POSITION_ECEF, "position_ecef", p.position_ecef);
	fields.reals(xbus::Further::LAT_LON, "lat_lon", p.lat_lon);
	fields.reals(xbus::Further::POSITION, "position", p.position);
	fields.reals(xbus::Further::VELOCITY, "velocity", p.velocity);
}

template <class V>
void visit_rest(const xbus::FullSample &p, V &r_visitor) {
	FieldVisit<V> fields(p, r_visitor);
	fields.integers(xbus::Further::RAW_ACCELERATION, "raw_acceleration", p.raw_acceleration);
	fields.integers(xbus::Further::RAW_RATE_OF_TURN, "raw_rate_of_turn", p.raw_rate_of_turn);
	fields.integers(xbus::Further::RAW_MAGNETIC_FIELD, "raw_magnetic_field", p.raw_magnetic_field);
	fields.integer(xbus::Further::RAW_TEMPERATURE, "raw_temperature", p.raw_temperature);
	fields.integers(xbus::Further::RAW_GYRO_TEMPERATURE, "raw_gyro_temperature", p.raw_gyro_temperature);
	fields.reals(xbus::Further::RAW_DELTA_Q, "raw_delta_q", p.raw_delta_q);
	fields.reals(xbus::Further::RAW_DELTA_V, "raw_delta_v", p.raw_delta_v);
	fields.integer(xbus::Further::ANALOG_IN_1, "analog_in_1", p.analog_in_1);
	fields.integer(xbus::Further::ANALOG_IN_2, "analog_in_2", p.analog_in_2);
	fields.integer(xbus::Further::STATUS_BYTE, "status_byte", p.status_byte);
	fields.integer(xbus::Field::STATUS_WORD, "status_word", p.status_word);
	fields.integer(xbus::Further::RSSI, "rssi", p.rssi);
	fields.integer(xbus::Further::DEVICE_ID, "device_id", p.device_id);
	fields.integer(xbus::Further::LOCATION_ID, "location_id", p.location_id);
	fields.structure(xbus::Further::GNSS_PVT, "gnss_pvt", p.gnss_pvt);
	fields.structure(xbus::Further::GNSS_SATELLITES, "gnss_satellites", p.gnss_satellites);
	fields.integer(xbus::Further::GNSS_PULSE, "gnss_pulse", p.gnss_pulse);
	fields.structure(xbus::Further::GPS_PVT, "gps_pvt", p.gps_pvt);
	fields.structure(xbus::Further::TRIGGER_1, "trigger_1", p.triggers[0]);
	fields.structure(xbus::Further::TRIGGER_2, "trigger_2", p.triggers[1]);
	fields.structure(xbus::Further::TRIGGER_3, "trigger_3", p.triggers[2]);
	fields.structure(xbus::Further::SNAPSHOT, "snapshot", p.snapshot);
}

/// Gives a visitor all that a sample holds: `numbers(key, values, count)` for real numbers,
/// `integer(key, value)`, `integers(key, values)`, and `structure(key, value)`. The keys are documented in
/// docs/xbus.md.
template <class V>
void visit_sample(const xbus::FullSample &p_sample, V &r_visitor) {
	visit_times(p_sample, r_visitor);
	visit_motion(p_sample, r_visitor);
	visit_position(p_sample, r_visitor);
	visit_rest(p_sample, r_visitor);
}
