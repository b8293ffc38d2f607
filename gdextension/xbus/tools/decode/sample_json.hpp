// SPDX-License-Identifier: MIT
#pragma once

#include "json.hpp"
#include "sample_fields.hpp"

/// Writes what a sample holds as members of an object; `p_bare`: as values without their keys.
class SampleJson {
public:
	explicit SampleJson(JsonWriter &r_json, bool p_bare = false) : _json(r_json), _is_bare(p_bare) {}

	void numbers(const char *p_key, const double *p_values, std::size_t p_count);
	void integer(const char *p_key, int64_t p_value) {
		_key(p_key);
		_json.value(p_value);
	}
	template <class A>
	void integers(const char *p_key, const A &p_values) {
		_key(p_key);
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
	void _key(const char *p_key) {
		if (!_is_bare) {
			_json.key(p_key);
		}
	}

	JsonWriter &_json;
	bool _is_bare;
};
