// SPDX-License-Identifier: MIT
#include "device/full_mt_data.hpp"

#include "device/item_structs.hpp"
#include "device/number_writer.hpp"

namespace xbus {

namespace {

/// Of the parts that the product does not read.
void read_part(DataPart p_part, NumberFormat p_format, const uint8_t *p_data, FullSample &r_sample) {
	const auto numbers = [&](Further p_field, double *r_values, std::size_t p_count) {
		read_numbers(p_format, p_data, p_count, r_values);
		r_sample.set(p_field);
	};
	switch (p_part) {
		case DataPart::RAW:
			read_raw(p_data, r_sample);
			break;
		case DataPart::GPS_PVT:
			read_gps_pvt(p_data, r_sample.gps_pvt);
			r_sample.set(Further::GPS_PVT);
			break;
		case DataPart::TEMPERATURE:
			numbers(Further::TEMPERATURE, &r_sample.temperature, 1);
			break;
		case DataPart::ANALOG_1:
			r_sample.analog_in_1 = read_u16(p_data);
			r_sample.set(Further::ANALOG_IN_1);
			break;
		case DataPart::ANALOG_2:
			r_sample.analog_in_2 = read_u16(p_data);
			r_sample.set(Further::ANALOG_IN_2);
			break;
		case DataPart::POSITION:
			numbers(Further::POSITION, r_sample.position.data(), 3);
			break;
		case DataPart::VELOCITY:
			numbers(Further::VELOCITY, r_sample.velocity.data(), 3);
			break;
		case DataPart::STATUS:
			r_sample.status_byte = *p_data;
			r_sample.set(Further::STATUS_BYTE);
			break;
		case DataPart::UTC:
			read_utc(p_data, r_sample.utc);
			r_sample.set(Further::UTC_TIME);
			break;
		default:
			break;
	}
}

void write_part(DataPart p_part, NumberFormat p_format, const FullSample &p_sample, uint8_t *r_bytes) {
	switch (p_part) {
		case DataPart::RAW:
			write_raw(p_sample, r_bytes);
			break;
		case DataPart::GPS_PVT:
			write_gps_pvt(p_sample.gps_pvt, r_bytes);
			break;
		case DataPart::TEMPERATURE:
			write_numbers(p_format, &p_sample.temperature, 1, r_bytes);
			break;
		case DataPart::ANALOG_1:
			write_u16(p_sample.analog_in_1, r_bytes);
			break;
		case DataPart::ANALOG_2:
			write_u16(p_sample.analog_in_2, r_bytes);
			break;
		case DataPart::POSITION:
			write_numbers(p_format, p_sample.position.data(), 3, r_bytes);
			break;
		case DataPart::VELOCITY:
			write_numbers(p_format, p_sample.velocity.data(), 3, r_bytes);
			break;
		case DataPart::STATUS:
			*r_bytes = p_sample.status_byte;
			break;
		case DataPart::COUNTER:
			write_u16(uint16_t(p_sample.counter), r_bytes);
			break;
		case DataPart::UTC:
			write_utc(p_sample.utc, r_bytes);
			break;
		default:
			write_field(p_format, p_sample, part_field(p_part), r_bytes);
			break;
	}
}

void read_further(const OutputFormat &p_format, bool p_with_time, const uint8_t *p_data, FullSample &r_sample) {
	r_sample.further_present = 0;
	visit_parts(p_format, p_with_time, [&](DataPart p_part) {
		read_part(p_part, p_format.numbers(), p_data, r_sample);
		p_data += part_size(p_part, p_format.numbers());
	});
}

} // namespace

bool decode_data(const OutputFormat &p_format, const uint8_t *p_data, std::size_t p_size, FullSample &r_sample) {
	if (!p_format.decode(p_data, p_size, r_sample)) {
		return false;
	}
	read_further(p_format, true, p_data, r_sample);
	return true;
}

bool decode_data(const MasterFormat &p_format, const uint8_t *p_data, std::size_t p_size, FullSample *r_samples) {
	std::array<Sample, MAX_DEVICES> samples;
	if (!p_format.decode(p_data, p_size, samples.data())) {
		return false;
	}
	const uint8_t *block = p_data + MasterFormat::HEAD;
	for (std::size_t i = 0; i < p_format.count(); i++) {
		static_cast<Sample &>(r_samples[i]) = samples[i];
		read_further(p_format.format(i), false, block, r_samples[i]);
		block += p_format.format(i).size_behind_master();
	}
	return true;
}

std::size_t write_block(const OutputFormat &p_format, const FullSample &p_sample, bool p_with_time, uint8_t *r_bytes) {
	std::size_t at = 0;
	visit_parts(p_format, p_with_time, [&](DataPart p_part) {
		write_part(p_part, p_format.numbers(), p_sample, r_bytes + at);
		at += part_size(p_part, p_format.numbers());
	});
	return at;
}

std::size_t write_data(
		const MasterFormat &p_format, uint16_t p_counter, const FullSample *p_samples, uint8_t *r_bytes) {
	write_u16(p_counter, r_bytes);
	std::size_t at = MasterFormat::HEAD;
	for (std::size_t i = 0; i < p_format.count(); i++) {
		at += write_block(p_format.format(i), p_samples[i], false, r_bytes + at);
	}
	return at;
}

} // namespace xbus
