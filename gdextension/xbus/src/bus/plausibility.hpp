// SPDX-License-Identifier: MIT
#pragma once

#include "bus/sample.hpp"

namespace xbus {

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
	/// Implausible samples in a row after which it is the device.
	static constexpr int PATIENCE = 5;

	NormJudge _quaternion;
	NormJudge _matrix;
	int _refused = 0;
};

} // namespace xbus
