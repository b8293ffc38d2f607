// SPDX-License-Identifier: MIT
#include "drift_state.hpp"

#include <algorithm>
#include <cmath>

namespace heading {

namespace {

/// The standard deviation of the rates of a drift when nothing has been seen, rad/s.
constexpr double RATE = degrees(4.5) / 60.0;
/// By how much a rate changes in a second, rad/s.
constexpr double RATE_CHANGE = degrees(1.0) / 60.0 / 17.0;
/// Of a heading right after a calibration, rad.
constexpr double CALIBRATED = degrees(0.3);
/// Of an angle that nobody has seen yet, rad.
constexpr double ANY = degrees(60.0);
/// By how much the angle of a joint that is held, of the body in the room, of a foot that stands, and
/// habits wander in a second, rad.
constexpr double HELD_WANDER = degrees(0.03);
constexpr double ROOM_WANDER = degrees(0.05);
constexpr double PLANT_WANDER = degrees(0.03);
constexpr double HABIT_WANDER = degrees(0.03);
/// Of a coordinate of a lever that nobody has seen yet, m: of sensors, and of joints in bodies.
constexpr double LEVER = 0.05;
/// Pulls that are off by more than so many standard deviations are none.
constexpr double STRANGE_PULL = 3.0;

double squared(double p_value) {
	return p_value * p_value;
}

} // namespace

void DriftState::reset() {
	_x.fill(0.0);
	for (Column &column : _p) {
		column.fill(0.0);
	}
	for (int i = 0; i < SIZE; i++) {
		double variance = squared(ANY);
		if (i < MOUNTS) {
			variance = squared(CALIBRATED);
		} else if (i < 2 * MOUNTS) {
			variance = squared(RATE);
		} else if (i >= LEVERS) {
			variance = squared(LEVER);
		}
		_p[std::size_t(i)][std::size_t(i)] = variance;
	}
}

void DriftState::predict(double p_step) {
	for (std::size_t i = 0; i < MOUNTS; i++) {
		_x[i] += p_step * _x[MOUNTS + i];
		for (std::size_t k = 0; k < SIZE; k++) {
			_p[i][k] += p_step * _p[MOUNTS + i][k];
		}
	}
	for (std::size_t k = 0; k < SIZE; k++) {
		for (std::size_t i = 0; i < MOUNTS; i++) {
			_p[k][i] += p_step * _p[k][MOUNTS + i];
		}
	}
	for (std::size_t i = 0; i < MOUNTS; i++) {
		double &rate = _p[MOUNTS + i][MOUNTS + i];
		rate = std::min(rate + squared(RATE_CHANGE) * p_step, squared(RATE));
	}
	for (int i = HELD; i < LEVERS; i++) {
		double wander = i == HELD + ROOM ? ROOM_WANDER : HELD_WANDER;
		if (i >= HABITS) {
			wander = HABIT_WANDER;
		} else if (i >= HELD + LEFT_PLANT) {
			wander = PLANT_WANDER;
		}
		double &variance = _p[std::size_t(i)][std::size_t(i)];
		variance = std::min(variance + squared(wander) * p_step, squared(2.0 * ANY));
	}
}

int DriftState::_state(const Angle &p_angle) {
	if (!p_angle.is_habit) {
		return HELD + p_angle.edge;
	}
	return p_angle.front == 0 ? HABITS + p_angle.edge : HABITS + MOUNTS - 1 + p_angle.front;
}

DriftState::Row DriftState::_row(const Angle &p_angle) {
	Row row;
	row.add(p_angle.mount, 1.0);
	if (p_angle.other >= 0) {
		row.add(p_angle.other, -1.0);
	}
	row.add(_state(p_angle), 1.0);
	return row;
}

double DriftState::_dot(const Row &p_row, const Column &p_column) const {
	double sum = 0.0;
	for (int i = 0; i < p_row.count; i++) {
		const Term &term = p_row.terms[std::size_t(i)];
		sum += term.factor * p_column[std::size_t(term.state)];
	}
	return sum;
}

DriftState::Column DriftState::_times(const Row &p_row) const {
	Column found{};
	for (std::size_t k = 0; k < SIZE; k++) {
		found[k] = _dot(p_row, _p[k]);
	}
	return found;
}

double DriftState::_deviation(int p_state) const {
	return std::sqrt(std::max(_p[std::size_t(p_state)][std::size_t(p_state)], 0.0));
}

double DriftState::expected(const Angle &p_angle) const {
	return _dot(_row(p_angle), _x);
}

double DriftState::variance(const Angle &p_angle) const {
	const Row row = _row(p_angle);
	return std::max(_dot(row, _times(row)), 0.0);
}

void DriftState::observe(const Angle &p_angle, double p_seen, double p_variance) {
	_take(_row(p_angle), p_seen, p_variance);
}

void DriftState::observe_drift(int p_mount, double p_seen, double p_variance) {
	Row row;
	row.add(p_mount, 1.0);
	_take(row, p_seen, p_variance);
}

void DriftState::observe(const Pull &p_pull, double p_off, double p_variance) {
	Row row;
	row.add(p_pull.mount, p_pull.turn);
	row.add(p_pull.other, -p_pull.turn);
	for (int i = 0; i < int(p_pull.levers.size()); i++) {
		row.add(_lever(p_pull.mount, i), p_pull.levers[std::size_t(i)]);
	}
	const double known = std::max(_dot(row, _times(row)), 0.0);
	if (squared(p_off) < squared(STRANGE_PULL) * (known + p_variance)) {
		_take(row, _dot(row, _x) + p_off, p_variance);
	}
}

void DriftState::_take(const Row &p_row, double p_seen, double p_variance) {
	const Column times = _times(p_row);
	const double sum = _dot(p_row, times) + p_variance;
	const double off = (p_seen - _dot(p_row, _x)) / sum;
	for (std::size_t i = 0; i < SIZE; i++) {
		_x[i] += times[i] * off;
		const double gain = times[i] / sum;
		for (std::size_t k = 0; k < SIZE; k++) {
			_p[i][k] -= gain * times[k];
		}
	}
}

void DriftState::_isolate(int p_state, double p_variance) {
	const auto at = std::size_t(p_state);
	for (std::size_t k = 0; k < SIZE; k++) {
		_p[at][k] = 0.0;
		_p[k][at] = 0.0;
	}
	_p[at][at] = p_variance;
}

void DriftState::begin(const Angle &p_angle, double p_seen, double p_variance) {
	const int state = _state(p_angle);
	_isolate(state, squared(ANY));
	// Nothing is to be learnt from it about drifts.
	_x[std::size_t(state)] += p_seen - expected(p_angle);
	observe(p_angle, p_seen, p_variance);
}

void DriftState::restart() {
	const Column x = _x;
	Column variances{};
	for (std::size_t i = 0; i < SIZE; i++) {
		variances[i] = _p[i][i];
	}
	reset();
	for (std::size_t i = MOUNTS; i < SIZE; i++) {
		if (i < HELD || i >= LEVERS) {
			_x[i] = x[i];
			_p[i][i] = variances[i];
		}
	}
}

} // namespace heading
