// SPDX-License-Identifier: MIT
#include "device/item_structs.hpp"

#include "bus/bytes.hpp"

namespace xbus {

namespace {

// One description of a structure serves reading and writing: these two go through its members in turn.

class Reader {
public:
	explicit Reader(const uint8_t *p_data) : _at(p_data) {}

	void u8(uint8_t &r_value) { r_value = *_at++; }
	void u16(uint16_t &r_value) { r_value = read_u16(_step(2)); }
	void u32(uint32_t &r_value) { r_value = read_u32(_step(4)); }
	void u64(uint64_t &r_value) { r_value = read_u64(_step(8)); }
	void i32(int32_t &r_value) { r_value = read_i32(_step(4)); }
	void i64(int64_t &r_value) { r_value = int64_t(read_u64(_step(8))); }
	/// Fewer bytes on the bus than in memory.
	void short_i32(int32_t &r_value) { r_value = int16_t(read_u16(_step(2))); }
	void short_i64(int64_t &r_value) { r_value = read_i32(_step(4)); }

private:
	const uint8_t *_step(std::size_t p_size) {
		const uint8_t *here = _at;
		_at += p_size;
		return here;
	}

	const uint8_t *_at;
};

class Writer {
public:
	explicit Writer(uint8_t *r_bytes) : _begin(r_bytes), _at(r_bytes) {}

	void u8(uint8_t p_value) { *_at++ = p_value; }
	void u16(uint16_t p_value) { write_u16(p_value, _step(2)); }
	void u32(uint32_t p_value) { write_u32(p_value, _step(4)); }
	void u64(uint64_t p_value) { write_u64(p_value, _step(8)); }
	void i32(int32_t p_value) { write_u32(uint32_t(p_value), _step(4)); }
	void i64(int64_t p_value) { write_u64(uint64_t(p_value), _step(8)); }
	void short_i32(int32_t p_value) { write_u16(uint16_t(p_value), _step(2)); }
	void short_i64(int64_t p_value) { write_u32(uint32_t(p_value), _step(4)); }
	std::size_t size() const { return std::size_t(_at - _begin); }

private:
	uint8_t *_step(std::size_t p_size) {
		uint8_t *here = _at;
		_at += p_size;
		return here;
	}

	uint8_t *_begin;
	uint8_t *_at;
};

template <class A, class T>
void go_through_date(A &r_archive, T &r_utc) {
	r_archive.u16(r_utc.year);
	r_archive.u8(r_utc.month);
	r_archive.u8(r_utc.day);
	r_archive.u8(r_utc.hour);
	r_archive.u8(r_utc.minute);
	r_archive.u8(r_utc.second);
	r_archive.u8(r_utc.validity);
}

template <class A, class T>
void go_through_utc(A &r_archive, T &r_utc) {
	r_archive.u32(r_utc.nanoseconds);
	go_through_date(r_archive, r_utc);
}

template <class A, class T>
void go_through_trigger(A &r_archive, T &r_trigger) {
	r_archive.u8(r_trigger.line);
	r_archive.u8(r_trigger.polarity);
	r_archive.u32(r_trigger.time);
	r_archive.u16(r_trigger.frame);
}

template <class A, class T>
void go_through_gnss_pvt(A &r_archive, T &r_pvt) {
	r_archive.u32(r_pvt.itow);
	go_through_date(r_archive, r_pvt.utc);
	r_archive.u32(r_pvt.time_accuracy);
	r_archive.i32(r_pvt.nanoseconds);
	r_archive.u8(r_pvt.fix_type);
	r_archive.u8(r_pvt.flags);
	r_archive.u8(r_pvt.satellites);
	r_archive.u8(r_pvt.reserved);
	r_archive.i32(r_pvt.longitude);
	r_archive.i32(r_pvt.latitude);
	r_archive.i32(r_pvt.height);
	r_archive.i32(r_pvt.height_msl);
	r_archive.u32(r_pvt.horizontal_accuracy);
	r_archive.u32(r_pvt.vertical_accuracy);
	r_archive.i32(r_pvt.velocity_north);
	r_archive.i32(r_pvt.velocity_east);
	r_archive.i32(r_pvt.velocity_down);
	r_archive.i32(r_pvt.ground_speed);
	r_archive.i32(r_pvt.heading_of_motion);
	r_archive.u32(r_pvt.speed_accuracy);
	r_archive.u32(r_pvt.heading_accuracy);
	r_archive.i32(r_pvt.heading_of_vehicle);
	for (auto &dilution : r_pvt.dilutions) {
		r_archive.u16(dilution);
	}
}

template <class A, class T>
void go_through_satellite(A &r_archive, T &r_satellite) {
	r_archive.u8(r_satellite.system);
	r_archive.u8(r_satellite.number);
	r_archive.u8(r_satellite.signal);
	r_archive.u8(r_satellite.flags);
}

template <class A, class T>
void go_through_awinda(A &r_archive, T &r_snapshot) {
	r_archive.u32(r_snapshot.device_id);
	r_archive.u32(r_snapshot.frame);
	for (std::size_t i = 0; i < 3; i++) {
		r_archive.i32(r_snapshot.delta_q[i]);
	}
	for (auto &part : r_snapshot.delta_v) {
		r_archive.short_i64(part);
	}
	for (auto &part : r_snapshot.magnetic_field) {
		r_archive.short_i32(part);
	}
	r_archive.i32(r_snapshot.pressure);
	r_archive.u16(r_snapshot.status);
	r_archive.u8(r_snapshot.acceleration_clips);
	r_archive.u8(r_snapshot.rate_clips);
}

template <class A, class T, class U>
void go_through_full(A &r_archive, T &r_snapshot, U &r_frame) {
	r_archive.u16(r_frame);
	r_archive.u64(r_snapshot.time);
	for (auto &part : r_snapshot.delta_q) {
		r_archive.i32(part);
	}
	for (auto &part : r_snapshot.delta_v) {
		r_archive.i64(part);
	}
	for (auto &part : r_snapshot.magnetic_field) {
		r_archive.i32(part);
	}
	r_archive.i32(r_snapshot.pressure);
	r_archive.u8(r_snapshot.acceleration_clips);
	r_archive.u8(r_snapshot.rate_clips);
	r_archive.u16(r_snapshot.status);
}

template <class A, class T>
void go_through_gps_pvt(A &r_archive, T &r_pvt) {
	r_archive.u16(r_pvt.pressure);
	r_archive.u8(r_pvt.pressure_age);
	r_archive.u32(r_pvt.itow);
	r_archive.i32(r_pvt.latitude);
	r_archive.i32(r_pvt.longitude);
	r_archive.i32(r_pvt.height);
	r_archive.i32(r_pvt.velocity_north);
	r_archive.i32(r_pvt.velocity_east);
	r_archive.i32(r_pvt.velocity_down);
	r_archive.u32(r_pvt.horizontal_accuracy);
	r_archive.u32(r_pvt.vertical_accuracy);
	r_archive.u32(r_pvt.speed_accuracy);
	r_archive.u8(r_pvt.age);
}

} // namespace

void read_utc(const uint8_t *p_data, UtcTime &r_utc) {
	Reader reader(p_data);
	go_through_utc(reader, r_utc);
}

std::size_t write_utc(const UtcTime &p_utc, uint8_t *r_bytes) {
	Writer writer(r_bytes);
	go_through_utc(writer, p_utc);
	return writer.size();
}

void read_trigger(const uint8_t *p_data, Trigger &r_trigger) {
	Reader reader(p_data);
	go_through_trigger(reader, r_trigger);
}

std::size_t write_trigger(const Trigger &p_trigger, uint8_t *r_bytes) {
	Writer writer(r_bytes);
	go_through_trigger(writer, p_trigger);
	return writer.size();
}

void read_gnss_pvt(const uint8_t *p_data, GnssPvt &r_pvt) {
	Reader reader(p_data);
	go_through_gnss_pvt(reader, r_pvt);
}

std::size_t write_gnss_pvt(const GnssPvt &p_pvt, uint8_t *r_bytes) {
	Writer writer(r_bytes);
	go_through_gnss_pvt(writer, p_pvt);
	return writer.size();
}

void read_satellites(const uint8_t *p_data, GnssSatellites &r_satellites) {
	r_satellites.itow = read_u32(p_data);
	r_satellites.count = p_data[4] < GnssSatellites::MAX ? p_data[4] : uint8_t(GnssSatellites::MAX);
	Reader reader(p_data + 8);
	for (std::size_t i = 0; i < r_satellites.count; i++) {
		go_through_satellite(reader, r_satellites.satellites[i]);
	}
}

std::size_t write_satellites(const GnssSatellites &p_satellites, uint8_t *r_bytes) {
	const std::size_t count = p_satellites.count < GnssSatellites::MAX ? p_satellites.count : GnssSatellites::MAX;
	Writer writer(r_bytes);
	writer.u32(p_satellites.itow);
	writer.u32(uint32_t(count) << 24U);
	for (std::size_t i = 0; i < count; i++) {
		go_through_satellite(writer, p_satellites.satellites[i]);
	}
	return writer.size();
}

void read_awinda_snapshot(const uint8_t *p_data, Snapshot &r_snapshot) {
	r_snapshot = {};
	Reader reader(p_data);
	go_through_awinda(reader, r_snapshot);
}

std::size_t write_awinda_snapshot(const Snapshot &p_snapshot, uint8_t *r_bytes) {
	Writer writer(r_bytes);
	go_through_awinda(writer, p_snapshot);
	return writer.size();
}

void read_full_snapshot(const uint8_t *p_data, Snapshot &r_snapshot) {
	r_snapshot = {};
	r_snapshot.is_full = true;
	Reader reader(p_data);
	uint16_t frame = 0;
	go_through_full(reader, r_snapshot, frame);
	r_snapshot.frame = frame;
}

std::size_t write_full_snapshot(const Snapshot &p_snapshot, uint8_t *r_bytes) {
	Writer writer(r_bytes);
	const auto frame = uint16_t(p_snapshot.frame);
	go_through_full(writer, p_snapshot, frame);
	return writer.size();
}

void read_gps_pvt(const uint8_t *p_data, GpsPvt &r_pvt) {
	Reader reader(p_data);
	go_through_gps_pvt(reader, r_pvt);
}

std::size_t write_gps_pvt(const GpsPvt &p_pvt, uint8_t *r_bytes) {
	Writer writer(r_bytes);
	go_through_gps_pvt(writer, p_pvt);
	return writer.size();
}

void read_raw_vector(const uint8_t *p_data, std::array<uint16_t, 3> &r_vector) {
	for (std::size_t i = 0; i < r_vector.size(); i++) {
		r_vector[i] = read_u16(p_data + i * 2);
	}
}

void read_raw(const uint8_t *p_data, FullSample &r_sample) {
	read_raw_vector(p_data, r_sample.raw_acceleration);
	read_raw_vector(p_data + 6, r_sample.raw_rate_of_turn);
	read_raw_vector(p_data + 12, r_sample.raw_magnetic_field);
	r_sample.raw_temperature = read_u16(p_data + 18);
	r_sample.set(Further::RAW_ACCELERATION);
	r_sample.set(Further::RAW_RATE_OF_TURN);
	r_sample.set(Further::RAW_MAGNETIC_FIELD);
	r_sample.set(Further::RAW_TEMPERATURE);
}

std::size_t write_raw_vector(const std::array<uint16_t, 3> &p_vector, uint8_t *r_bytes) {
	for (std::size_t i = 0; i < p_vector.size(); i++) {
		write_u16(p_vector[i], r_bytes + i * 2);
	}
	return p_vector.size() * 2;
}

std::size_t write_raw(const FullSample &p_sample, uint8_t *r_bytes) {
	write_raw_vector(p_sample.raw_acceleration, r_bytes);
	write_raw_vector(p_sample.raw_rate_of_turn, r_bytes + 6);
	write_raw_vector(p_sample.raw_magnetic_field, r_bytes + 12);
	write_u16(p_sample.raw_temperature, r_bytes + 18);
	return 20;
}

} // namespace xbus
