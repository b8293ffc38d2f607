// SPDX-License-Identifier: MIT
#include "motion_cueing.hpp"

#include <algorithm>

namespace cueing {

void MotionCueing::set_limits(const std::array<AxisLimits, 3> &p_travel, const std::array<AxisLimits, 3> &p_attitude) {
	for (int axis = 0; axis < 3; axis++) {
		_travel[axis].limits = p_travel[axis];
		_attitude[axis].limits = p_attitude[axis];
	}
}

void MotionCueing::reset() {
	washout.reset();
	for (int axis = 0; axis < 3; axis++) {
		_travel[axis].reset();
		_attitude[axis].reset();
	}
	_pose = Pose();
	_motion = Motion();
	_progress = 0.0;
	_without_news = 1e9;
	_is_entering = false;
	_is_teleporting = false;
}

void MotionCueing::teleport() {
	_is_teleporting = true;
	_leave_time = ramps.teleport;
}

/// Begins and ends without speed.
double MotionCueing::gain() const {
	return _progress * _progress * (3.0 - 2.0 * _progress);
}

const Pose &MotionCueing::step(const Motion *p_motion, double p_seconds, double p_age) {
	_without_news += p_seconds;
	if (p_motion != nullptr && p_motion->is_finite()) {
		_without_news = p_age;
		// On the way to neutral the old motion goes on: its end would be felt as a jolt.
		if (!_is_teleporting && !_is_paused) {
			_motion = *p_motion;
		}
	}
	const bool is_away = _is_paused || _without_news > ramps.dead_man;
	if (is_away && _is_entering && !_is_teleporting) {
		_leave_time = ramps.leave;
	}
	_is_entering = !is_away && !_is_teleporting;
	const double time = _is_entering ? ramps.enter : _leave_time;
	const double change = time > 0.0 ? p_seconds / time : 1.0;
	_progress = std::clamp(_progress + (_is_entering ? change : -change), 0.0, 1.0);
	if (_progress <= 0.0) {
		washout.reset();
		_is_teleporting = false;
	} else {
		washout.step(_motion, p_seconds);
	}
	follow(p_seconds);
	return _pose;
}

void MotionCueing::follow(double p_seconds) {
	const Pose &wanted = washout.pose();
	const double part = gain();
	for (int axis = 0; axis < 3; axis++) {
		_travel[axis].step(wanted.position[axis] * part, p_seconds);
		_attitude[axis].step(wanted.attitude[axis] * part, p_seconds);
		_pose.position[axis] = _travel[axis].position();
		_pose.attitude[axis] = _attitude[axis].position();
	}
}

} // namespace cueing
