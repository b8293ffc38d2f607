// SPDX-License-Identifier: MIT
#include "bus/mt_data.hpp"

#include "bus/item_structs.hpp"

namespace xbus {

namespace {

using namespace output_mode;
using namespace output_setting;

constexpr uint32_t KNOWN_MODES =
		TEMPERATURE | CALIBRATED | ORIENTATION | AUXILIARY | POSITION | VELOCITY | STATUS | GPS_PVT | RAW;

/// The order of a block's parts, written once: `r_archive` measures, reads or writes them.
template <class A>
void go_through(const OutputFormat &p_format, bool p_with_time, A &r_archive) {
	const auto on = [&](uint32_t p_bit) { return (p_format.mode & p_bit) != 0; };
	const auto kept = [&](uint32_t p_bit) { return (p_format.settings & p_bit) == 0; };
	if (on(RAW)) {
		r_archive.raw();
	}
	if (on(GPS_PVT)) {
		r_archive.gps_pvt();
	}
	if (on(TEMPERATURE)) {
		r_archive.numbers(Field::TEMPERATURE);
	}
	if (on(CALIBRATED) && kept(NO_ACCELERATION)) {
		r_archive.numbers(Field::ACCELERATION);
	}
	if (on(CALIBRATED) && kept(NO_RATE_OF_TURN)) {
		r_archive.numbers(Field::RATE_OF_TURN);
	}
	if (on(CALIBRATED) && kept(NO_MAGNETIC_FIELD)) {
		r_archive.numbers(Field::MAGNETIC_FIELD);
	}
	if (on(ORIENTATION)) {
		const uint32_t form = p_format.settings & ORIENTATION_MASK;
		r_archive.numbers(form == EULER ? Field::EULER : (form == MATRIX ? Field::MATRIX : Field::QUATERNION));
	}
	if (on(AUXILIARY) && kept(NO_ANALOG_1)) {
		r_archive.u16(Field::ANALOG_IN_1);
	}
	if (on(AUXILIARY) && kept(NO_ANALOG_2)) {
		r_archive.u16(Field::ANALOG_IN_2);
	}
	if (on(POSITION)) {
		r_archive.numbers(Field::POSITION);
	}
	if (on(VELOCITY)) {
		r_archive.numbers(Field::VELOCITY);
	}
	if (on(STATUS)) {
		r_archive.status();
	}
	if (p_with_time && !kept(SAMPLE_COUNTER)) {
		r_archive.u16(Field::COUNTER);
	}
	if (p_with_time && !kept(UTC)) {
		r_archive.utc();
	}
}

/// The numbers of a field.
struct Numbers {
	std::size_t count;
	double *values;
};

Numbers numbers_of(Field p_field, Sample &r_sample) {
	switch (p_field) {
		case Field::TEMPERATURE:
			return { 1, &r_sample.temperature };
		case Field::ACCELERATION:
			return { 3, r_sample.acceleration.data() };
		case Field::RATE_OF_TURN:
			return { 3, r_sample.rate_of_turn.data() };
		case Field::MAGNETIC_FIELD:
			return { 3, r_sample.magnetic_field.data() };
		case Field::QUATERNION:
			return { 4, r_sample.quaternion.data() };
		case Field::EULER:
			return { 3, r_sample.euler.data() };
		case Field::MATRIX:
			return { 9, r_sample.matrix.data() };
		case Field::POSITION:
			return { 3, r_sample.position.data() };
		default:
			return { 3, r_sample.velocity.data() };
	}
}

class Measurer {
public:
	explicit Measurer(NumberFormat p_format) : _number(number_size(p_format)) {}

	void raw() { size += 20; }
	void gps_pvt() { size += GPS_PVT_SIZE; }
	void numbers(Field p_field) {
		size += _number *
				(p_field == Field::TEMPERATURE				   ? 1
								: p_field == Field::QUATERNION ? 4
								: p_field == Field::MATRIX	   ? 9
															   : 3);
	}
	void u16(Field) { size += 2; }
	void status() { size += 1; }
	void utc() { size += UTC_SIZE; }

	std::size_t size = 0;

private:
	std::size_t _number;
};

class BlockReader {
public:
	BlockReader(NumberFormat p_format, const uint8_t *p_data, Sample &r_sample) :
			_format(p_format), _at(p_data), _sample(r_sample) {}

	void raw() {
		for (std::array<uint16_t, 3> *vector :
				{ &_sample.raw_acceleration, &_sample.raw_rate_of_turn, &_sample.raw_magnetic_field }) {
			for (uint16_t &value : *vector) {
				value = _next_u16();
			}
		}
		_sample.raw_temperature = _next_u16();
		_sample.set(Field::RAW_ACCELERATION);
		_sample.set(Field::RAW_RATE_OF_TURN);
		_sample.set(Field::RAW_MAGNETIC_FIELD);
		_sample.set(Field::RAW_TEMPERATURE);
	}
	void gps_pvt() {
		read_gps_pvt(_at, _sample.gps_pvt);
		_at += GPS_PVT_SIZE;
		_sample.set(Field::GPS_PVT);
	}
	void numbers(Field p_field) {
		const Numbers found = numbers_of(p_field, _sample);
		read_numbers(_format, _at, found.count, found.values);
		_at += found.count * number_size(_format);
		_sample.set(p_field);
	}
	void u16(Field p_field) {
		const uint16_t value = _next_u16();
		if (p_field == Field::COUNTER) {
			_sample.counter = value;
			_sample.counter_bits = 16;
		} else {
			(p_field == Field::ANALOG_IN_1 ? _sample.analog_in_1 : _sample.analog_in_2) = value;
		}
		_sample.set(p_field);
	}
	void status() {
		_sample.status_byte = *_at++;
		_sample.set(Field::STATUS_BYTE);
	}
	void utc() {
		read_utc(_at, _sample.utc);
		_at += UTC_SIZE;
		_sample.set(Field::UTC_TIME);
	}

private:
	uint16_t _next_u16() {
		const uint16_t value = read_u16(_at);
		_at += 2;
		return value;
	}

	NumberFormat _format;
	const uint8_t *_at;
	Sample &_sample;
};

class BlockWriter {
public:
	BlockWriter(NumberFormat p_format, const Sample &p_sample, uint8_t *r_bytes) :
			_format(p_format), _sample(p_sample), _at(r_bytes), _begin(r_bytes) {}

	void raw() {
		for (const std::array<uint16_t, 3> *vector :
				{ &_sample.raw_acceleration, &_sample.raw_rate_of_turn, &_sample.raw_magnetic_field }) {
			for (const uint16_t value : *vector) {
				_put_u16(value);
			}
		}
		_put_u16(_sample.raw_temperature);
	}
	void gps_pvt() { _at += write_gps_pvt(_sample.gps_pvt, _at); }
	void numbers(Field p_field) {
		// Only read from here.
		const Numbers found = numbers_of(p_field, const_cast<Sample &>(_sample));
		_at += write_numbers(_format, found.values, found.count, _at);
	}
	void u16(Field p_field) {
		_put_u16(p_field == Field::COUNTER				? uint16_t(_sample.counter)
						: p_field == Field::ANALOG_IN_1 ? _sample.analog_in_1
														: _sample.analog_in_2);
	}
	void status() { *_at++ = _sample.status_byte; }
	void utc() { _at += write_utc(_sample.utc, _at); }
	std::size_t size() const { return std::size_t(_at - _begin); }

private:
	void _put_u16(uint16_t p_value) {
		write_u16(p_value, _at);
		_at += 2;
	}

	NumberFormat _format;
	const Sample &_sample;
	uint8_t *_at;
	uint8_t *_begin;
};

std::size_t measure(const OutputFormat &p_format, bool p_with_time) {
	Measurer measurer(p_format.numbers());
	go_through(p_format, p_with_time, measurer);
	return measurer.size;
}

void decode_block(const OutputFormat &p_format, bool p_with_time, const uint8_t *p_data, Sample &r_sample) {
	r_sample.present = 0;
	r_sample.axes = (p_format.settings & NORTH_EAST_DOWN) != 0 ? Axes::NORTH_EAST_DOWN : Axes::NORTH_WEST_UP;
	BlockReader reader(p_format.numbers(), p_data, r_sample);
	go_through(p_format, p_with_time, reader);
}

} // namespace

bool OutputFormat::is_valid() const {
	const uint32_t others = KNOWN_MODES & ~(RAW | GPS_PVT);
	const bool mixed = (mode & RAW) != 0 && (mode & others) != 0;
	const bool unknown = (mode & ~KNOWN_MODES) != 0;
	const uint32_t form = settings & ORIENTATION_MASK;
	const bool no_form = (mode & ORIENTATION) != 0 && form == ORIENTATION_MASK;
	return !mixed && !unknown && !no_form;
}

std::size_t OutputFormat::size() const {
	return measure(*this, true);
}

std::size_t OutputFormat::size_behind_master() const {
	return measure(*this, false);
}

bool OutputFormat::decode(const uint8_t *p_data, std::size_t p_size, Sample &r_sample) const {
	if (!is_valid() || p_size == 0 || p_size != size()) {
		return false;
	}
	decode_block(*this, true, p_data, r_sample);
	return true;
}

bool OutputFormat::decode_behind_master(const uint8_t *p_data, std::size_t p_size, Sample &r_sample) const {
	if (!is_valid() || p_size != size_behind_master()) {
		return false;
	}
	decode_block(*this, false, p_data, r_sample);
	return true;
}

std::size_t OutputFormat::write(const Sample &p_sample, bool p_with_time, uint8_t *r_bytes) const {
	BlockWriter writer(numbers(), p_sample, r_bytes);
	go_through(*this, p_with_time, writer);
	return writer.size();
}

void MasterFormat::clear() {
	_count = 0;
	_size = HEAD;
}

bool MasterFormat::add(const OutputFormat &p_format) {
	const std::size_t size = p_format.size_behind_master();
	if (_count == MAX_DEVICES || !p_format.is_valid() || _size + size > MAX_DATA) {
		return false;
	}
	_formats[_count] = p_format;
	_sizes[_count] = size;
	_count++;
	_size += size;
	return true;
}

bool MasterFormat::decode(const uint8_t *p_data, std::size_t p_size, Sample *r_samples) const {
	if (p_size != _size || _count == 0) {
		return false;
	}
	const uint16_t counter = read_u16(p_data);
	const uint8_t *block = p_data + HEAD;
	for (std::size_t i = 0; i < _count; i++) {
		Sample &sample = r_samples[i];
		decode_block(_formats[i], false, block, sample);
		sample.bus_id = uint8_t(i + 1);
		sample.counter = counter;
		sample.counter_bits = 16;
		sample.set(Field::COUNTER);
		block += _sizes[i];
	}
	return true;
}

std::size_t MasterFormat::write(uint16_t p_counter, const Sample *p_samples, uint8_t *r_bytes) const {
	write_u16(p_counter, r_bytes);
	std::size_t at = HEAD;
	for (std::size_t i = 0; i < _count; i++) {
		at += _formats[i].write(p_samples[i], false, r_bytes + at);
	}
	return at;
}

} // namespace xbus
