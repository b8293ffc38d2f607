// SPDX-License-Identifier: MIT
#include "joint_motion.hpp"

#include <algorithm>
#include <cmath>

namespace heading {

namespace {

constexpr double GRAVITY = 9.81;
/// A longer time between two moments is a gap, s.
constexpr double MOMENT_GAP_S = 0.11;
/// What an acceleration is off in the mean over a bump, m/s²: by its sensor, and by gravity, a hundredth
/// of which a tilt that is off by half a degree makes level; and as a part of what is measured, by soft
/// tissue.
constexpr double OFF = 0.075;
constexpr double SOFT = 0.12;
/// What is not that much stronger (squared) than it may be off says nothing of a direction.
constexpr double STRONGER = 1.5;
/// Harder knocks than this shake sensors on their limbs, m/s².
constexpr double KNOCK = 60.0;
/// How fast it is learnt what an acceleration is always off, a bump, and from how much of it, m/s².
constexpr float LEARN_BIAS = 0.1f;
constexpr float LEARN_BIAS_FROM = 0.3f;
/// An acceleration that is less was not measured, m/s².
constexpr float MEASURED = 1e-3f;

constexpr std::array<kinematics::Vec3, 3> AXES{ { { 1.0f, 0.0f, 0.0f }, { 0.0f, 1.0f, 0.0f }, { 0.0f, 0.0f, 1.0f } } };

double level_squared(const kinematics::Vec3 &p_vector) {
	return double(p_vector.x) * p_vector.x + double(p_vector.z) * p_vector.z;
}

} // namespace

void JointMotion::set_levers(int p_mount, const Levers &p_levers) {
	_levers[std::size_t(p_mount)] = p_levers;
	_known[std::size_t(p_mount)] = true;
}

void JointMotion::clear() {
	_sights.clear();
	_bumps[0].runs = false;
	_bumps[1].runs = false;
	_has_last = false;
}

std::vector<JointMotion::Sight> JointMotion::take() {
	std::vector<Sight> taken;
	taken.swap(_sights);
	return taken;
}

void JointMotion::add(const Moment &p_moment) {
	const double step = p_moment.time - _last;
	if (!_has_last || step <= 0.0 || step > MOMENT_GAP_S) {
		_bumps[0].runs = false;
		_bumps[1].runs = false;
	}
	_last = p_moment.time;
	_has_last = true;
	for (Bump &bump : _bumps) {
		if (bump.runs) {
			_gather(bump, p_moment, step);
			if (p_moment.time - bump.begin >= SPAN_S) {
				_end(bump);
			}
		}
	}
	if (!_bumps[0].runs) {
		_begin(_bumps[0], p_moment);
	}
	if (!_bumps[1].runs && p_moment.time - _bumps[0].begin >= SPAN_S / 2.0) {
		_begin(_bumps[1], p_moment);
	}
}

void JointMotion::_begin(Bump &r_bump, const Moment &p_moment) {
	r_bump = Bump();
	r_bump.begin = p_moment.time;
	r_bump.runs = true;
	for (std::size_t mount = 0; mount < MOUNTS; mount++) {
		Sum &sum = r_bump.sums[mount];
		sum.is_whole = p_moment.present[mount];
		for (std::size_t axis = 0; sum.is_whole && axis < 3; axis++) {
			sum.begin[axis] = p_moment.rotations[mount].rotate(AXES[axis]);
		}
	}
}

void JointMotion::_gather(Bump &r_bump, const Moment &p_moment, double p_step) {
	// sin⁴ of half the phase with an area of 1, and its second derivative. Both it and its first one are
	// zero at either end.
	const double phase = 2.0 * PI * std::min((p_moment.time - r_bump.begin) / SPAN_S, 1.0);
	const double pace = 2.0 * PI / SPAN_S;
	const double share = p_step / SPAN_S;
	const float weight = float(share * (1.0 - (4.0 * std::cos(phase) - std::cos(2.0 * phase)) / 3.0));
	const float bend = float(share * pace * pace * 4.0 / 3.0 * (std::cos(phase) - std::cos(2.0 * phase)));
	for (std::size_t mount = 0; mount < MOUNTS; mount++) {
		Sum &sum = r_bump.sums[mount];
		const kinematics::Vec3 &felt = p_moment.accelerations[mount];
		const kinematics::Vec3 moved = felt - kinematics::Vec3{ 0.0f, float(GRAVITY), 0.0f };
		sum.is_whole = sum.is_whole && p_moment.present[mount] && felt.length() > MEASURED && moved.length() < KNOCK;
		if (!sum.is_whole) {
			continue;
		}
		sum.side.sensor = sum.side.sensor + moved * weight;
		for (std::size_t axis = 0; axis < 3; axis++) {
			// From where it began: what does not turn must add up to nothing, however samples are spaced.
			const kinematics::Vec3 turned = p_moment.rotations[mount].rotate(AXES[axis]) - sum.begin[axis];
			sum.side.levers[axis] = sum.side.levers[axis] + turned * bend;
		}
	}
}

void JointMotion::_end(Bump &r_bump) {
	r_bump.runs = false;
	for (std::size_t mount = 0; mount < MOUNTS; mount++) {
		Sum &sum = r_bump.sums[mount];
		if (sum.is_whole) {
			sum.side.sensor = sum.side.sensor - _biases[mount];
			_biases[mount] = _biases[mount] + sum.side.sensor.limited(LEARN_BIAS_FROM) * LEARN_BIAS;
		}
	}
	for (int mount = 1; mount < MOUNTS; mount++) {
		const Sum &own = r_bump.sums[std::size_t(mount)];
		const Sum &above = r_bump.sums[std::size_t(PARENTS[std::size_t(mount)])];
		if (_known[std::size_t(mount)] && own.is_whole && above.is_whole) {
			_look(mount, above.side, own.side);
		}
	}
}

void JointMotion::_look(int p_mount, const Side &p_above, const Side &p_own) {
	const Levers &levers = _levers[std::size_t(p_mount)];
	// Mean square of a direction that is level, of both sides.
	const double strength = 0.5 * (level_squared(p_above.joint(levers.above)) + level_squared(p_own.joint(levers.own)));
	const double variance = 2.0 * OFF * OFF + SOFT * SOFT * strength;
	if (strength > STRONGER * variance) {
		_sights.push_back({ p_mount, p_above, p_own, variance });
	}
}

} // namespace heading
