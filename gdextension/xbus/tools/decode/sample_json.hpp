// SPDX-License-Identifier: MIT
#pragma once

#include "json.hpp"
#include "sample_fields.hpp"

/// Writes what a sample holds as members of an object.
class SampleJson {
public:
	explicit SampleJson(JsonWriter &r_json) : _json(r_json) {}

	void numbers(const char *p_key, const double *p_values, size_t p_count);
	void integer(const char *p_key, int64_t p_value) { _json.member(p_key, p_value); }
	template <class A>
	void integers(const char *p_key, const A &p_values) {
		_json.key(p_key);
		_json.begin_list();
		for (const auto value : p_values) {
			_json.value(int64_t(value));
		}
		_json.end_list();
	}
	void structure(const char *p_key, const xbus::UtcTime &p_utc);
	void structure(const char *p_key, const xbus::GnssPvt &p_pvt);
	void structure(const char *p_key, const xbus::GnssSatellites &p_satellites);
	void structure(const char *p_key, const xbus::GpsPvt &p_pvt);
	void structure(const char *p_key, const xbus::Trigger &p_trigger);
	void structure(const char *p_key, const xbus::Snapshot &p_snapshot);

private:
	void _date(const xbus::UtcTime &p_utc);

	JsonWriter &_json;
};
