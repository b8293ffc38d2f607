// SPDX-License-Identifier: MIT
#include "drift_estimator.hpp"

#include "limb_heading.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace heading {

namespace {

/// Limbs that hang upside down point nowhere, nor do knees whose axis is upright; what is less defined
/// than this is not used.
constexpr double MIN_DEFINED = 0.3;
/// A foot that turns more slowly than this stands, rad/s; and what noise may be in a step, rad.
constexpr double STANDS = degrees(12.0);
constexpr double STANDS_NOISE = degrees(1.5);
/// By how much the variance of blocks of a joint that is held is more than what one tells of the next
/// (they are off alike), where joints' accelerations tell more; and that of feet that stand less. Found
/// with the benchmark.
constexpr double HELD_ALIKE = 3.0;
constexpr double PLANT_ALIKE = 0.4;
/// A time without samples after which everything begins anew, s.
constexpr double GAP_S = 1.0;
/// A mean that is off by more than so many standard deviations is no drift.
constexpr double STRANGE = 3.0;
/// And after so many of those the posture is another one.
constexpr int STRANGE_BLOCKS = 2;
/// A block with a larger spread is no posture that is held, rad.
constexpr double HELD_SPREAD = degrees(1.5);
/// Whoever turns so far the same way from block to block, and again, turns on purpose, rad.
constexpr double TURNS = degrees(1.0);
/// What is expected at first of means of blocks and of windows, rad².
constexpr double NEW_VARIANCE = degrees(1.0) * degrees(1.0);
/// Where a window has a larger spread its mean says nothing, rad.
constexpr double HABIT_SPREAD = degrees(50.0);
/// Whoever turns in a block by a larger spread faces no way; ways that differ by less are the same;
/// how far somebody is off it at first, rad², how fast that is learnt, and after how many
/// blocks somebody who stays so is another witness.
constexpr double FRONT_SPREAD = degrees(6.0);
constexpr double SAME_FRONT = degrees(15.0);
constexpr double FRONT_VARIANCE = degrees(4.0) * degrees(4.0);
constexpr double LEARN_FRONT = 0.1;
constexpr int FRONT_WITNESS = 15;
/// The mean of rates of drift, squared, in variances of what they would seem to be if there were
/// none: below the first nothing is corrected, above the second everything (after Efron and Morris 1973).
constexpr double DOUBTED = 0.8;
constexpr double TRUSTED = 1.2;
/// What a magnetic north that looks good may be off, rad²: for minutes by the same.
constexpr double NORTH_VARIANCE = degrees(12.0) * degrees(12.0);
/// How fast both are learnt, a block or a window, and the least that they can be, rad².
constexpr double LEARN = 0.06;
constexpr double LEARN_HABIT = 0.1;
constexpr double MIN_VARIANCE = degrees(0.2) * degrees(0.2);
constexpr double MIN_HABIT = degrees(1.0) * degrees(1.0);

double wrapped(double p_angle) {
	return std::remainder(p_angle, 2.0 * PI);
}

} // namespace

void DriftEstimator::reset() {
	*this = DriftEstimator();
}

void DriftEstimator::restart(const std::array<double, MOUNTS> &p_drifts) {
	DriftState state = _state;
	state.restart();
	const double trust = _trust;
	const std::array<MagneticField, MOUNTS> fields = _fields;
	JointMotion motion = _motion;
	motion.clear();
	*this = DriftEstimator();
	_state = state;
	_trust = trust;
	_fields = fields;
	_motion = std::move(motion);
	_known = p_drifts;
	_corrections = p_drifts;
}

int DriftEstimator::_above(int p_mount) const {
	int above = PARENTS[std::size_t(p_mount)];
	while (above >= 0 && !_worn[std::size_t(above)]) {
		above = PARENTS[std::size_t(above)];
	}
	return above;
}

bool DriftEstimator::wants(double p_time) const {
	const double step = p_time - _last.time;
	return !(_has_last && step >= 0.0 && step < SAMPLE_S * 0.99);
}

void DriftEstimator::add(const Sample &p_sample) {
	_motion.add({ p_sample.time, p_sample.present, p_sample.rotations, p_sample.accelerations });
	_take_motion();
	if (!wants(p_sample.time)) {
		return;
	}
	const double step = p_sample.time - _last.time;
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
	_window_samples++;
	for (std::size_t mount = 0; mount < MOUNTS; mount++) {
		_worn[mount] = _worn[mount] || p_sample.present[mount];
		if (p_sample.present[mount]) {
			_fields[mount].add(p_sample.fields[mount], SAMPLE_S);
		}
	}
	for (int mount = 0; mount < MOUNTS; mount++) {
		const auto at = std::size_t(mount);
		const int above = _above(mount);
		if (!p_sample.present[at] || (above >= 0 && !p_sample.present[std::size_t(above)])) {
			continue;
		}
		const bool is_hinge = (mount == LEFT_SHANK || mount == RIGHT_SHANK) && above == PARENTS[at];
		const auto heading_of = is_hinge ? hinge_of : twist_of;
		const LimbHeading own = heading_of(p_sample.rotations[at]);
		const LimbHeading other =
				above >= 0 ? heading_of(p_sample.rotations[std::size_t(above)]) : LimbHeading{ 0.0, 1.0 };
		if (std::min(own.defined, other.defined) < MIN_DEFINED) {
			continue;
		}
		const double weight = own.defined * other.defined;
		const double angle = own.angle - other.angle;
		// Edge 0 is the room; whoever wears no pelvis has another root, which is then in its place.
		Edge &edge = _edges[above >= 0 ? at : std::size_t(ROOM)];
		edge.block.add(angle, weight);
		edge.window.add(angle, weight);
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
	edge.is_still = edge.is_still && turned < STANDS * p_step + STANDS_NOISE;
	edge.block.add(twist_of(p_sample.rotations[at]).angle, 1.0);
}

void DriftEstimator::_end_block(double p_step) {
	_state.predict(p_step);
	for (int edge = 0; edge < EDGES; edge++) {
		Edge &seen = _edges[std::size_t(edge)];
		const bool is_still = edge >= MOUNTS ? seen.is_still : seen.block.spread() < HELD_SPREAD;
		if (!is_still) {
			seen.held = 0;
			seen.still = 0;
		} else if (seen.block.count * 2 > _block_samples && seen.block.weights > 0.0) {
			// Neither the first block after a movement counts nor the last one before: parts of
			// the movement may be in them.
			if (seen.still >= 2) {
				_take_held(edge, seen.waiting);
			}
			seen.still++;
			seen.waiting = seen.block.angle();
		}
		if (edge < MOUNTS && seen.block.weights > 0.0) {
			seen.blocks.add(seen.block.angle(), 1.0);
		}
		if (edge == ROOM && seen.block.weights > 0.0 && seen.block.spread() < FRONT_SPREAD) {
			_take_front();
		}
		seen.block = AngleMean();
		seen.is_still = true;
	}
	_take_fields();
	_doubt();
	_block_samples = 0;
	if (++_blocks % WINDOW_BLOCKS == 0) {
		_end_window();
	}
}

void DriftEstimator::_end_window() {
	for (int edge = 1; edge < MOUNTS; edge++) {
		Edge &seen = _edges[std::size_t(edge)];
		if (seen.window.count * 2 > _window_samples && seen.window.weights > 0.0) {
			_take_habit(edge);
		}
		seen.window = AngleMean();
		seen.blocks = AngleMean();
	}
	_window_samples = 0;
}

int DriftEstimator::_root() const {
	int root = 0;
	while (root < MOUNTS - 1 && !(_worn[std::size_t(root)] && _above(root) < 0)) {
		root++;
	}
	return root;
}

Angle DriftEstimator::_angle(int p_edge) const {
	Angle angle{ p_edge, -1, p_edge, false };
	if (p_edge == ROOM) {
		angle.mount = _root();
	} else if (p_edge < MOUNTS) {
		angle.other = _above(p_edge);
	} else {
		angle.mount = p_edge == LEFT_PLANT ? LEFT_FOOT : RIGHT_FOOT;
	}
	return angle;
}

void DriftEstimator::_take_held(int p_edge, double p_seen) {
	Edge &edge = _edges[std::size_t(p_edge)];
	const Angle angle = _angle(p_edge);
	const double expected = _state.expected(angle);
	const double known = _state.variance(angle);
	const double off = wrapped(p_seen - expected);
	const double change = edge.held > 0 ? wrapped(p_seen - edge.last) : 0.0;
	if (std::min(std::abs(change), std::abs(edge.change)) > TURNS && change * edge.change > 0.0) {
		edge.held = 0;
	}
	edge.last = p_seen;
	edge.change = change;
	if (edge.held > 0 && off * off > STRANGE * STRANGE * (known + edge.held_variance)) {
		edge.strange++;
		if (edge.strange < STRANGE_BLOCKS) {
			return;
		}
		edge.held = 0;
	}
	edge.strange = 0;
	edge.held++;
	if (edge.held == 1) {
		edge.held_variance = NEW_VARIANCE;
		_state.begin(angle, expected + off, edge.held_variance);
		return;
	}
	const double seen = std::clamp(off * off - known, MIN_VARIANCE, 9.0 * edge.held_variance);
	edge.held_variance += std::max(LEARN, 0.5 / edge.held) * (seen - edge.held_variance);
	double alike = p_edge == ROOM || !_moved ? 1.0 : HELD_ALIKE;
	alike = p_edge >= MOUNTS ? PLANT_ALIKE : alike;
	_state.observe(angle, expected + off, alike * edge.held_variance);
}

void DriftEstimator::_take_habit(int p_edge) {
	Edge &edge = _edges[std::size_t(p_edge)];
	if (edge.window.spread() > HABIT_SPREAD) {
		return;
	}
	Angle angle = _angle(p_edge);
	angle.is_habit = true;
	const double expected = _state.expected(angle);
	const double known = _state.variance(angle);
	const double off = wrapped(edge.window.angle() - expected);
	edge.windows++;
	if (edge.windows == 1) {
		const double within = edge.blocks.spread();
		edge.habit_variance = std::max(MIN_HABIT, within * within);
		_state.begin(angle, expected + off, edge.habit_variance);
		return;
	}
	const double learn = std::max(LEARN_HABIT, 1.0 / (edge.windows + 2));
	edge.habit_variance += learn * (std::max(off * off - known, MIN_HABIT) - edge.habit_variance);
	edge.habit_persistence += learn * (off * edge.last_off - edge.habit_persistence);
	edge.last_off = off;
	// Windows that are off alike are not so many witnesses (an autoregressive process of first order).
	const double alike = std::clamp(edge.habit_persistence / edge.habit_variance, 0.0, 0.85);
	const double variance = edge.habit_variance * (1.0 + alike) / (1.0 - alike);
	if (off * off <= STRANGE * STRANGE * (known + variance)) {
		_state.observe(angle, expected + off, variance);
	}
}

void DriftEstimator::_take_front() {
	const double seen = _edges[ROOM].block.angle();
	Angle angle = _angle(ROOM);
	angle.is_habit = true;
	int oldest = 0;
	int nearest = -1;
	double least = SAME_FRONT;
	for (int i = 0; i < FRONTS; i++) {
		oldest = _fronts[std::size_t(i)] < _fronts[std::size_t(oldest)] ? i : oldest;
		angle.front = i;
		const double off = std::abs(wrapped(seen - _state.expected(angle)));
		if (_fronts[std::size_t(i)] > 0 && off < least) {
			least = off;
			nearest = i;
		}
	}
	angle.front = nearest < 0 ? oldest : nearest;
	const double expected = _state.expected(angle);
	const double off = wrapped(seen - expected);
	_faced = nearest == _front ? _faced + 1 : 0;
	_front = angle.front;
	_fronts[std::size_t(_front)] = _blocks + 1;
	if (nearest < 0) {
		_front_variance = _front_variance == 0.0 ? FRONT_VARIANCE : _front_variance;
		_state.begin(angle, expected + off, _front_variance);
	} else if (_faced % FRONT_WITNESS == 1) {
		const double beyond = off * off - _state.variance(angle);
		_front_variance += LEARN_FRONT * (std::max(beyond, MIN_HABIT) - _front_variance);
		_state.observe(angle, expected + off, _front_variance);
	}
}

void DriftEstimator::_take_motion() {
	for (const JointMotion::Sight &sight : _motion.take()) {
		_moved = true;
		const int above = PARENTS[std::size_t(sight.mount)];
		const auto lever = [this, &sight](const kinematics::Vec3 &p_usual, int p_first) {
			const kinematics::Vec3 off{ float(_state.lever(sight.mount, p_first)),
				float(_state.lever(sight.mount, p_first + 1)), float(_state.lever(sight.mount, p_first + 2)) };
			return p_usual + off;
		};
		const Levers &usual = _motion.levers(sight.mount);
		double drifted = _state.drift(sight.mount) - _state.drift(above);
		drifted += _known[std::size_t(sight.mount)] - _known[std::size_t(above)];
		const kinematics::Quat turn = kinematics::exp({ 0.0f, float(drifted), 0.0f });
		const kinematics::Vec3 expected = turn.rotate(sight.above.joint(lever(usual.above, 0)));
		const kinematics::Vec3 seen = sight.own.joint(lever(usual.own, 3));
		const kinematics::Vec3 off = seen - expected;
		// How both level directions change with a turn about the vertical.
		const kinematics::Vec3 middle = (seen + expected) * 0.5f;
		Pull x{ sight.mount, above, middle.z, {} };
		Pull z{ sight.mount, above, -middle.x, {} };
		for (std::size_t axis = 0; axis < 3; axis++) {
			const kinematics::Vec3 other = turn.rotate(sight.above.levers[axis]);
			x.levers[axis] = other.x;
			z.levers[axis] = other.z;
			x.levers[axis + 3] = -sight.own.levers[axis].x;
			z.levers[axis + 3] = -sight.own.levers[axis].z;
		}
		_state.observe(x, off.x, sight.variance);
		_state.observe(z, off.z, sight.variance);
	}
}

void DriftEstimator::_take_fields() {
	for (int mount = 0; mount < MOUNTS; mount++) {
		const MagneticField &seen = _fields[std::size_t(mount)];
		if (seen.is_good()) {
			_state.observe_drift(mount, seen.turned() - _known[std::size_t(mount)], NORTH_VARIANCE);
		}
	}
}

void DriftEstimator::_doubt() {
	double rates = 0.0;
	int worn = 0;
	for (int mount = 0; mount < MOUNTS; mount++) {
		if (_worn[std::size_t(mount)]) {
			const double deviation = _state.rate_deviation(mount);
			rates += _state.rate(mount) * _state.rate(mount) / (deviation * deviation);
			worn++;
		}
	}
	const double ratio = worn > 0 ? rates / worn : 0.0;
	_trust = std::clamp((ratio - DOUBTED) / (TRUSTED - DOUBTED), 0.0, 1.0);
}

void DriftEstimator::_correct(double p_step) {
	for (int mount = 0; mount < MOUNTS; mount++) {
		double &correction = _corrections[std::size_t(mount)];
		// Between two blocks the drift goes on.
		const double ahead = (_last.time - _block_begin) * _state.rate(mount);
		const double wanted = _known[std::size_t(mount)] + _trust * (_state.drift(mount) + ahead);
		const double off = wanted - correction;
		correction += std::clamp(off, -FASTEST * p_step, FASTEST * p_step);
	}
}

} // namespace heading
