// SPDX-License-Identifier: MIT
#include "motion_matcher.hpp"

#include "made_poses.hpp"

#include <algorithm>
#include <cmath>

namespace matching {

namespace {

/// How often it is searched while nothing changes, s, and what counts as a change, m/s and rad.
constexpr float SEARCH_S = 0.15f;
constexpr float CHANGED_SPEED = 0.4f;
constexpr float CHANGED_HEADING = 0.5f;
/// How fast a mover gets to what it wishes, s.
constexpr float ANSWER_S = 0.1f;
/// Froude numbers (speed squared by gravity and the hips' height) from which on somebody runs, and below which he
/// walks again: people change over at 0.5 (Kram, Domingo, Ferris 1997), as legs of a length cannot walk faster.
constexpr float RUNS_FROM = 0.45f;
constexpr float WALKS_FROM = 0.3f;
constexpr float GRAVITY = 9.81f;
/// Slower than this a mover has no direction, m/s.
constexpr float SLOWEST = 0.1f;
constexpr float SLOWEST_RATE = 0.8f;
constexpr float FASTEST_RATE = 1.2f;
constexpr float MAX_STRIDE = 1.7f;
/// Who goes sideways takes so many more steps, as legs that cross trip over each other, and keeps his feet so far
/// apart, heights of the hips.
constexpr float MORE_STEPS_ACROSS = 0.5f;
constexpr float MIN_APART = 0.1f;
/// The hips turn by this share towards where the person goes, at most so far, rad.
constexpr float HIPS_SHARE = 0.45f;
constexpr float MAX_HIPS = 0.7f;
/// How far the hips are lowered at most for a foot that stands far away, heights of the hips, of who walks and of who
/// stands; and how fast, heights a second. A body that follows deeper and faster dips jumps up out of them.
constexpr float WALKING_DROP = 0.05f;
constexpr float STANDING_DROP = 0.2f;
constexpr float DROP_SPEED = 1.0f;
/// Lean for an acceleration, rad for each m/s², and its most, rad.
constexpr float LEAN = 0.022f;
constexpr float MAX_LEAN = 0.14f;

float horizontal(const Vec3 &p_vector) {
	return std::hypot(p_vector.x, p_vector.z);
}

/// Moves a share towards 0 or 1 within so many seconds.
float moved(float p_share, bool p_is_on, float p_delta, float p_seconds) {
	return std::clamp(p_share + (p_is_on ? p_delta : -p_delta) / p_seconds, 0.0f, 1.0f);
}

Pose blend_poses(const Pose &p_from, const Pose &p_to, float p_share) {
	Pose pose;
	pose.hips = blend(p_from.hips, p_to.hips, p_share);
	for (std::size_t side = 0; side < 2; side++) {
		pose.ankles[side] = blend(p_from.ankles[side], p_to.ankles[side], p_share);
	}
	for (std::size_t limb = 0; limb < LIMBS; limb++) {
		pose.limbs[limb] = blend(p_from.limbs[limb], p_to.limbs[limb], p_share);
	}
	return pose;
}

} // namespace

void MotionMatcher::set_motion_set(std::shared_ptr<const MotionSet> p_set) {
	_set = std::move(p_set);
	reset(_origin, _heading);
}

void MotionMatcher::change_motion_set(std::shared_ptr<const MotionSet> p_set) {
	if (_set == nullptr || p_set == nullptr) {
		set_motion_set(std::move(p_set));
		return;
	}
	if (!_enters) {
		_entering = _set->features_at({ _player.entry_index(), int(_player.frame()) });
		_enters = true;
	}
	_set = std::move(p_set);
	_player.reset(*_set);
}

void MotionMatcher::reset(const Vec3 &p_position, float p_heading) {
	MotionMatcher fresh;
	fresh._set = _set;
	fresh._body = _body;
	fresh._origin = p_position;
	fresh._heading = p_heading;
	fresh._searched_heading = p_heading;
	// Walkers that begin together do not all search in one tick.
	const float spread = std::sin(p_position.x * 12.9898f + p_position.z * 78.233f) * 43758.547f;
	fresh._until_search = (spread - std::floor(spread)) * SEARCH_S;
	*this = std::move(fresh);
	if (_set != nullptr) {
		_player.reset(*_set);
		Wish wish;
		wish.position = p_position;
		wish.heading = p_heading;
		wish.wished_heading = p_heading;
		advance(1.0f / RATE, wish);
	}
}

const char *MotionMatcher::clip_name() const {
	return _set == nullptr ? "" : _player.entry(*_set).clip.name.c_str();
}

Way MotionMatcher::_predict(const Wish &p_wish) const {
	Way way;
	const Quat back = turn_of(-p_wish.heading);
	Vec3 velocity = back.rotate(p_wish.velocity);
	Vec3 wished = back.rotate(p_wish.wished_velocity);
	if (_blocked_s > 0.25f) {
		// Who walks against a wall does not go on walking.
		wished = velocity;
	}
	const float turning = wrapped(p_wish.wished_heading - p_wish.heading);
	for (std::size_t i = 0; i < AHEAD.size(); i++) {
		// The speed goes to the wished one exponentially.
		const float late = ANSWER_S * (1.0f - std::exp(-AHEAD[i] / ANSWER_S));
		way.x[i] = (wished.x * AHEAD[i] + (velocity.x - wished.x) * late) / _body.hip_height;
		way.z[i] = (wished.z * AHEAD[i] + (velocity.z - wished.z) * late) / _body.hip_height;
		way.heading[i] = turning * (1.0f - std::exp(-AHEAD[i] / ANSWER_S));
	}
	return way;
}

bool MotionMatcher::_is_search_due(float p_delta, const Wish &p_wish) {
	const bool ran = _runs;
	_choose_gait(horizontal(p_wish.velocity));
	_until_search -= p_delta;
	const bool is_changed = ran != _runs || (p_wish.wished_velocity - _searched_velocity).length() > CHANGED_SPEED ||
			std::fabs(wrapped(p_wish.wished_heading - _searched_heading)) > CHANGED_HEADING ||
			p_wish.stance != _searched_stance;
	if (_until_search > 0.0f && !is_changed) {
		return false;
	}
	_until_search = SEARCH_S;
	_searched_velocity = p_wish.wished_velocity;
	_searched_heading = p_wish.wished_heading;
	_searched_stance = p_wish.stance;
	return true;
}

void MotionMatcher::_choose_gait(float p_speed) {
	const float froude = p_speed * p_speed / (GRAVITY * _body.hip_height);
	_runs = froude > (_runs ? WALKS_FROM : RUNS_FROM);
}

float MotionMatcher::_rate(const Wish &p_wish) const {
	const MotionSet::Entry &entry = _player.entry(*_set);
	if (entry.stands) {
		return 1.0f;
	}
	const float wished = _blocked_s > 0.25f ? 0.0f : horizontal(p_wish.wished_velocity);
	const float speed = std::max(horizontal(p_wish.velocity), 0.8f * wished);
	const Vec3 way = turn_of(-p_wish.heading).rotate(speed > SLOWEST ? p_wish.velocity : p_wish.wished_velocity);
	const float across =
			horizontal(way) > SLOWEST ? std::fabs(std::sin(std::atan2(way.x, way.z) - entry.travel)) : 0.0f;
	const float steps = 1.0f + MORE_STEPS_ACROSS * across;
	const float rate = std::sqrt(speed / (entry.speed * _body.hip_height));
	return std::clamp(rate, SLOWEST_RATE, FASTEST_RATE) * steps;
}

MotionMatcher::Warp MotionMatcher::_warp(const Wish &p_wish, const Player::Sample &p_sample) const {
	Warp warp;
	if (_player.entry(*_set).stands) {
		return warp;
	}
	const Vec3 velocity = turn_of(-p_wish.heading).rotate(p_wish.velocity);
	const Vec3 wished = turn_of(-p_wish.heading).rotate(p_wish.wished_velocity);
	const float speed = horizontal(velocity);
	const float own = std::hypot(p_sample.velocity_x, p_sample.velocity_z) * _body.hip_height;
	warp.stride = std::clamp(speed / std::max(own * _rate(p_wish), 0.1f), 0.0f, MAX_STRIDE);
	const Vec3 &going = speed > SLOWEST ? velocity : wished;
	if (horizontal(going) > SLOWEST) {
		warp.turn = wrapped(std::atan2(going.x, going.z) - std::atan2(p_sample.velocity_x, p_sample.velocity_z));
		warp.hips_turn = std::clamp(HIPS_SHARE * warp.turn, -MAX_HIPS, MAX_HIPS);
	}
	return warp;
}

Pose MotionMatcher::_changed(const Player::Sample &p_sample, const Warp &p_warp) const {
	const MotionSet::Entry &entry = _player.entry(*_set);
	const float size = _body.hip_height;
	const float across = std::fabs(std::sin(p_warp.turn));
	const float lift = 0.4f + 0.6f * std::min(p_warp.stride, 1.2f);
	const Quat turn = turn_of(p_warp.turn);
	const Quat hips_turn = turn_of(p_warp.hips_turn);
	Pose pose = p_sample.pose;
	pose.hips = pose.hips * size;
	for (std::size_t side = 0; side < 2; side++) {
		Vec3 rest = entry.rests[side];
		Vec3 apart = turn.rotate(p_sample.pose.ankles[side] - rest) * p_warp.stride;
		// Somebody who goes sideways stands wider.
		const float wide = 0.5f * MIN_APART + across * entry.reach * p_warp.stride;
		rest.x = std::copysign(std::max(std::fabs(rest.x), across * wide), rest.x);
		const float above = p_sample.pose.ankles[side].y - entry.clip.ankle_height;
		pose.ankles[side] = (rest + apart) * size;
		pose.ankles[side].y = _body.ankle_height + above * size * lift;
		Quat &foot = pose.limbs[foot_of(side)];
		const float flat = std::max(0.6f * across, 0.6f * (1.0f - std::min(p_warp.stride, 1.0f)));
		foot = hips_turn * blend(foot, turn_of(facing_of(foot)), flat);
		for (const std::size_t limb : { thigh_of(side), thigh_of(side) + 1 }) {
			pose.limbs[limb] = hips_turn * pose.limbs[limb];
		}
	}
	pose.limbs[HIPS] = hips_turn * pose.limbs[HIPS];
	pose.limbs[SPINE] = turn_of(0.5f * p_warp.hips_turn) * pose.limbs[SPINE];
	return pose;
}

void MotionMatcher::_lean(float p_delta, const Wish &p_wish, Pose &r_pose) {
	const Quat back = turn_of(-p_wish.heading);
	const Vec3 wanted = (p_wish.wished_velocity - p_wish.velocity) * 2.0f;
	const Vec3 had = (p_wish.velocity - _before) * (1.0f / p_delta);
	_acceleration.go(back.rotate((wanted + had * 0.5f).limited(7.0f)), p_delta, 0.05f);
	const Vec3 lean = Vec3{ _acceleration.value.z * LEAN, 0.0f, -_acceleration.value.x * LEAN }.limited(MAX_LEAN);
	const Quat whole = exp(lean);
	const Quat half = exp(lean * 0.5f);
	r_pose.limbs[HIPS] = exp(lean * 0.25f) * r_pose.limbs[HIPS];
	r_pose.limbs[SPINE] = half * r_pose.limbs[SPINE];
	for (std::size_t limb = CHEST; limb <= RIGHT_HAND; limb++) {
		r_pose.limbs[limb] = (limb == HEAD ? half : whole) * r_pose.limbs[limb];
	}
	// The head looks where the person is going to face.
	const float ahead = std::clamp(0.7f * wrapped(p_wish.wished_heading - p_wish.heading), -0.7f, 0.7f);
	_head.go({ ahead, 0.0f, 0.0f }, p_delta, 0.05f);
	r_pose.limbs[HEAD] = turn_of(_head.value.x) * r_pose.limbs[HEAD];
}

void MotionMatcher::_breathe(float p_delta, Pose &r_pose) {
	_time = std::fmod(_time + p_delta, 60.0f);
	if (!_player.entry(*_set).stands) {
		return;
	}
	const float breath = std::sin(_time * 2.0f * PI / 4.0f);
	const float sway = std::sin(_time * 2.0f * PI / 7.5f);
	r_pose.hips.x += 0.006f * sway;
	r_pose.limbs[CHEST] = exp({ 0.012f * breath, 0.0f, 0.008f * sway }) * r_pose.limbs[CHEST];
	r_pose.limbs[HEAD] = exp({ -0.008f * breath, 0.02f * sway, 0.0f }) * r_pose.limbs[HEAD];
}

Pose MotionMatcher::_made(const Wish &p_wish, const Pose &p_from, Stance p_stance) const {
	switch (p_stance) {
		case PRONE:
			return prone(_body, _travelled);
		case LADDER:
			return ladder(_body, p_wish.position.y);
		case VAULT:
			return vault(_body);
		default:
			return p_from;
	}
}

void MotionMatcher::_advance_stances(float p_delta, const Wish &p_wish) {
	const bool is_made = p_wish.stance >= PRONE && !_set->has(p_wish.stance);
	if (is_made) {
		_made_stance = p_wish.stance;
	}
	_made_share = moved(_made_share, is_made, p_delta, p_wish.stance == VAULT ? 0.15f : 0.35f);
	_crouch_share = moved(_crouch_share, p_wish.stance == CROUCH && !_set->has(CROUCH), p_delta, 0.3f);
	_air_share = moved(_air_share, !p_wish.is_grounded && p_wish.stance < PRONE, p_delta, 0.16f);
	if (p_wish.is_grounded && !_was_grounded) {
		_landing_speed = std::clamp(-0.3f * _before.y, 0.0f, 2.0f);
	}
	_was_grounded = p_wish.is_grounded;
	// Knees give way after a jump and come up again: a critically damped spring.
	const float pull = 2.0f * 0.69314718f / 0.09f;
	const float left = std::exp(-pull * p_delta);
	const float push = _landing_speed + pull * _landing;
	_landing = left * (_landing + push * p_delta);
	_landing_speed = left * (_landing_speed - push * pull * p_delta);
}

Pose MotionMatcher::_in_world(const Pose &p_pose) const {
	const Quat turn = turn_of(_heading);
	Pose pose;
	pose.hips = _origin + turn.rotate(p_pose.hips);
	for (std::size_t side = 0; side < 2; side++) {
		pose.ankles[side] = _origin + turn.rotate(p_pose.ankles[side]);
	}
	for (std::size_t limb = 0; limb < LIMBS; limb++) {
		pose.limbs[limb] = turn * p_pose.limbs[limb];
	}
	return pose;
}

float MotionMatcher::_most_drop() const {
	return (_player.entry(*_set).stands ? STANDING_DROP : WALKING_DROP) * _body.hip_height;
}

void MotionMatcher::_lower_hips(float p_delta, const std::array<Vec3, 2> &p_ankles, Pose &r_pose) {
	float needed = 0.0f;
	for (std::size_t side = 0; side < 2; side++) {
		const Vec3 joint = r_pose.hips + r_pose.limbs[HIPS].rotate(_body.hip_joints[side]);
		const float across = std::hypot(joint.x - p_ankles[side].x, joint.z - p_ankles[side].z);
		const float leg = 0.997f * _body.leg();
		const float height = std::sqrt(std::max(leg * leg - across * across, 0.1f * leg * leg));
		if (_footing.is_planted(side)) {
			needed = std::max(needed, joint.y - p_ankles[side].y - height);
		}
	}
	const float up = std::exp2(-p_delta / 0.08f);
	const float down = _drop + DROP_SPEED * _body.hip_height * p_delta;
	_drop = std::max(std::min(needed, std::min(_most_drop(), down)), _drop * up);
	r_pose.hips.y -= _drop;
}

void MotionMatcher::_put_on_feet(float p_delta, const Wish &p_wish, const Player::Sample &p_sample, Pose &r_pose) {
	Footing::Goals goals;
	goals.ball = _body.ball();
	goals.heel = _body.heel() - _body.ball();
	goals.leg = _body.leg() + _most_drop();
	goals.velocity = p_wish.velocity;
	goals.is_walking = !_player.entry(*_set).stands;
	goals.is_grounded = p_wish.is_grounded && _made_share <= 0.0f;
	for (std::size_t side = 0; side < 2; side++) {
		FootGoal &goal = goals.feet[side];
		goals.hip_joints[side] = r_pose.hips + r_pose.limbs[HIPS].rotate(_body.hip_joints[side]);
		goal.foot = r_pose.limbs[foot_of(side)];
		goal.ball = r_pose.ankles[side] + goal.foot.rotate(_body.ball());
		goal.ground = std::isfinite(p_wish.ground[side]) && p_wish.is_grounded ? p_wish.ground[side] : _origin.y;
		goal.ball.y += goal.ground - _origin.y;
		goal.stands = p_sample.stands[side] || !goals.is_walking;
	}
	_footing.advance(p_delta, _body.hip_height, goals);
	std::array<Vec3, 2> ankles{};
	for (std::size_t side = 0; side < 2; side++) {
		const FootGoal &goal = goals.feet[side];
		r_pose.limbs[foot_of(side)] = goal.foot;
		ankles[side] = goal.ball - goal.foot.rotate(_body.ball());
	}
	_lower_hips(p_delta, ankles, r_pose);
	for (std::size_t side = 0; side < 2; side++) {
		const Vec3 joint = r_pose.hips + r_pose.limbs[HIPS].rotate(_body.hip_joints[side]);
		const Vec3 front = goals.feet[side].foot.rotate({ 0.0f, 0.0f, 1.0f });
		r_pose.ankles[side] = reach(joint, ankles[side], _body.thigh, _body.shank, front, r_pose.limbs[thigh_of(side)],
				r_pose.limbs[thigh_of(side) + 1]);
	}
}

void MotionMatcher::_keep_above_ground(const Wish &p_wish, Pose &r_pose) const {
	float lowest = _origin.y;
	for (std::size_t side = 0; side < 2; side++) {
		r_pose.ankles[side] = ankle_of(_body, r_pose, side);
		for (const Vec3 &sole : { _body.ball(), _body.heel() }) {
			lowest = std::min(lowest, r_pose.ankles[side].y + r_pose.limbs[foot_of(side)].rotate(sole).y);
		}
	}
	if (p_wish.is_grounded) {
		r_pose.hips.y += _origin.y - lowest;
	}
}

void MotionMatcher::advance(float p_delta, const Wish &p_wish) {
	if (_set == nullptr || !p_wish.is_sound() || !(p_delta > 0.0f && p_delta < 1.0f)) {
		return;
	}
	const float speed = horizontal(p_wish.velocity);
	const bool is_blocked = speed < 0.3f * horizontal(p_wish.wished_velocity);
	_blocked_s = is_blocked ? _blocked_s + p_delta : 0.0f;
	// Stairs lift the mover in one tick.
	const float height = p_wish.is_grounded ? 1.0f - std::exp2(-p_delta / 0.05f) : 1.0f;
	const float rise = p_wish.position.y - _origin.y;
	_origin = { p_wish.position.x, std::fabs(rise) > 0.5f ? p_wish.position.y : _origin.y + rise * height,
		p_wish.position.z };
	_heading = p_wish.heading;
	_travelled += speed * p_delta;

	bool is_other = false;
	const bool goes_on = _player.advance(*_set, p_delta, _rate(p_wish));
	const bool is_due = _is_search_due(p_delta, p_wish);
	if (_enters) {
		_enters = false;
		is_other = true;
		_player.enter(*_set, _entering, _predict(p_wish), p_wish.stance, _runs);
	} else if (is_due || !goes_on) {
		_searches++;
		is_other = _player.search(*_set, _predict(p_wish), p_wish.stance, _runs);
	}
	const Player::Sample sample = _player.sample(*_set);
	const Warp warp = _warp(p_wish, sample);
	Pose pose = _changed(sample, warp);
	if (is_other) {
		_inertia.change(pose, _changed(_player.sample(*_set, p_delta), warp), p_delta);
	}
	_inertia.apply(p_delta, pose);
	_advance_stances(p_delta, p_wish);
	_breathe(p_delta, pose);
	_lean(p_delta, p_wish, pose);
	if (_crouch_share > 0.0f) {
		crouch(eased(_crouch_share), _body, pose);
	}
	pose.hips.y -= _landing;
	if (_air_share > 0.0f) {
		pose = blend_poses(pose, airborne(pose, _body, p_wish.velocity.y), eased(_air_share));
	}
	pose = _in_world(pose);
	_put_on_feet(p_delta, p_wish, sample, pose);
	if (_made_share > 0.0f) {
		pose = blend_poses(pose, _in_world(_made(p_wish, pose, _made_stance)), eased(_made_share));
		_keep_above_ground(p_wish, pose);
	}
	_before = p_wish.velocity;
	_pose = pose;
}

} // namespace matching
