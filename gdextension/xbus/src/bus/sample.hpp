// SPDX-License-Identifier: MIT
#pragma once

#include "bus/message.hpp"

#include <array>

namespace xbus {

/// What a sample may hold; bits of Sample::present are 1 << field. What else a device can send is skipped.
enum class Field : uint8_t {
	/// Counter of samples: 8, 16 or 32 bits (Sample::counter_bits).
	COUNTER,
	SAMPLE_TIME_FINE,
	QUATERNION,
	MATRIX,
	EULER,
	ACCELERATION,
	RATE_OF_TURN,
	MAGNETIC_FIELD,
	STATUS_WORD,
	/// None of them.
	COUNT,
};

/// The axes of the world that orientations refer to.
enum class Axes : uint8_t {
	EAST_NORTH_UP,
	NORTH_EAST_DOWN,
	/// X to the magnetic north, as a legacy tracker's.
	NORTH_WEST_UP,
	/// A code that no manual knows.
	UNKNOWN,
};

/// The real numbers of a field, where they lie in a sample.
struct Numbers {
	/// 0 where a field has none.
	std::size_t count = 0;
	double *values = nullptr;
};

/// What one tracker said at one moment. Only what `present` names is valid; all else is of earlier samples.
struct Sample {
	using Vector = std::array<double, 3>;

	uint64_t present = 0;
	/// Whose: MASTER or 1..N.
	uint8_t bus_id = MASTER;
	Axes axes = Axes::EAST_NORTH_UP;
	uint8_t counter_bits = 0;
	uint32_t counter = 0;
	/// 1/10000 s.
	uint32_t sample_time_fine = 0;
	uint32_t status_word = 0;

	/// w, x, y, z: turns the sensor's axes into the world's.
	std::array<double, 4> quaternion{};
	/// The same rotation, column by column as it is sent: the first three are the sensor's X axis.
	std::array<double, 9> matrix{};
	/// Roll, pitch, yaw in degrees.
	Vector euler{};
	/// m/s^2, with gravity.
	Vector acceleration{};
	/// rad/s.
	Vector rate_of_turn{};
	/// The earth's field is 1 where the tracker was calibrated.
	Vector magnetic_field{};

	bool has(Field p_field) const { return (present >> unsigned(p_field) & 1U) != 0; }
	void set(Field p_field) { present |= uint64_t(1) << unsigned(p_field); }
	/// Nothing is present any more.
	void clear() { present = 0; }
	Numbers numbers(Field p_field);

	/// The orientation as a quaternion w, x, y, z, from whichever form is present; false if none is.
	bool orientation(std::array<double, 4> &r_quaternion) const;
};

} // namespace xbus
