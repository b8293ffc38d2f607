// SPDX-License-Identifier: MIT
#include "smoothing/local_feedback.hpp"

#include <algorithm>
#include <cmath>

namespace wire {

namespace {

constexpr float PI = 3.14159265f;
// Deviations up to this come of following a motion and are not shown; beyond three times of it they are
// shown whole. At rest, and for each rad/s of the limb (bodies follow by some milliseconds late).
constexpr float SLACK = 0.009f; // rad
constexpr float SLACK_TIME = 0.015f; // s
// How fast deviations come and go (critically damped): 98 % within 0.13 s.
constexpr float FEEDBACK_SPRING = 45.0f; // 1/s
// Without word from the server limbs are shown as the wearer has them, s.
constexpr double SILENCE_S = 0.5;
// A root that is further off than before by this has been put elsewhere, m.
constexpr float JUMP = 1.0f;
// The wearer's pose may be guessed so far beyond the newest and the oldest that is known, s.
constexpr double GUESS_S = 0.02;
constexpr double MAX_STEP_S = 0.25;

float share(float p_angle, float p_slack) {
	const float part = std::min(std::max((p_angle - p_slack) / (2.0f * p_slack), 0.0f), 1.0f);
	return part * part * (3.0f - 2.0f * part);
}

} // namespace

bool LocalFeedback::set_skeleton(const kinematics::Skeleton &p_skeleton) {
	if (!p_skeleton.is_sound()) {
		return false;
	}
	clear();
	_skeleton = p_skeleton;
	_count = std::size_t(p_skeleton.limb_count);
	return true;
}

void LocalFeedback::clear() {
	_local_count = 0;
	_has_truth = false;
	_has_news = false;
	_is_shown = false;
	_wanted = LimbDelta();
	_shown = LimbDelta();
	_speed = LimbDelta();
}

bool LocalFeedback::_read(const PersonPose &p_pose, Limbs &r_frame) const {
	// NaN fails too.
	if (_count == 0 || !(p_pose.root.length() <= FARTHEST)) {
		return false;
	}
	r_frame.position = p_pose.root;
	for (std::size_t i = 0; i < _count; i++) {
		const Quat &turn = p_pose.orientations[i];
		const float square = turn.dot(turn);
		if (!(square > 0.25f && square < 4.0f)) {
			return false;
		}
		r_frame.turns[i] = turn.normalized();
	}
	return true;
}

void LocalFeedback::set_heading(float p_heading) {
	if (p_heading != _heading && std::isfinite(p_heading)) {
		clear();
		_heading = p_heading;
		_turn = kinematics::exp({ 0.0f, p_heading, 0.0f });
	}
}

bool LocalFeedback::push_local(double p_moment_s, const PersonPose &p_pose) {
	Limbs frame;
	if (!std::isfinite(p_moment_s) || !_read(p_pose, frame)) {
		return false;
	}
	if (_local_count > 0 && p_moment_s <= newest_moment()) {
		// A clock that was set back begins anew; a mere straggler does not.
		if (newest_moment() - p_moment_s < 1.0) {
			return false;
		}
		clear();
	}
	if (_heading != 0.0f) {
		frame.position = _turn.rotate(frame.position);
		for (std::size_t i = 0; i < _count; i++) {
			frame.turns[i] = _turn * frame.turns[i];
		}
	}
	_history[_local_count % KEPT] = { p_moment_s, frame };
	_local_count++;
	return true;
}

/// The wearer's pose at a moment and how fast it changes; false if that is not known.
bool LocalFeedback::_local_at(double p_moment_s, Limbs &r_frame, LimbDelta &r_speed) const {
	if (_local_count == 0) {
		return false;
	}
	std::size_t after = _local_count - 1;
	while (after > _oldest() && _local(after - 1).moment >= p_moment_s) {
		after--;
	}
	if (after == _oldest()) {
		r_frame = _local(after).frame;
		r_speed = LimbDelta();
		return std::fabs(p_moment_s - _local(after).moment) <= GUESS_S;
	}
	const Local &first = _local(after - 1);
	const double span = _local(after).moment - first.moment;
	const double ahead = std::min(p_moment_s - first.moment, span + std::min(GUESS_S, span));
	r_speed = between(first.frame, _local(after).frame, float(1.0 / span), _count);
	r_frame = first.frame;
	apply(r_frame, r_speed, float(ahead), _count);
	return p_moment_s - _local(after).moment <= MAX_STEP_S;
}

bool LocalFeedback::push_truth(double p_moment_s, const PersonPose &p_pose) {
	Limbs truth;
	Limbs then;
	LimbDelta then_speed;
	if (!std::isfinite(p_moment_s) || !_read(p_pose, truth) || (_has_truth && p_moment_s <= _truth_moment) ||
			!_local_at(p_moment_s, then, then_speed)) {
		return false;
	}
	const LimbDelta off = between(then, truth, 1.0f, _count);
	if (!_has_truth || (off.displacement - _wanted.displacement).length() > JUMP) {
		_shown.displacement = off.displacement;
		_speed.displacement = Vec3();
	}
	_wanted.displacement = off.displacement;
	for (std::size_t i = 0; i < _count; i++) {
		_note_turn(i, off.turns[i], then_speed.turns[i].length());
	}
	_truth_moment = p_moment_s;
	_has_truth = true;
	_has_news = true;
	return true;
}

void LocalFeedback::_note_turn(std::size_t p_limb, const Vec3 &p_deviation, float p_speed) {
	Vec3 deviation = p_deviation;
	const float angle = deviation.length();
	if (angle > 0.5f * PI && deviation.dot(_shown.turns[p_limb]) < 0.0f) {
		// Beyond half a circle the shortest turn is the other one: keep turning as displayed.
		deviation = deviation * (1.0f - 2.0f * PI / angle);
	}
	_wanted.turns[p_limb] = deviation * share(angle, SLACK + SLACK_TIME * p_speed);
}

/// Draws what is shown to what is wanted: a critically damped spring, solved exactly.
void LocalFeedback::_filter(float p_step) {
	const float left = std::exp(-FEEDBACK_SPRING * p_step);
	LimbDelta off = mix(_shown, 1.0f, _wanted, -1.0f, _count);
	const LimbDelta pull = mix(_speed, 1.0f, off, FEEDBACK_SPRING, _count);
	off = mix(off, left, pull, left * p_step, _count);
	_speed = mix(_speed, left, pull, -left * p_step * FEEDBACK_SPRING, _count);
	_shown = mix(_wanted, 1.0f, off, 1.0f, _count);
}

bool LocalFeedback::evaluate(double p_now_s, double p_moment_s) {
	Limbs frame;
	LimbDelta unused;
	if (_local_count == 0 || !std::isfinite(p_now_s) || !std::isfinite(p_moment_s)) {
		return false;
	}
	if (!_local_at(p_moment_s, frame, unused)) {
		frame = _local(_local_count - 1).frame;
	}
	_truth_at = _has_news || !_is_shown ? p_now_s : _truth_at;
	_has_news = false;
	if (p_now_s - _truth_at > SILENCE_S) {
		_wanted.turns.fill(Vec3());
	}
	const double step = _is_shown ? std::min(std::max(p_now_s - _shown_at, 0.0), MAX_STEP_S) : 0.0;
	_filter(float(step));
	apply(frame, _shown, 1.0f, _count);
	_pose.root = frame.position;
	_pose.orientations = frame.turns;
	kinematics::position_limbs(_skeleton, _pose, _positions);
	_shown_at = p_now_s;
	_is_shown = true;
	return true;
}

} // namespace wire
