// SPDX-License-Identifier: MIT
#pragma once

#include "bus/sample.hpp"

#include <algorithm>
#include <cmath>

namespace xbus {

/// Beyond what any tracker of this kind measures: 180 m/s^2, 35 rad/s, a few units of magnetic field.
constexpr double MAX_ACCELERATION = 1000.0;
constexpr double MAX_RATE = 100.0;
constexpr double MAX_FIELD = 100.0;

/// Whether a number is that near to zero; false for what is not a number, too.
inline bool is_within(double p_value, double p_most) {
	return std::fabs(p_value) <= p_most;
}

template <std::size_t N>
bool is_within(const std::array<double, N> &p_values, double p_most) {
	return std::all_of(p_values.begin(), p_values.end(), [&](double p_value) { return is_within(p_value, p_most); });
}

/// Whether every value that the sample holds is finite and within what a sensor on a person can measure.
/// Says nothing of how near to 1 the quaternions' lengths are: see NormJudge.
bool is_in_range(const Sample &p_sample);

/// How far the length of a quaternion is from 1; not finite if a part is not.
double norm_deviation(const std::array<double, 4> &p_quaternion);

/// How far a matrix is from a rotation: the greatest error of its columns' lengths and angles.
double rotation_deviation(const std::array<double, 9> &p_matrix);

/// Judges how near to 1 a quaternion's length is. Devices compute with different precision: so beside a fixed
/// bound there is one that is learnt from the device itself. An eight-bit checksum lets one corrupted message
/// in 255 through; this is what finds most of them.
class NormJudge {
public:
	/// Never more.
	static constexpr double MAX = 0.01;
	/// Never less is asked for: rounding of the coarsest format.
	static constexpr double MIN = 4.0e-6;

	bool accept(double p_deviation);

private:
	/// How much more than usual is too much.
	static constexpr double FACTOR = 8.0;
	/// How fast the usual deviation forgets, per sample.
	static constexpr double FORGET = 0.999;
	/// Samples before the learnt bound counts.
	static constexpr int LEARN = 32;
	/// Refusals in a row after which the device is believed to have become less exact.
	static constexpr int PATIENCE = 4;

	double _usual = 0.0;
	int _seen = 0;
	int _refused = 0;
};

/// Judges whether nonsense is a corrupted message, or what the device itself sends.
class NonsenseJudge {
public:
	/// Takes a verdict on its next sample. True if the sample is bad and so many before it were that the device
	/// itself sends nonsense: then its messages are whole.
	bool is_sick(bool p_is_good);

private:
	/// Bad samples in a row after which it is the device.
	static constexpr int MAX = 5;

	int _refused = 0;
};

/// Judges one device's samples.
class SampleJudge {
public:
	enum class Verdict : uint8_t {
		PLAUSIBLE,
		/// The message must be corrupted.
		IMPLAUSIBLE,
		/// The device itself sends nonsense, one sample after the other: its messages are whole.
		SICK,
	};

	Verdict judge(const Sample &p_sample);

private:
	NormJudge _quaternion;
	NormJudge _matrix;
	NonsenseJudge _nonsense;
};

} // namespace xbus
