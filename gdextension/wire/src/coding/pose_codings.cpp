// SPDX-License-Identifier: MIT
#include "coding/pose_codings.hpp"

#include "coding/lattice_rotation.hpp"

#include <array>
#include <cmath>
#include <cstring>

namespace wire {

namespace {

using kinematics::Quat;

constexpr double PI = 3.14159265358979323846;
// Polar coordinates: rows of equal pitch, in each row as many yaws as its circle is long.
constexpr std::size_t ROWS = 1814;
constexpr uint32_t LENGTH_BITS = 10;
constexpr uint32_t MAX_LENGTH = (1U << LENGTH_BITS) - 1;
constexpr double SQRT_2 = 1.41421356237309504880;

using RowStarts = std::array<uint32_t, ROWS + 1>;

double pitch_of(std::size_t p_row) {
	return ((double(p_row) + 0.5) / double(ROWS) - 0.5) * PI;
}

const RowStarts &row_starts() {
	static const RowStarts starts = [] {
		RowStarts sums{};
		for (std::size_t i = 0; i < ROWS; i++) {
			sums[i + 1] = sums[i] + uint32_t(std::lround(2.0 * double(ROWS) * std::cos(pitch_of(i))));
		}
		return sums;
	}();
	return starts;
}

void put(uint32_t p_word, uint8_t *r_bytes) {
	for (std::size_t i = 0; i < 4; i++) {
		r_bytes[i] = uint8_t(p_word >> (8 * i));
	}
}

uint32_t take(const uint8_t *p_bytes) {
	uint32_t word = 0;
	for (std::size_t i = 0; i < 4; i++) {
		word |= uint32_t(p_bytes[i]) << (8 * i);
	}
	return word;
}

void put_float(float p_value, uint8_t *r_bytes) {
	uint32_t word = 0;
	std::memcpy(&word, &p_value, sizeof(word));
	put(word, r_bytes);
}

float take_float(const uint8_t *p_bytes) {
	const uint32_t word = take(p_bytes);
	float value = 0.0f;
	std::memcpy(&value, &word, sizeof(value));
	return value;
}

// The component that was left out. Rounding can make the squares of the others more than 1: without
// this guard their root would be no number, and the limb would vanish (thesis 7.3).
float left_out(float p_squares) {
	return p_squares < 1.0f ? std::sqrt(1.0f - p_squares) : 0.0f;
}

uint32_t to_polar(const Quat &p_rotation) {
	const double length = std::sqrt(double(p_rotation.x) * p_rotation.x + double(p_rotation.y) * p_rotation.y +
			double(p_rotation.z) * p_rotation.z);
	// Half the angle instead of its sine: close to a half turn the sine says next to nothing.
	const double half = std::atan2(length, double(p_rotation.w));
	const uint32_t size = uint32_t(std::lround(half / (0.5 * PI) * MAX_LENGTH));
	const double pitch = length > 0.0 ? std::asin(std::fmax(-1.0, std::fmin(1.0, p_rotation.y / length))) : 0.0;
	const double row = (pitch / PI + 0.5) * double(ROWS);
	const std::size_t at = row < 0.0 ? 0 : (row >= double(ROWS) ? ROWS - 1 : std::size_t(row));
	const uint32_t count = row_starts()[at + 1] - row_starts()[at];
	const double yaw = std::atan2(double(p_rotation.z), double(p_rotation.x)) / (2.0 * PI);
	const int64_t step = std::lround((yaw - std::floor(yaw)) * count);
	return ((row_starts()[at] + uint32_t(step % count)) << LENGTH_BITS) | (size > MAX_LENGTH ? MAX_LENGTH : size);
}

bool from_polar(uint32_t p_word, Quat &r_rotation) {
	const RowStarts &starts = row_starts();
	const uint32_t direction = p_word >> LENGTH_BITS;
	if (direction >= starts[ROWS]) {
		return false;
	}
	std::size_t row = 0;
	for (std::size_t step = 1024; step > 0; step /= 2) {
		row += row + step < ROWS && starts[row + step] <= direction ? step : 0;
	}
	const double yaw = 2.0 * PI * double(direction - starts[row]) / double(starts[row + 1] - starts[row]);
	const double half = 0.5 * PI * double(p_word & MAX_LENGTH) / MAX_LENGTH;
	const double across = std::sin(half) * std::cos(pitch_of(row));
	r_rotation = Quat{ float(across * std::cos(yaw)), float(std::sin(half) * std::sin(pitch_of(row))),
		float(across * std::sin(yaw)), float(std::cos(half)) }
						 .normalized();
	return true;
}

void put_bits(uint32_t p_value, uint32_t p_count, std::size_t &r_at, uint8_t *r_bytes) {
	for (uint32_t i = 0; i < p_count; i++, r_at++) {
		r_bytes[r_at / 8] = uint8_t(uint32_t(r_bytes[r_at / 8]) | (((p_value >> i) & 1U) << (r_at % 8)));
	}
}

uint32_t take_bits(const uint8_t *p_bytes, uint32_t p_count, std::size_t &r_at) {
	uint32_t value = 0;
	for (uint32_t i = 0; i < p_count; i++, r_at++) {
		value |= ((uint32_t(p_bytes[r_at / 8]) >> (r_at % 8)) & 1U) << i;
	}
	return value;
}

void put_smallest(const Quat &p_rotation, int p_bits, std::size_t &r_at, uint8_t *r_bytes) {
	const float values[4] = { p_rotation.x, p_rotation.y, p_rotation.z, p_rotation.w };
	int largest = 3;
	for (int i = 0; i < 3; i++) {
		largest = std::fabs(values[i]) > std::fabs(values[largest]) ? i : largest;
	}
	const double sign = values[largest] < 0.0f ? -1.0 : 1.0;
	const double most = double((1U << uint32_t(p_bits)) - 1);
	put_bits(uint32_t(largest), 2, r_at, r_bytes);
	for (int i = 0; i < 4; i++) {
		if (i != largest) {
			const double share = 0.5 * (sign * double(values[i]) * SQRT_2 + 1.0);
			put_bits(uint32_t(std::lround(std::fmax(0.0, std::fmin(1.0, share)) * most)), uint32_t(p_bits), r_at,
					r_bytes);
		}
	}
}

bool take_smallest(const uint8_t *p_bytes, int p_bits, std::size_t &r_at, Quat &r_rotation) {
	const uint32_t largest = take_bits(p_bytes, 2, r_at);
	const double most = double((1U << uint32_t(p_bits)) - 1);
	float values[4] = {};
	float squares = 0.0f;
	for (uint32_t i = 0; i < 4; i++) {
		if (i != largest) {
			values[i] = float((2.0 * take_bits(p_bytes, uint32_t(p_bits), r_at) / most - 1.0) / SQRT_2);
			squares += values[i] * values[i];
		}
	}
	values[largest] = left_out(squares);
	r_rotation = Quat{ values[0], values[1], values[2], values[3] }.normalized();
	// Three components that are all large leave no room for a larger one.
	return squares < 1.1f;
}

bool decode_limb(PoseCoding p_coding, const uint8_t *p_bytes, Quat &r_rotation) {
	if (p_coding == PoseCoding::THESIS_4) {
		return from_polar(take(p_bytes), r_rotation);
	}
	Quat found{ take_float(p_bytes), take_float(p_bytes + 4), take_float(p_bytes + 8), 0.0f };
	found.w = p_coding == PoseCoding::FLOATS ? take_float(p_bytes + 12) : left_out(found.dot(found));
	if (!is_rotation(found)) {
		return false;
	}
	r_rotation = found.normalized();
	return true;
}

void encode_limb(PoseCoding p_coding, const Quat &p_rotation, uint8_t *r_bytes) {
	// The component that is left out is not negative: q and -q are the same rotation.
	const Quat rotation = p_rotation.w < 0.0f ? -p_rotation : p_rotation;
	if (p_coding == PoseCoding::THESIS_4) {
		put(to_polar(rotation), r_bytes);
		return;
	}
	const Quat &kept = p_coding == PoseCoding::FLOATS ? p_rotation : rotation;
	put_float(kept.x, r_bytes);
	put_float(kept.y, r_bytes + 4);
	put_float(kept.z, r_bytes + 8);
	if (p_coding == PoseCoding::FLOATS) {
		put_float(kept.w, r_bytes + 12);
	}
}

std::size_t limb_bits(PoseCoding p_coding, int p_bits) {
	constexpr std::size_t BITS[3] = { 128, 96, 32 };
	return p_coding == PoseCoding::SMALLEST_3 ? std::size_t(2 + 3 * p_bits) : BITS[int(p_coding)];
}

} // namespace

std::size_t coded_size(PoseCoding p_coding, int p_bits, std::size_t p_limbs) {
	return (limb_bits(p_coding, p_bits) * p_limbs + 7) / 8;
}

std::size_t coded_limbs(PoseCoding p_coding, int p_bits, std::size_t p_bytes) {
	const std::size_t limbs = 8 * p_bytes / limb_bits(p_coding, p_bits);
	return coded_size(p_coding, p_bits, limbs) == p_bytes ? limbs : 0;
}

bool encode_pose(PoseCoding p_coding, int p_bits, const Quat *p_rotations, std::size_t p_limbs, uint8_t *r_bytes) {
	std::size_t at = 0;
	std::memset(r_bytes, 0, coded_size(p_coding, p_bits, p_limbs));
	for (std::size_t i = 0; i < p_limbs; i++) {
		if (!is_rotation(p_rotations[i])) {
			return false;
		}
		const Quat rotation = p_rotations[i].normalized();
		if (p_coding == PoseCoding::SMALLEST_3) {
			put_smallest(rotation, p_bits, at, r_bytes);
		} else {
			encode_limb(p_coding, rotation, r_bytes + i * limb_bits(p_coding, p_bits) / 8);
		}
	}
	return true;
}

bool decode_pose(PoseCoding p_coding, int p_bits, const uint8_t *p_bytes, std::size_t p_size, Quat *r_rotations) {
	const std::size_t limbs = coded_limbs(p_coding, p_bits, p_size);
	std::size_t at = 0;
	for (std::size_t i = 0; i < limbs; i++) {
		const bool good = p_coding == PoseCoding::SMALLEST_3
				? take_smallest(p_bytes, p_bits, at, r_rotations[i])
				: decode_limb(p_coding, p_bytes + i * limb_bits(p_coding, p_bits) / 8, r_rotations[i]);
		if (!good) {
			return false;
		}
	}
	// What is left of the last byte is 0.
	return limbs > 0 &&
			(p_coding != PoseCoding::SMALLEST_3 || at % 8 == 0 || uint32_t(p_bytes[at / 8]) >> (at % 8) == 0);
}

} // namespace wire
