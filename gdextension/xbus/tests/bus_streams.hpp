// SPDX-License-Identifier: MIT
#pragma once

#include "bus/framer.hpp"
#include "bus/stream_check.hpp"
#include "device/full_mt_data.hpp"
#include "device/items.hpp"
#include "device/replies.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <random>
#include <string>
#include <vector>

// Streams of suits, and what becomes of them on a bad line: for tests, the fuzzer and the benchmark.

namespace streams {

using namespace xbus;

using Bytes = std::vector<uint8_t>;

/// Messages one after the other, and where each begins.
struct Stream {
	Bytes bytes;
	std::vector<std::size_t> begins;

	void add(const uint8_t *p_bytes, std::size_t p_size) {
		begins.push_back(bytes.size());
		bytes.insert(bytes.end(), p_bytes, p_bytes + p_size);
	}
	std::size_t end(std::size_t p_message) const {
		return p_message + 1 < begins.size() ? begins[p_message + 1] : bytes.size();
	}
};

/// A random rotation, as a person's limb could have it.
inline std::array<double, 4> draw_quaternion(std::mt19937 &r_random) {
	std::normal_distribution<double> normal;
	std::array<double, 4> parts;
	double norm = 0.0;
	for (double &part : parts) {
		part = normal(r_random);
		norm += part * part;
	}
	for (double &part : parts) {
		part /= std::sqrt(norm);
	}
	return parts;
}

inline std::array<double, 9> matrix_of(const std::array<double, 4> &q) {
	const double w = q[0];
	const double x = q[1];
	const double y = q[2];
	const double z = q[3];
	return { 1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y), 2 * (x * y - w * z),
		1 - 2 * (x * x + z * z), 2 * (y * z + w * x), 2 * (x * z + w * y), 2 * (y * z - w * x),
		1 - 2 * (x * x + y * y) };
}

template <std::size_t N>
void draw(std::mt19937 &r_random, double p_most, std::array<double, N> &r_values) {
	std::uniform_real_distribution<double> values(-p_most, p_most);
	for (double &value : r_values) {
		value = values(r_random);
	}
}

inline void draw_raw(std::mt19937 &r_random, std::array<uint16_t, 3> &r_values) {
	for (uint16_t &value : r_values) {
		value = uint16_t(r_random());
	}
}

inline void draw_time(std::mt19937 &r_random, UtcTime &r_utc) {
	r_utc = { uint32_t(r_random() % 1000000000U), uint16_t(2000 + r_random() % 100), uint8_t(1 + r_random() % 12),
		uint8_t(1 + r_random() % 28), uint8_t(r_random() % 24), uint8_t(r_random() % 60), uint8_t(r_random() % 60),
		uint8_t(r_random() % 8) };
}

/// Values that a worn tracker could measure, in every field.
inline FullSample draw_sample(std::mt19937 &r_random) {
	FullSample sample;
	sample.quaternion = draw_quaternion(r_random);
	sample.matrix = matrix_of(sample.quaternion);
	draw(r_random, 89.0, sample.euler);
	draw(r_random, 20.0, sample.acceleration);
	draw(r_random, 20.0, sample.free_acceleration);
	draw(r_random, 20.0, sample.acceleration_hr);
	draw(r_random, 0.2, sample.delta_v);
	draw(r_random, 5.0, sample.rate_of_turn);
	draw(r_random, 5.0, sample.rate_of_turn_hr);
	sample.delta_q = draw_quaternion(r_random);
	draw(r_random, 1.0, sample.magnetic_field);
	draw(r_random, 1.0, sample.magnetic_field_corrected);
	draw(r_random, 80.0, sample.position);
	draw(r_random, 2000.0, sample.position_ecef);
	draw(r_random, 80.0, sample.lat_lon);
	draw(r_random, 10.0, sample.velocity);
	sample.temperature = double(r_random() % 400) / 10.0;
	sample.altitude_msl = double(r_random() % 1000);
	sample.altitude_ellipsoid = double(r_random() % 1000);
	draw_raw(r_random, sample.raw_acceleration);
	draw_raw(r_random, sample.raw_rate_of_turn);
	draw_raw(r_random, sample.raw_magnetic_field);
	draw_raw(r_random, sample.raw_gyro_temperature);
	draw(r_random, 1.0, sample.raw_delta_q);
	draw(r_random, 1.0, sample.raw_delta_v);
	sample.raw_temperature = uint16_t(r_random());
	sample.analog_in_1 = uint16_t(r_random());
	sample.analog_in_2 = uint16_t(r_random());
	sample.status_byte = uint8_t(r_random());
	sample.status_word = uint32_t(r_random());
	sample.counter = uint32_t(r_random());
	sample.sample_time_fine = uint32_t(r_random());
	sample.pressure = 100000 + uint32_t(r_random() % 2000);
	draw_time(r_random, sample.utc);
	return sample;
}

/// A master with so many trackers that send orientations, and what they measure too if asked for.
inline MasterFormat suit_format(std::size_t p_trackers, uint16_t p_mode, uint32_t p_settings = 0) {
	MasterFormat format;
	for (std::size_t i = 0; i < p_trackers; i++) {
		format.add({ p_mode, p_settings });
	}
	return format;
}

/// So many messages of a master whose trackers move smoothly.
inline Stream suit_stream(
		const MasterFormat &p_format, std::size_t p_messages, uint32_t p_seed, uint16_t p_counter = 0) {
	std::mt19937 random(p_seed);
	Stream stream;
	stream.bytes.reserve(p_messages * (p_format.size() + 7));
	stream.begins.reserve(p_messages);
	std::vector<FullSample> samples(p_format.count());
	std::array<uint8_t, MAX_FRAME> frame;
	for (std::size_t i = 0; i < p_messages; i++) {
		for (FullSample &sample : samples) {
			sample = draw_sample(random);
		}
		stream.add(
				frame.data(), device::write_mt_data(p_format, uint16_t(p_counter + i), samples.data(), frame.data()));
	}
	return stream;
}

/// The items that a tracker which stands alone is asked for.
constexpr std::array<uint16_t, 7> IMU_ITEMS = { item::PACKET_COUNTER, item::SAMPLE_TIME_FINE, item::QUATERNION,
	item::RATE_OF_TURN, item::ACCELERATION, item::MAGNETIC_FIELD, item::STATUS_WORD };

inline Stream imu_stream(std::size_t p_messages, uint32_t p_seed) {
	std::mt19937 random(p_seed);
	Stream stream;
	std::array<uint8_t, MAX_FRAME> frame;
	for (std::size_t i = 0; i < p_messages; i++) {
		FullSample sample = draw_sample(random);
		sample.counter = uint32_t(i);
		sample.sample_time_fine = uint32_t(i * 100);
		stream.add(
				frame.data(), device::write_mt_data2(IMU_ITEMS.data(), IMU_ITEMS.size(), sample, MASTER, frame.data()));
	}
	return stream;
}

/// Replaces every byte by another one with this probability. `r_touched`: of each message, whether it was.
inline Bytes corrupt(const Stream &p_stream, double p_rate, uint32_t p_seed, std::vector<bool> &r_touched) {
	std::mt19937 random(p_seed);
	std::geometric_distribution<std::size_t> gap(p_rate);
	Bytes bytes = p_stream.bytes;
	r_touched.assign(p_stream.begins.size(), false);
	std::size_t message = 0;
	for (std::size_t at = gap(random); at < bytes.size(); at += 1 + gap(random)) {
		bytes[at] = uint8_t(bytes[at] + 1 + random() % 255);
		while (p_stream.end(message) <= at) {
			message++;
		}
		r_touched[message] = true;
	}
	return bytes;
}

/// What came through a bad line.
struct Survival {
	std::size_t clean = 0;
	std::size_t regained = 0;
	/// Stretches of corrupted messages, and messages taken that nobody sent.
	std::size_t stretches = 0;
	std::size_t wrong = 0;

	double regained_share() const { return clean > 0 ? double(regained) / double(clean) : 0.0; }
	double wrong_share() const { return stretches > 0 ? double(wrong) / double(stretches) : 0.0; }
	void add(const Survival &p_other) {
		clean += p_other.clean;
		regained += p_other.regained;
		stretches += p_other.stretches;
		wrong += p_other.wrong;
	}
};

/// Sends the stream over a bad line to a framer and a judge. A message counts as regained if it was taken where
/// it was sent, and as wrong if one was taken that is none of those sent.
inline Survival survive(const Stream &p_stream, const MasterFormat *p_format, double p_rate, uint32_t p_seed) {
	std::vector<bool> touched;
	const Bytes bytes = corrupt(p_stream, p_rate, p_seed, touched);
	const auto framer = std::make_unique<Framer>();
	const auto check = std::make_unique<StreamCheck>();
	if (p_format != nullptr) {
		check->expect_master(*p_format);
		framer->set_longest(p_format->size() > MAX_SHORT_DATA ? p_format->size() : MAX_SHORT_DATA);
	}
	Survival found;
	for (std::size_t i = 0; i < touched.size(); i++) {
		found.clean += touched[i] ? 0U : 1U;
		found.stretches += touched[i] && (i == 0 || !touched[i - 1]) ? 1U : 0U;
	}
	std::size_t message = 0;
	const auto sink = [&](const Frame &p_frame) {
		if (check->take(p_frame, framer->statistics().is_noisy()) == StreamCheck::Verdict::REFUSED) {
			return false;
		}
		const auto at = std::size_t(p_frame.data - bytes.data());
		while (message + 1 < touched.size() && p_stream.begins[message + 1] < at) {
			message++;
		}
		const std::size_t head = p_stream.end(message) - p_stream.begins[message] > MAX_SHORT_DATA + 5 ? 6 : 4;
		const bool same = !touched[message] && at == p_stream.begins[message] + head;
		found.regained += same ? 1U : 0U;
		found.wrong += same ? 0U : 1U;
		return true;
	};
	// In one piece, so that what is taken is known by its offset.
	framer->feed(bytes.data(), bytes.size(), sink);
	return found;
}

inline Bytes read_file(const std::string &p_name) {
	Bytes bytes;
	if (std::FILE *file = std::fopen(p_name.c_str(), "rb")) {
		std::array<uint8_t, 65536> block;
		std::size_t got = 0;
		while ((got = std::fread(block.data(), 1, block.size(), file)) > 0) {
			bytes.insert(bytes.end(), block.begin(), block.begin() + std::ptrdiff_t(got));
		}
		std::fclose(file);
	}
	return bytes;
}

/// "FA FF 30 00 D1" as bytes.
inline Bytes hex(const std::string &p_text) {
	Bytes bytes;
	for (std::size_t at = 0; at + 1 < p_text.size(); at += 3) {
		bytes.push_back(uint8_t(std::stoul(p_text.substr(at, 2), nullptr, 16)));
	}
	return bytes;
}

} // namespace streams
