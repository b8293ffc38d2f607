// SPDX-License-Identifier: MIT
#pragma once

#include "person_state.hpp"

#include <array>
#include <cstdint>

namespace wire {

/// Fractions of a lattice unit that predictions are made in.
constexpr int FRACTION = 16;

/// A rotation's parts in the chart of one dropped component, in 1 / FRACTION lattice units.
using Parts = std::array<int32_t, 3>;

/// Whether a quaternion's norm is between 0.9 and 1.1.
inline bool is_rotation(const kinematics::Quat &p_rotation) {
	const float square = p_rotation.dot(p_rotation);
	return square > 0.81f && square < 1.21f;
}

/// Whether three parts are those of a rotation whose dropped component is positive, on the lattice
/// (all even or all odd).
inline bool is_on_lattice(const std::array<int32_t, 3> &p_parts, int p_resolution) {
	int64_t squares = 0;
	for (const int32_t part : p_parts) {
		if (part < -p_resolution || part > p_resolution || ((part ^ p_parts[0]) & 1) != 0) {
			return false;
		}
		squares += int64_t(part) * part;
	}
	return squares < int64_t(p_resolution) * p_resolution;
}

/// p_numerator / p_denominator to the nearest whole number, halves away from 0. The denominator is positive.
inline int64_t rounded_quotient(int64_t p_numerator, int64_t p_denominator) {
	return (p_numerator + (p_numerator < 0 ? -p_denominator : p_denominator) / 2) / p_denominator;
}

/// The four components of a code, times a common factor that is returned: exact.
inline int64_t components_of(const RotationCode &p_code, int p_resolution, std::array<int64_t, 4> &r_components) {
	int64_t squares = 0;
	int at = 0;
	for (int i = 0; i < 4; i++) {
		if (i != p_code.dropped) {
			const int64_t part = p_code.parts[std::size_t(at++)];
			r_components[std::size_t(i)] = 2 * p_resolution * part;
			squares += part * part;
		}
	}
	const int64_t whole = int64_t(p_resolution) * p_resolution;
	r_components[p_code.dropped & 3] = whole - squares;
	return whole + squares;
}

/// The parts of a code in the chart of p_dropped: whole numbers only, the same on every machine.
inline Parts parts_in_chart(const RotationCode &p_code, int p_dropped, int p_resolution) {
	if (p_code.dropped == p_dropped) {
		return { p_code.parts[0] * FRACTION, p_code.parts[1] * FRACTION, p_code.parts[2] * FRACTION };
	}
	std::array<int64_t, 4> components{};
	const int64_t norm = components_of(p_code, p_resolution, components);
	const bool turned = components[std::size_t(p_dropped)] < 0;
	const int64_t kept = turned ? -components[std::size_t(p_dropped)] : components[std::size_t(p_dropped)];
	Parts parts{};
	int at = 0;
	for (int i = 0; i < 4; i++) {
		if (i != p_dropped) {
			const int64_t value = turned ? -components[std::size_t(i)] : components[std::size_t(i)];
			parts[std::size_t(at++)] = int32_t(rounded_quotient(value * p_resolution * FRACTION, norm + kept));
		}
	}
	return parts;
}

} // namespace wire
