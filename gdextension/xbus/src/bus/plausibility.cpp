// SPDX-License-Identifier: MIT
#include "bus/plausibility.hpp"

#include <algorithm>
#include <cmath>

namespace xbus {

namespace {

/// Rounding of an angle at its end, degrees.
constexpr double ANGLE_SLACK = 0.01;

bool is_euler(const Sample::Vector &p_degrees) {
	return std::fabs(p_degrees[0]) <= 180.0 + ANGLE_SLACK && std::fabs(p_degrees[1]) <= 90.0 + ANGLE_SLACK &&
			std::fabs(p_degrees[2]) <= 180.0 + ANGLE_SLACK;
}

} // namespace

bool is_in_range(const Sample &p_sample) {
	const auto good = [&](Field p_field, bool p_good) { return !p_sample.has(p_field) || p_good; };
	return good(Field::EULER, is_euler(p_sample.euler)) &&
			good(Field::ACCELERATION, is_within(p_sample.acceleration, MAX_ACCELERATION)) &&
			good(Field::RATE_OF_TURN, is_within(p_sample.rate_of_turn, MAX_RATE)) &&
			good(Field::MAGNETIC_FIELD, is_within(p_sample.magnetic_field, MAX_FIELD));
}

double norm_deviation(const std::array<double, 4> &p_quaternion) {
	double square = 0.0;
	for (const double part : p_quaternion) {
		square += part * part;
	}
	return std::fabs(std::sqrt(square) - 1.0);
}

double rotation_deviation(const std::array<double, 9> &p_matrix) {
	const auto dot = [&](std::size_t p_a, std::size_t p_b) {
		double sum = 0.0;
		for (std::size_t i = 0; i < 3; i++) {
			sum += p_matrix[p_a * 3 + i] * p_matrix[p_b * 3 + i];
		}
		return sum;
	};
	// One term that is not a number makes the whole sum such.
	return std::fabs(dot(0, 0) - 1.0) + std::fabs(dot(1, 1) - 1.0) + std::fabs(dot(2, 2) - 1.0) + std::fabs(dot(0, 1)) +
			std::fabs(dot(1, 2)) + std::fabs(dot(0, 2));
}

bool NormJudge::accept(double p_deviation) {
	if (!(p_deviation <= MAX)) {
		return false;
	}
	const double bound = _seen < LEARN ? MAX : std::max(MIN, FACTOR * _usual);
	if (p_deviation > bound && _refused < PATIENCE) {
		_refused++;
		return false;
	}
	_refused = 0;
	_seen = std::min(_seen + 1, LEARN);
	_usual = std::max(p_deviation, _usual * FORGET);
	return true;
}

bool NonsenseJudge::is_sick(bool p_is_good) {
	const bool is_sick = !p_is_good && _refused >= MAX;
	_refused = p_is_good ? 0 : std::min(_refused + 1, MAX);
	return is_sick;
}

SampleJudge::Verdict SampleJudge::judge(const Sample &p_sample) {
	const bool good = is_in_range(p_sample) &&
			(!p_sample.has(Field::QUATERNION) || _quaternion.accept(norm_deviation(p_sample.quaternion))) &&
			(!p_sample.has(Field::MATRIX) || _matrix.accept(rotation_deviation(p_sample.matrix)));
	const bool is_sick = _nonsense.is_sick(good);
	return good ? Verdict::PLAUSIBLE : is_sick ? Verdict::SICK : Verdict::IMPLAUSIBLE;
}

} // namespace xbus
