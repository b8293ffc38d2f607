// SPDX-License-Identifier: MIT
#include "sample_json.hpp"

using namespace xbus;

void SampleJson::numbers(const char *p_key, const double *p_values, size_t p_count) {
	_json.key(p_key);
	if (p_count == 1) {
		_json.value(*p_values);
		return;
	}
	_json.begin_list();
	for (size_t i = 0; i < p_count; i++) {
		_json.value(p_values[i]);
	}
	_json.end_list();
}

void SampleJson::_date(const UtcTime &p_utc) {
	integer("year", p_utc.year);
	integer("month", p_utc.month);
	integer("day", p_utc.day);
	integer("hour", p_utc.hour);
	integer("minute", p_utc.minute);
	integer("second", p_utc.second);
	integer("validity", p_utc.validity);
}

void SampleJson::structure(const char *p_key, const UtcTime &p_utc) {
	_json.key(p_key);
	_json.begin_object();
	_date(p_utc);
	integer("nanoseconds", p_utc.nanoseconds);
	_json.end_object();
}

void SampleJson::structure(const char *p_key, const GnssPvt &p_pvt) {
	_json.key(p_key);
	_json.begin_object();
	integer("itow", p_pvt.itow);
	_date(p_pvt.utc);
	integer("time_accuracy", p_pvt.time_accuracy);
	integer("nanoseconds", p_pvt.nanoseconds);
	integer("fix_type", p_pvt.fix_type);
	integer("flags", p_pvt.flags);
	integer("satellites", p_pvt.satellites);
	integer("reserved", p_pvt.reserved);
	integer("longitude", p_pvt.longitude);
	integer("latitude", p_pvt.latitude);
	integer("height", p_pvt.height);
	integer("height_msl", p_pvt.height_msl);
	integer("horizontal_accuracy", p_pvt.horizontal_accuracy);
	integer("vertical_accuracy", p_pvt.vertical_accuracy);
	integer("velocity_north", p_pvt.velocity_north);
	integer("velocity_east", p_pvt.velocity_east);
	integer("velocity_down", p_pvt.velocity_down);
	integer("ground_speed", p_pvt.ground_speed);
	integer("heading_of_motion", p_pvt.heading_of_motion);
	integer("speed_accuracy", p_pvt.speed_accuracy);
	integer("heading_accuracy", p_pvt.heading_accuracy);
	integer("heading_of_vehicle", p_pvt.heading_of_vehicle);
	static constexpr const char *DILUTIONS[] = { "gdop", "pdop", "tdop", "vdop", "hdop", "ndop", "edop" };
	for (size_t i = 0; i < p_pvt.dilutions.size(); i++) {
		integer(DILUTIONS[i], p_pvt.dilutions[i]);
	}
	_json.end_object();
}

void SampleJson::structure(const char *p_key, const GnssSatellites &p_satellites) {
	_json.key(p_key);
	_json.begin_object();
	integer("itow", p_satellites.itow);
	_json.key("satellites");
	_json.begin_list();
	for (size_t i = 0; i < p_satellites.count; i++) {
		const Satellite &satellite = p_satellites.satellites[i];
		_json.begin_object();
		integer("system", satellite.system);
		integer("number", satellite.number);
		integer("signal", satellite.signal);
		integer("flags", satellite.flags);
		_json.end_object();
	}
	_json.end_list();
	_json.end_object();
}

void SampleJson::structure(const char *p_key, const GpsPvt &p_pvt) {
	_json.key(p_key);
	_json.begin_object();
	integer("pressure", p_pvt.pressure);
	integer("pressure_age", p_pvt.pressure_age);
	integer("itow", p_pvt.itow);
	integer("latitude", p_pvt.latitude);
	integer("longitude", p_pvt.longitude);
	integer("height", p_pvt.height);
	integer("velocity_north", p_pvt.velocity_north);
	integer("velocity_east", p_pvt.velocity_east);
	integer("velocity_down", p_pvt.velocity_down);
	integer("horizontal_accuracy", p_pvt.horizontal_accuracy);
	integer("vertical_accuracy", p_pvt.vertical_accuracy);
	integer("speed_accuracy", p_pvt.speed_accuracy);
	integer("age", p_pvt.age);
	_json.end_object();
}

void SampleJson::structure(const char *p_key, const Trigger &p_trigger) {
	_json.key(p_key);
	_json.begin_object();
	integer("line", p_trigger.line);
	integer("polarity", p_trigger.polarity);
	integer("time", p_trigger.time);
	integer("frame", p_trigger.frame);
	_json.end_object();
}

void SampleJson::structure(const char *p_key, const Snapshot &p_snapshot) {
	_json.key(p_key);
	_json.begin_object();
	_json.member("full", p_snapshot.is_full);
	_json.member("retransmission", p_snapshot.is_retransmission);
	integer("device_id", p_snapshot.device_id);
	integer("frame", p_snapshot.frame);
	integer("time", int64_t(p_snapshot.time));
	integers("delta_q", p_snapshot.delta_q);
	integers("delta_v", p_snapshot.delta_v);
	integers("magnetic_field", p_snapshot.magnetic_field);
	integer("pressure", p_snapshot.pressure);
	integer("status", p_snapshot.status);
	integer("acceleration_clips", p_snapshot.acceleration_clips);
	integer("rate_clips", p_snapshot.rate_clips);
	_json.end_object();
}
