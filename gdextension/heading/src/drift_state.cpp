// SPDX-License-Identifier: MIT
#include "drift_state.hpp"

#include <algorithm>
#include <cmath>

namespace heading {

namespace {

/// What an unknown posture may be, rad².
constexpr double ANY = degrees(120.0) * degrees(120.0);

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
		double variance = ANY;
		if (i < MOUNTS) {
			variance = squared(_belief.calibrated);
		} else if (i < 2 * MOUNTS) {
			variance = squared(_belief.rate);
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
		rate = std::min(rate + squared(_belief.rate_change) * p_step, squared(_belief.rate));
	}
	for (int edge = 0; edge < EDGES; edge++) {
		double wander = _belief.joint;
		if (edge == ROOM) {
			wander = _belief.room;
		} else if (edge >= MOUNTS) {
			wander = _belief.plant;
		}
		const auto at = std::size_t(2 * MOUNTS + edge);
		_p[at][at] = std::min(_p[at][at] + squared(wander) * p_step, 2.0 * ANY);
	}
}

DriftState::Row DriftState::_row(int p_mount, int p_other, int p_edge) {
	Row row;
	const auto add = [&row](int p_state, double p_factor) {
		row.terms[std::size_t(row.count++)] = { p_state, p_factor };
	};
	add(p_mount, 1.0);
	if (p_other >= 0) {
		add(p_other, -1.0);
	}
	if (p_edge >= 0) {
		add(2 * MOUNTS + p_edge, 1.0);
	}
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

double DriftState::expected(int p_mount, int p_other, int p_edge) const {
	return _dot(_row(p_mount, p_other, p_edge), _x);
}

double DriftState::variance(int p_mount, int p_other, int p_edge) const {
	const Row row = _row(p_mount, p_other, p_edge);
	return std::max(_dot(row, _times(row)), 0.0);
}

void DriftState::observe(int p_mount, int p_other, int p_edge, double p_angle, double p_variance) {
	const Row row = _row(p_mount, p_other, p_edge);
	const Column times = _times(row);
	const double sum = _dot(row, times) + p_variance;
	const double off = (p_angle - _dot(row, _x)) / sum;
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

void DriftState::forget_posture(int p_edge) {
	_isolate(2 * MOUNTS + p_edge, ANY);
}

void DriftState::set_drift(int p_mount, double p_drift, double p_deviation) {
	_x[std::size_t(p_mount)] = p_drift;
	_isolate(p_mount, squared(p_deviation));
}

} // namespace heading
