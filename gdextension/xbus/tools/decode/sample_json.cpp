// SPDX-License-Identifier: MIT
#include "sample_json.hpp"

using namespace xbus;

namespace {

void write_date(const UtcTime &p_utc, SampleJson &r_members) {
	r_members.integer("year", p_utc.year);
	r_members.integer("month", p_utc.month);
	r_members.integer("day", p_utc.day);
	r_members.integer("hour", p_utc.hour);
	r_members.integer("minute", p_utc.minute);
	r_members.integer("second", p_utc.second);
	r_members.integer("validity", p_utc.validity);
}

} // namespace

void SampleJson::numbers(const char *p_key, const double *p_values, std::size_t p_count) {
	_key(p_key);
	if (p_count == 1) {
		_json.value(*p_values);
		return;
	}
	_json.begin_list();
	for (std::size_t i = 0; i < p_count; i++) {
		_json.value(p_values[i]);
	}
	_json.end_list();
}

void SampleJson::structure(const char *p_key, const UtcTime &p_utc) {
	_key(p_key);
	_json.begin_object();
	SampleJson members(_json);
	write_date(p_utc, members);
	members.integer("nanoseconds", p_utc.nanoseconds);
	_json.end_object();
}

void SampleJson::structure(const char *p_key, const GnssPvt &p_pvt) {
	_key(p_key);
	_json.begin_object();
	SampleJson members(_json);
	members.integer("itow", p_pvt.itow);
	write_date(p_pvt.utc, members);
	members.integer("time_accuracy", p_pvt.time_accuracy);
	members.integer("nanoseconds", p_pvt.nanoseconds);
	members.integer("fix_type", p_pvt.fix_type);
	members.integer("flags", p_pvt.flags);
	members.integer("satellites", p_pvt.satellites);
	members.integer("reserved", p_pvt.reserved);
	members.integer("longitude", p_pvt.longitude);
	members.integer("latitude", p_pvt.latitude);
	members.integer("height", p_pvt.height);
	members.integer("height_msl", p_pvt.height_msl);
	members.integer("horizontal_accuracy", p_pvt.horizontal_accuracy);
	members.integer("vertical_accuracy", p_pvt.vertical_accuracy);
	members.integer("velocity_north", p_pvt.velocity_north);
	members.integer("velocity_east", p_pvt.velocity_east);
	members.integer("velocity_down", p_pvt.velocity_down);
	members.integer("ground_speed", p_pvt.ground_speed);
	members.integer("heading_of_motion", p_pvt.heading_of_motion);
	members.integer("speed_accuracy", p_pvt.speed_accuracy);
	members.integer("heading_accuracy", p_pvt.heading_accuracy);
	members.integer("heading_of_vehicle", p_pvt.heading_of_vehicle);
	static constexpr const char *DILUTIONS[] = { "gdop", "pdop", "tdop", "vdop", "hdop", "ndop", "edop" };
	for (std::size_t i = 0; i < p_pvt.dilutions.size(); i++) {
		members.integer(DILUTIONS[i], p_pvt.dilutions[i]);
	}
	_json.end_object();
}

void SampleJson::structure(const char *p_key, const GnssSatellites &p_satellites) {
	_key(p_key);
	_json.begin_object();
	SampleJson members(_json);
	members.integer("itow", p_satellites.itow);
	_json.key("satellites");
	_json.begin_list();
	for (std::size_t i = 0; i < p_satellites.count; i++) {
		const Satellite &satellite = p_satellites.satellites[i];
		_json.begin_object();
		members.integer("system", satellite.system);
		members.integer("number", satellite.number);
		members.integer("signal", satellite.signal);
		members.integer("flags", satellite.flags);
		_json.end_object();
	}
	_json.end_list();
	_json.end_object();
}

void SampleJson::structure(const char *p_key, const GpsPvt &p_pvt) {
	_key(p_key);
	_json.begin_object();
	SampleJson members(_json);
	members.integer("pressure", p_pvt.pressure);
	members.integer("pressure_age", p_pvt.pressure_age);
	members.integer("itow", p_pvt.itow);
	members.integer("latitude", p_pvt.latitude);
	members.integer("longitude", p_pvt.longitude);
	members.integer("height", p_pvt.height);
	members.integer("velocity_north", p_pvt.velocity_north);
	members.integer("velocity_east", p_pvt.velocity_east);
	members.integer("velocity_down", p_pvt.velocity_down);
	members.integer("horizontal_accuracy", p_pvt.horizontal_accuracy);
	members.integer("vertical_accuracy", p_pvt.vertical_accuracy);
	members.integer("speed_accuracy", p_pvt.speed_accuracy);
	members.integer("age", p_pvt.age);
	_json.end_object();
}

void SampleJson::structure(const char *p_key, const Trigger &p_trigger) {
	_key(p_key);
	_json.begin_object();
	SampleJson members(_json);
	members.integer("line", p_trigger.line);
	members.integer("polarity", p_trigger.polarity);
	members.integer("time", p_trigger.time);
	members.integer("frame", p_trigger.frame);
	_json.end_object();
}

void SampleJson::structure(const char *p_key, const Snapshot &p_snapshot) {
	_key(p_key);
	_json.begin_object();
	SampleJson members(_json);
	_json.member("full", p_snapshot.is_full);
	_json.member("retransmission", p_snapshot.is_retransmission);
	members.integer("device_id", p_snapshot.device_id);
	members.integer("frame", p_snapshot.frame);
	members.integer("time", int64_t(p_snapshot.time));
	members.integers("delta_q", p_snapshot.delta_q);
	members.integers("delta_v", p_snapshot.delta_v);
	members.integers("magnetic_field", p_snapshot.magnetic_field);
	members.integer("pressure", p_snapshot.pressure);
	members.integer("status", p_snapshot.status);
	members.integer("acceleration_clips", p_snapshot.acceleration_clips);
	members.integer("rate_clips", p_snapshot.rate_clips);
	_json.end_object();
}
