// SPDX-License-Identifier: MIT
#include "drift_estimator.hpp"

#include <algorithm>
#include <cmath>

namespace heading {

namespace {

/// Turns about the vertical of limbs that hang upside down are not defined; below this part of a
/// quaternion they are not used.
constexpr double LEAST_TWIST = 0.3;
/// A foot that turns more slowly than this stands, rad/s.
constexpr double STANDS = degrees(12.0);
/// A time without samples after which everything begins anew, s.
constexpr double GAP_S = 1.0;
/// A mean that is off by more than so many standard deviations is no drift.
constexpr double STRANGE = 4.0;
/// And after so many of those the posture is another one.
constexpr int STRANGE_BLOCKS = 2;
/// How fast the spread of an edge is learnt, a block, and the least that it can be, rad².
constexpr double LEARN = 0.06;
constexpr double LEAST_VARIANCE = degrees(0.2) * degrees(0.2);

double wrapped(double p_angle) {
	return std::remainder(p_angle, 2.0 * PI);
}

/// The turn about the vertical (twist), and how well it is defined, 0 to 1.
double twist_of(const kinematics::Quat &p_rotation, double &r_defined) {
	r_defined = std::hypot(double(p_rotation.y), double(p_rotation.w));
	return 2.0 * std::atan2(double(p_rotation.y), double(p_rotation.w));
}

} // namespace

void DriftEstimator::reset() {
	*this = DriftEstimator();
}

void DriftEstimator::set_drift(int p_mount, double p_drift) {
	_state.set_drift(p_mount, p_drift, degrees(0.5));
	_corrections[std::size_t(p_mount)] = p_drift;
}

int DriftEstimator::_above(int p_mount) const {
	int above = PARENTS[std::size_t(p_mount)];
	while (above >= 0 && !_worn[std::size_t(above)]) {
		above = PARENTS[std::size_t(above)];
	}
	return above;
}

void DriftEstimator::add(const Sample &p_sample) {
	const double step = p_sample.time - _last.time;
	if (_has_last && step >= 0.0 && step < SAMPLE_S * 0.99) {
		return;
	}
	const bool follows = _has_last && step > 0.0 && step < GAP_S;
	if (follows) {
		for (int side = 0; side < 2; side++) {
			_add_foot(LEFT_PLANT + side, side == 0 ? LEFT_FOOT : RIGHT_FOOT, p_sample, step);
		}
		_collect(p_sample);
		_correct(step);
	}
	if (!_has_last || step < 0.0 || step > 60.0) {
		_block_begin = p_sample.time;
	}
	_last = p_sample;
	_has_last = true;
	const double passed = p_sample.time - _block_begin;
	if (passed >= BLOCK_S) {
		_end_block(passed);
		_block_begin = p_sample.time;
	}
}

void DriftEstimator::_collect(const Sample &p_sample) {
	_block_samples++;
	std::array<double, MOUNTS> turns{};
	std::array<double, MOUNTS> defined{};
	for (std::size_t mount = 0; mount < MOUNTS; mount++) {
		_worn[mount] = _worn[mount] || p_sample.present[mount];
		if (p_sample.present[mount]) {
			turns[mount] = twist_of(p_sample.rotations[mount], defined[mount]);
		}
	}
	for (int mount = 0; mount < MOUNTS; mount++) {
		const auto at = std::size_t(mount);
		const int above = _above(mount);
		if (defined[at] < LEAST_TWIST || (above >= 0 && defined[std::size_t(above)] < LEAST_TWIST)) {
			continue;
		}
		const double weight = above >= 0 ? defined[at] * defined[std::size_t(above)] : defined[at];
		const double angle = turns[at] - (above >= 0 ? turns[std::size_t(above)] : 0.0);
		// Edge 0 is the room; whoever wears no pelvis has another root, which is then in its place.
		Mean &mean = _edges[above >= 0 ? at : std::size_t(ROOM)].mean;
		mean.cosines += weight * std::cos(angle);
		mean.sines += weight * std::sin(angle);
		mean.weights += weight;
		mean.count++;
	}
}

void DriftEstimator::_add_foot(int p_edge, int p_foot, const Sample &p_sample, double p_step) {
	Edge &edge = _edges[std::size_t(p_edge)];
	const auto at = std::size_t(p_foot);
	if (!p_sample.present[at] || !_last.present[at]) {
		edge.is_still = false;
		return;
	}
	const float turned = kinematics::angle_between(_last.rotations[at], p_sample.rotations[at]);
	edge.is_still = edge.is_still && turned < STANDS * p_step;
	double defined = 0.0;
	const double angle = twist_of(p_sample.rotations[at], defined);
	edge.mean.cosines += std::cos(angle);
	edge.mean.sines += std::sin(angle);
	edge.mean.weights += 1.0;
	edge.mean.count++;
}

void DriftEstimator::_end_block(double p_step) {
	_state.predict(p_step);
	for (int edge = 0; edge < EDGES; edge++) {
		const Edge &seen = _edges[std::size_t(edge)];
		const bool is_plant = edge >= MOUNTS;
		if (is_plant && !seen.is_still) {
			_state.forget_posture(edge);
		} else if (seen.mean.count * 2 > _block_samples && seen.mean.weights > 0.0) {
			_take(edge);
		}
		_edges[std::size_t(edge)].mean = Mean();
		_edges[std::size_t(edge)].is_still = true;
	}
	_block_samples = 0;
}

void DriftEstimator::_take(int p_edge) {
	Edge &edge = _edges[std::size_t(p_edge)];
	int mount = p_edge;
	int other = -1;
	if (p_edge == ROOM) {
		while (mount < MOUNTS - 1 && !(_worn[std::size_t(mount)] && _above(mount) < 0)) {
			mount++;
		}
	} else if (p_edge < MOUNTS) {
		other = _above(mount);
	} else {
		mount = p_edge == LEFT_PLANT ? LEFT_FOOT : RIGHT_FOOT;
	}
	const double expected = _state.expected(mount, other, p_edge);
	const double known = _state.variance(mount, other, p_edge);
	const double off = wrapped(std::atan2(edge.mean.sines, edge.mean.cosines) - expected);
	const bool is_new = known > degrees(60.0) * degrees(60.0);
	double variance = p_edge >= MOUNTS ? LEAST_VARIANCE : edge.variance;
	if (!is_new && off * off > STRANGE * STRANGE * (known + variance)) {
		edge.strange++;
		if (edge.strange < STRANGE_BLOCKS) {
			return;
		}
		_state.forget_posture(p_edge);
		edge.variance = std::min(edge.variance * 1.5, degrees(40.0) * degrees(40.0));
	} else if (!is_new) {
		const double seen = std::clamp(off * off - known, LEAST_VARIANCE, 9.0 * edge.variance);
		edge.variance += LEARN * (seen - edge.variance);
		// Beyond two standard deviations an observation counts less (Huber 1964).
		const double far = std::abs(off) / (2.0 * std::sqrt(known + variance));
		variance *= std::max(far, 1.0);
	}
	edge.strange = 0;
	_state.observe(mount, other, p_edge, expected + off, variance);
}

void DriftEstimator::_correct(double p_step) {
	for (int mount = 0; mount < MOUNTS; mount++) {
		double &correction = _corrections[std::size_t(mount)];
		// Between two blocks the drift goes on.
		const double ahead = (_last.time - _block_begin) * _state.rate(mount);
		const double off = _state.drift(mount) + ahead - correction;
		correction += std::clamp(off, -FASTEST * p_step, FASTEST * p_step);
	}
}

} // namespace heading
