// SPDX-License-Identifier: MIT
#include "footing.hpp"

#include <algorithm>
#include <cmath>

namespace matching {

namespace {

/// How long an own step and the change to the motion's step take, s.
constexpr float STEP_S = 0.26f;
constexpr float LIFT_S = 0.2f;
/// How far from the motion a foot may stand, m and rad, while standing and while walking.
constexpr float STANDING_APART = 0.1f;
constexpr float WALKING_APART = 0.24f;
constexpr float STANDING_TURN = 0.45f;
constexpr float WALKING_TURN = 0.7f;
/// So much farther and it steps though the other one is in the air.
constexpr float HURRY = 1.8f;
/// A foot that comes down goes no faster, m/s.
constexpr float LANDING_SPEED = 2.0f;
/// A foot that moves so fast along the ground, m/s, is so far above it, m.
constexpr float CLEAR_SPEED = 0.6f;
constexpr float CLEARANCE = 0.05f;
/// Lower than this a foot can land, m.
constexpr float LANDING_HEIGHT = 0.03f;

float apart(const Vec3 &p_a, const Vec3 &p_b) {
	return std::hypot(p_a.x - p_b.x, p_a.z - p_b.z);
}

} // namespace

void Footing::_lift(const FootGoal &p_goal, bool p_is_forced, Foot &r_foot) const {
	r_foot.offset = r_foot.place - p_goal.ball;
	r_foot.offset.y = 0.0f;
	r_foot.turn = wrapped(r_foot.heading - facing_of(p_goal.foot));
	r_foot.is_planted = false;
	r_foot.is_forced = p_is_forced;
	r_foot.time = 0.0f;
	r_foot.length = p_is_forced ? STEP_S : LIFT_S;
}

bool Footing::_is_out_of_reach(const Goals &p_goals, std::size_t p_side) const {
	const FootGoal &goal = p_goals.feet[p_side];
	const Foot &foot = _feet[p_side];
	Vec3 ankle =
			foot.place - turn_of(wrapped(foot.heading - facing_of(goal.foot))).rotate(goal.foot.rotate(p_goals.ball));
	ankle.y += goal.ground + foot.height - foot.place.y;
	return (ankle - p_goals.hip_joints[p_side]).length() > p_goals.leg;
}

bool Footing::_must_step(const Goals &p_goals, std::size_t p_side, float p_size) const {
	const Foot &foot = _feet[p_side];
	const FootGoal &goal = p_goals.feet[p_side];
	if (_is_out_of_reach(p_goals, p_side)) {
		return true;
	}
	const float far = apart(foot.place, goal.ball) / (p_size * (p_goals.is_walking ? WALKING_APART : STANDING_APART));
	const float turned = std::fabs(wrapped(foot.heading - facing_of(goal.foot))) /
			(p_goals.is_walking ? WALKING_TURN : STANDING_TURN);
	const float worst = std::max(far, turned);
	if (worst < 1.0f) {
		return false;
	}
	if (worst > HURRY) {
		return true;
	}
	// One after the other, the one that is farther off first.
	const Foot &other = _feet[1 - p_side];
	if (!other.is_planted) {
		return false;
	}
	const float other_far = apart(other.place, p_goals.feet[1 - p_side].ball);
	return apart(foot.place, goal.ball) >= other_far || p_side == 0;
}

void Footing::_swing(const Goals &p_goals, float p_delta, float p_size, std::size_t p_side, FootGoal &r_goal) {
	Foot &foot = _feet[p_side];
	foot.time += p_delta;
	const float share = std::min(foot.time / foot.length, 1.0f);
	const float left = 1.0f - eased(share);
	const FootGoal goal = r_goal;
	r_goal.ball = goal.ball + foot.offset * left;
	if (foot.is_forced) {
		// It lands where it is going to be wanted while it stands.
		r_goal.ball = r_goal.ball + p_goals.velocity * (0.5f * STEP_S * eased(share));
	}
	r_goal.foot = turn_of(foot.turn * left) * goal.foot;
	const float off = foot.offset.length() + 0.2f * std::fabs(foot.turn);
	const float clearance = std::min((foot.is_forced ? 0.03f : 0.0f) + 0.22f * off, 0.09f) * p_size;
	const float wanted = std::max(goal.ball.y - goal.ground, clearance * std::sin(PI * share));
	foot.height = std::max(wanted, foot.height - LANDING_SPEED * p_delta);
	const bool lands = foot.is_forced ? goal.ball.y - goal.ground < 2.0f * LANDING_HEIGHT : goal.stands;
	if (share >= 1.0f && lands && foot.height < LANDING_HEIGHT && p_goals.is_grounded) {
		foot.is_planted = true;
		foot.place = r_goal.ball;
		foot.heading = facing_of(r_goal.foot);
	}
	r_goal.ball.y = goal.ground + foot.height;
}

/// Keeps the sole above the ground, and clear of it while it moves: recorded feet pass it as near as they can.
void Footing::_clear(float p_delta, const Goals &p_goals, Foot &r_foot, FootGoal &r_goal) {
	const float speed = apart(r_goal.ball, r_foot.last) / p_delta;
	const float wanted = r_foot.is_planted ? 0.0f : CLEARANCE * eased(speed / CLEAR_SPEED);
	const float heel = r_goal.ball.y + r_goal.foot.rotate(p_goals.heel).y;
	// Who stands on his heel has the ball above the ground.
	r_goal.ball.y += std::max(r_goal.ground + wanted - std::min(heel, r_goal.ball.y), 0.0f);
	r_foot.last = r_goal.ball;
}

void Footing::advance(float p_delta, float p_size, Goals &r_goals) {
	const Goals goals = r_goals;
	for (std::size_t side = 0; side < 2; side++) {
		Foot &foot = _feet[side];
		FootGoal &goal = r_goals.feet[side];
		if (!foot.is_known) {
			foot.is_known = true;
			foot.is_planted = goal.stands && goals.is_grounded;
			foot.place = goal.ball;
			foot.last = goal.ball;
			foot.heading = facing_of(goal.foot);
			foot.length = LIFT_S;
			foot.time = LIFT_S;
			foot.height = std::max(goal.ball.y - goal.ground, 0.0f);
		}
		const bool is_late = goals.is_walking && (!goal.stands || _is_out_of_reach(goals, side));
		if (foot.is_planted && (!goals.is_grounded || is_late)) {
			_lift(goal, false, foot);
		} else if (foot.is_planted && _must_step(goals, side, p_size)) {
			_lift(goal, true, foot);
		}
		if (!foot.is_planted) {
			_swing(goals, p_delta, p_size, side, goal);
		}
		if (foot.is_planted) {
			foot.height = std::max(foot.height - LANDING_SPEED * p_delta, 0.0f);
			const float turn = wrapped(foot.heading - facing_of(goal.foot));
			goal.foot = turn_of(turn) * goal.foot;
			goal.ball = { foot.place.x, goal.ground + foot.height, foot.place.z };
		}
		_clear(p_delta, goals, foot, goal);
	}
}

} // namespace matching
