// SPDX-License-Identifier: MIT
#pragma once

#include "replication/entity_type.hpp"

#include <array>
#include <vector>

namespace wire {

/// What is known of an entity's fields, at the moment that is shown: LINEAR and ANGLE fields move evenly from one
/// update to the next (angles by the short way round), STEP fields have a value until the next. Beyond the newest
/// update all stay.
///
/// Times are the server's, s. Nothing here allocates but the constructor, and nothing costs time until it is read.
class FieldTrack {
public:
	/// Updates that are kept.
	static constexpr std::size_t KEPT = 16;
	/// Fields are sent only when they change. Where the last update is longer ago than so many times the usual time
	/// between two, they did not move until just before the new one.
	static constexpr double MAX_GAPS = 4.0;

	/// The values count from the beginning of time.
	FieldTrack(const EntityType &p_type, const uint32_t *p_spawn);

	/// Takes an update, and how long the time between two usually is; whether it says anything new.
	bool push(double p_time, const uint32_t *p_values, double p_interval);
	/// The value of a field (there has to be one of this index) at a time.
	float at(std::size_t p_field, double p_time) const;
	/// As it was received last.
	float newest(std::size_t p_field) const;
	std::size_t field_count() const { return _type.fields.size(); }

private:
	struct Key {
		double time = 0.0;
		double interval = 0.0;
		std::size_t slot = 0; // Of its values.
	};

	uint32_t _value(const Key &p_key, std::size_t p_field) const {
		return _values[p_key.slot * field_count() + p_field];
	}

	EntityType _type;
	std::array<Key, KEPT> _keys{}; // By time.
	std::size_t _size = 1;
	std::vector<uint32_t> _values;
};

} // namespace wire
