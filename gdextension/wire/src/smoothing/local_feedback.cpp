// SPDX-License-Identifier: MIT
#include "local_feedback.hpp"

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
constexpr float SPRING = 45.0f; // 1/s
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
	skeleton = p_skeleton;
	count = std::size_t(p_skeleton.limb_count);
	return true;
}

void LocalFeedback::clear() {
	local_count = 0;
	has_truth = false;
	has_news = false;
	is_shown = false;
	wanted = LimbShift();
	shown = LimbShift();
	speed = LimbShift();
}

bool LocalFeedback::read(const PersonPose &p_pose, Limbs &r_frame) const {
	// NaN fails too.
	if (count == 0 || !(p_pose.root.length() <= FARTHEST)) {
		return false;
	}
	r_frame.position = p_pose.root;
	for (std::size_t i = 0; i < count; i++) {
		const Quat &turn = p_pose.orientations[i];
		const float square = turn.dot(turn);
		if (!(square > 0.25f && square < 4.0f)) {
			return false;
		}
		r_frame.turns[i] = turn.normalized();
	}
	return true;
}

bool LocalFeedback::push_local(double p_moment_s, const PersonPose &p_pose) {
	Limbs frame;
	if (!std::isfinite(p_moment_s) || !read(p_pose, frame)) {
		return false;
	}
	if (local_count > 0 && p_moment_s <= newest_moment()) {
		// A clock that was set back begins anew; a mere straggler does not.
		if (newest_moment() - p_moment_s < 1.0) {
			return false;
		}
		clear();
	}
	history[local_count % KEPT] = { p_moment_s, frame };
	local_count++;
	return true;
}

/// The wearer's pose at a moment and how fast it changes; false if that is not known.
bool LocalFeedback::local_at(double p_moment_s, Limbs &r_frame, LimbShift &r_speed) const {
	if (local_count == 0) {
		return false;
	}
	std::size_t after = local_count - 1;
	while (after > oldest() && local(after - 1).moment >= p_moment_s) {
		after--;
	}
	if (after == oldest()) {
		r_frame = local(after).frame;
		r_speed = LimbShift();
		return std::fabs(p_moment_s - local(after).moment) <= GUESS_S;
	}
	const Local &first = local(after - 1);
	const double span = local(after).moment - first.moment;
	const double ahead = std::min(p_moment_s - first.moment, span + std::min(GUESS_S, span));
	r_speed = between(first.frame, local(after).frame, float(1.0 / span), count);
	r_frame = first.frame;
	apply(r_frame, r_speed, float(ahead), count);
	return p_moment_s - local(after).moment <= MAX_STEP_S;
}

bool LocalFeedback::push_truth(double p_moment_s, const PersonPose &p_pose) {
	Limbs truth;
	Limbs then;
	LimbShift then_speed;
	if (!std::isfinite(p_moment_s) || !read(p_pose, truth) || (has_truth && p_moment_s <= truth_moment) ||
			!local_at(p_moment_s, then, then_speed)) {
		return false;
	}
	const LimbShift off = between(then, truth, 1.0f, count);
	if (!has_truth || (off.way - wanted.way).length() > JUMP) {
		shown.way = off.way;
		speed.way = Vec3();
	}
	wanted.way = off.way;
	for (std::size_t i = 0; i < count; i++) {
		note_turn(i, off.turns[i], then_speed.turns[i].length());
	}
	truth_moment = p_moment_s;
	has_truth = true;
	has_news = true;
	return true;
}

void LocalFeedback::note_turn(std::size_t p_limb, const Vec3 &p_deviation, float p_speed) {
	Vec3 deviation = p_deviation;
	const float angle = deviation.length();
	if (angle > 0.5f * PI && deviation.dot(shown.turns[p_limb]) < 0.0f) {
		// Beyond half a circle the short way is another one: go on the way that is shown.
		deviation = deviation * (1.0f - 2.0f * PI / angle);
	}
	wanted.turns[p_limb] = deviation * share(angle, SLACK + SLACK_TIME * p_speed);
}

/// Draws what is shown to what is wanted: a critically damped spring, solved exactly.
void LocalFeedback::filter(float p_step) {
	const float left = std::exp(-SPRING * p_step);
	LimbShift off = mix(shown, 1.0f, wanted, -1.0f, count);
	const LimbShift pull = mix(speed, 1.0f, off, SPRING, count);
	off = mix(off, left, pull, left * p_step, count);
	speed = mix(speed, left, pull, -left * p_step * SPRING, count);
	shown = mix(wanted, 1.0f, off, 1.0f, count);
}

bool LocalFeedback::show(double p_now_s, double p_moment_s) {
	Limbs frame;
	LimbShift unused;
	if (local_count == 0 || !std::isfinite(p_now_s) || !std::isfinite(p_moment_s)) {
		return false;
	}
	if (!local_at(p_moment_s, frame, unused)) {
		frame = local(local_count - 1).frame;
	}
	truth_at = has_news || !is_shown ? p_now_s : truth_at;
	has_news = false;
	if (p_now_s - truth_at > SILENCE_S) {
		wanted.turns.fill(Vec3());
	}
	const double step = is_shown ? std::min(std::max(p_now_s - shown_at, 0.0), MAX_STEP_S) : 0.0;
	filter(float(step));
	apply(frame, shown, 1.0f, count);
	pose.root = frame.position;
	pose.orientations = frame.turns;
	kinematics::place_limbs(skeleton, pose, positions);
	shown_at = p_now_s;
	is_shown = true;
	return true;
}

} // namespace wire
