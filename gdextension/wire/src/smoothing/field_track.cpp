// SPDX-License-Identifier: MIT
#include "smoothing/field_track.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace wire {

FieldTrack::FieldTrack(const EntityType &p_type, const uint32_t *p_spawn) :
		_type(p_type), _values(p_type.fields.size() * KEPT) {
	_keys[0].time = std::numeric_limits<double>::lowest();
	std::copy_n(p_spawn, field_count(), _values.begin());
}

bool FieldTrack::push(double p_time, const uint32_t *p_values, double p_interval) {
	std::size_t index = _size;
	while (index > 0 && _keys[index - 1].time > p_time) {
		index--;
	}
	if (index == 0 || _keys[index - 1].time == p_time) {
		return false;
	}
	std::size_t slot = _size;
	if (_size == KEPT) {
		slot = _keys[0].slot;
		std::copy(_keys.begin() + 1, _keys.begin() + std::ptrdiff_t(index), _keys.begin());
		index--;
	} else {
		std::copy_backward(_keys.begin() + std::ptrdiff_t(index), _keys.begin() + std::ptrdiff_t(_size),
				_keys.begin() + std::ptrdiff_t(_size) + 1);
		_size++;
	}
	_keys[index] = { p_time, p_interval, slot };
	std::copy_n(p_values, field_count(), _values.begin() + std::ptrdiff_t(slot * field_count()));
	return true;
}

float FieldTrack::at(std::size_t p_field, double p_time) const {
	const Field &field = _type.fields[p_field];
	std::size_t after = _size;
	while (after > 0 && _keys[after - 1].time > p_time) {
		after--;
	}
	if (after == 0) {
		return field.restore(_value(_keys[0], p_field));
	}
	const Key &from = _keys[after - 1];
	if (after == _size || field.kind == FieldKind::STEP) {
		return field.restore(_value(from, p_field));
	}
	const Key &to = _keys[after];
	const bool rested = to.time - from.time > MAX_GAPS * to.interval;
	const double begin = rested ? to.time - to.interval : from.time;
	const double part = std::clamp((p_time - begin) / std::max(to.time - begin, 1e-9), 0.0, 1.0);
	const double steps = part * field.difference(_value(from, p_field), _value(to, p_field));
	double number = double(_value(from, p_field)) + steps;
	if (field.kind == FieldKind::ANGLE) {
		number -= std::floor(number / field.count) * field.count;
	}
	return float(double(field.min) + double(field.resolution) * number);
}

float FieldTrack::newest(std::size_t p_field) const {
	return _type.fields[p_field].restore(_value(_keys[_size - 1], p_field));
}

} // namespace wire
