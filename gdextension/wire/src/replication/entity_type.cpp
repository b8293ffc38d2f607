// SPDX-License-Identifier: MIT
#include "replication/entity_type.hpp"

#include <algorithm>
#include <cmath>

namespace wire {

uint32_t Field::quantise(float p_value) const {
	if (!std::isfinite(p_value)) {
		return 0;
	}
	const double steps = std::round((double(p_value) - double(min)) / double(resolution));
	if (kind == FieldKind::ANGLE) {
		const double turned = std::fmod(steps, double(count));
		return uint32_t(turned < 0.0 ? turned + double(count) : turned);
	}
	return uint32_t(std::clamp(steps, 0.0, double(count - 1)));
}

int32_t Field::difference(uint32_t p_from, uint32_t p_to) const {
	const int32_t direct = int32_t(p_to) - int32_t(p_from);
	if (kind != FieldKind::ANGLE) {
		return direct;
	}
	const int32_t whole = int32_t(count);
	if (2 * direct > whole) {
		return direct - whole;
	}
	return 2 * direct <= -whole ? direct + whole : direct;
}

bool Field::add(uint32_t p_from, int32_t p_difference, uint32_t &r_number) const {
	int64_t sum = int64_t(p_from) + p_difference;
	if (kind == FieldKind::ANGLE) {
		sum += sum < 0 ? int64_t(count) : (sum >= int64_t(count) ? -int64_t(count) : 0);
	}
	const bool fits = sum >= 0 && sum < int64_t(count);
	r_number = fits ? uint32_t(sum) : p_from;
	return fits;
}

bool EntityTypes::define(uint8_t p_type, std::size_t p_count, const uint8_t *p_kinds, const float *p_mins,
		const float *p_maxs, const float *p_resolutions) {
	if (p_count > MAX_FIELDS) {
		return false;
	}
	EntityType type;
	type.is_defined = true;
	for (std::size_t i = 0; i < p_count; i++) {
		const double range = double(p_maxs[i]) - double(p_mins[i]);
		const double steps = std::round(range / double(p_resolutions[i]));
		// Written so that NaN fails too.
		const bool is_sound = std::isfinite(p_mins[i]) && p_resolutions[i] > 0.0f && range > 0.0 && steps >= 1.0 &&
				steps <= double(MAX_FIELD_NUMBER) && p_kinds[i] < FIELD_KIND_COUNT;
		if (!is_sound) {
			return false;
		}
		const FieldKind kind = FieldKind(p_kinds[i]);
		// An angle's end is its beginning.
		type.fields.push_back(
				{ kind, p_mins[i], p_resolutions[i], uint32_t(steps) + (kind == FieldKind::ANGLE ? 0 : 1) });
	}
	EntityType &known = _types[p_type];
	if (known.is_defined) {
		// Entities may have it already.
		return known.fields == type.fields;
	}
	known = std::move(type);
	return true;
}

} // namespace wire
