// SPDX-License-Identifier: MIT
#include "bus/sample.hpp"

#include <cmath>

namespace xbus {

namespace {

std::array<double, 4> quaternion_of_euler(const Sample::Vector &p_degrees) {
	constexpr double HALF = 3.14159265358979323846 / 360.0;
	const double cr = std::cos(p_degrees[0] * HALF);
	const double sr = std::sin(p_degrees[0] * HALF);
	const double cp = std::cos(p_degrees[1] * HALF);
	const double sp = std::sin(p_degrees[1] * HALF);
	const double cy = std::cos(p_degrees[2] * HALF);
	const double sy = std::sin(p_degrees[2] * HALF);
	return { cr * cp * cy + sr * sp * sy, sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy,
		cr * cp * sy - sr * sp * cy };
}

/// The component that is greatest is found first: the others are divided by it.
std::array<double, 4> quaternion_of_matrix(const std::array<double, 9> &p_columns) {
	const auto at = [&](std::size_t p_row, std::size_t p_column) { return p_columns[p_column * 3 + p_row]; };
	const std::array<double, 4> squares = { 1.0 + at(0, 0) + at(1, 1) + at(2, 2), 1.0 + at(0, 0) - at(1, 1) - at(2, 2),
		1.0 - at(0, 0) + at(1, 1) - at(2, 2), 1.0 - at(0, 0) - at(1, 1) + at(2, 2) };
	std::size_t greatest = 0;
	for (std::size_t i = 1; i < squares.size(); i++) {
		greatest = squares[i] > squares[greatest] ? i : greatest;
	}
	// Row by row: four times the products of the components.
	const double wx = at(2, 1) - at(1, 2);
	const double wy = at(0, 2) - at(2, 0);
	const double wz = at(1, 0) - at(0, 1);
	const double xy = at(1, 0) + at(0, 1);
	const double xz = at(0, 2) + at(2, 0);
	const double yz = at(2, 1) + at(1, 2);
	const std::array<std::array<double, 4>, 4> products = { { { squares[0], wx, wy, wz }, { wx, squares[1], xy, xz },
			{ wy, xy, squares[2], yz }, { wz, xz, yz, squares[3] } } };
	std::array<double, 4> found = products[greatest];
	double norm = 0.0;
	for (const double part : found) {
		norm += part * part;
	}
	norm = std::sqrt(norm);
	for (double &part : found) {
		part = norm > 0.0 ? part / norm : 0.0;
	}
	return found;
}

} // namespace

Numbers Sample::numbers(Field p_field) {
	switch (p_field) {
		case Field::QUATERNION:
			return { quaternion.size(), quaternion.data() };
		case Field::MATRIX:
			return { matrix.size(), matrix.data() };
		case Field::EULER:
			return { euler.size(), euler.data() };
		case Field::ACCELERATION:
			return { acceleration.size(), acceleration.data() };
		case Field::RATE_OF_TURN:
			return { rate_of_turn.size(), rate_of_turn.data() };
		case Field::MAGNETIC_FIELD:
			return { magnetic_field.size(), magnetic_field.data() };
		default:
			return {};
	}
}

bool Sample::orientation(std::array<double, 4> &r_quaternion) const {
	if (has(Field::QUATERNION)) {
		r_quaternion = quaternion;
		return true;
	}
	if (has(Field::MATRIX)) {
		r_quaternion = quaternion_of_matrix(matrix);
		return true;
	}
	if (has(Field::EULER)) {
		r_quaternion = quaternion_of_euler(euler);
		return true;
	}
	return false;
}

} // namespace xbus
