// SPDX-License-Identifier: MIT
#include "mover.hpp"

#include "directions.hpp"

#include <algorithm>
#include <cmath>

namespace mover {

namespace {

constexpr int SLIDES = 4;
constexpr float TOUCH = 0.02f; // m below the feet that still count as standing.
constexpr float AHEAD = 0.05f; // m that a step is tried ahead: less would not get over its edge.
constexpr float EDGE = 0.06f; // m that a foot is moved further onto an edge, to see what that is.
constexpr float REACH = 0.45f; // m ahead in which something can be climbed.
constexpr float LADDER_REACH = 0.12f; // m
constexpr float VAULT_S = 0.35f; // Duration of a vault, and what each metre of height adds.
constexpr float VAULT_S_PER_M = 0.45f;
constexpr float UP_SHARE = 0.7f; // Of a vault's duration, in which the feet rise.
constexpr float FASTEST_FALL = 60.0f; // m/s

} // namespace

void Mover::tick(State &r_state, const Wish &p_wish, float p_delta) const {
	_ride(r_state, p_delta);
	if (r_state.mode == Mode::BODY) {
		return;
	}
	const Vec3 wished = _wished_velocity(r_state, p_wish);
	if (std::isfinite(p_wish.heading) && r_state.mode == Mode::WALK) {
		const float turn = wrapped(p_wish.heading - r_state.heading);
		const float most = ability.turn_rate * p_delta;
		r_state.heading = wrapped(r_state.heading + std::clamp(turn, -most, most));
	}
	const bool begins_jump = p_wish.jumps && r_state.has_jumped == 0;
	r_state.has_jumped = p_wish.jumps ? 1 : 0;
	if (r_state.mode == Mode::VAULT) {
		_vault(r_state, p_delta);
	} else if (r_state.mode == Mode::LADDER) {
		if (begins_jump) {
			r_state.mode = Mode::WALK;
			r_state.velocity = r_state.normal * 1.5f;
		} else {
			_climb(r_state, wished, p_delta);
		}
	} else {
		_choose_stance(r_state, p_wish.stance);
		const Vec3 going = held(r_state, wished);
		const bool brakes = going.dot(r_state.velocity) < r_state.velocity.dot(r_state.velocity);
		const float on_ground = brakes ? ability.braking : ability.acceleration;
		const float rate = r_state.is_grounded != 0 ? on_ground : ability.air_acceleration;
		const Vec3 along = approached(level(r_state.velocity), going, rate * p_delta);
		r_state.velocity = { along.x, r_state.velocity.y, along.z };
		if (!begins_jump || r_state.is_grounded == 0 || !_begin_vault(r_state, REACH)) {
			if (begins_jump && r_state.is_grounded != 0 && r_state.stance == Stance::STAND) {
				r_state.velocity.y = ability.jump;
				r_state.is_grounded = 0;
			}
			if (r_state.is_grounded != 0) {
				r_state.velocity.y = 0.0f;
				_walk(r_state, wished, p_delta);
			} else {
				_fly(r_state, p_delta);
			}
		}
	}
	const float most = ability.climb * p_delta;
	r_state.lift -= std::clamp(r_state.lift, -most, most);
	// What pushes a walker out of itself comes to sums that differ in the last bits, by the order in which an engine
	// lists it.
	r_state.position = rounded(r_state.position);
	r_state.velocity = rounded(r_state.velocity);
	Frame frame;
	if (r_state.carrier != 0 && _surroundings.find_frame(r_state.carrier, frame)) {
		r_state.local = frame.turn.inverse().rotate(r_state.position - frame.origin);
		r_state.local_heading = wrapped(r_state.heading - facing_of(frame.turn));
	}
}

Vec3 Mover::held(const State &p_state, const Vec3 &p_wish) {
	const float hold = p_state.hold.length();
	if (!(hold > LEAST)) {
		return p_wish;
	}
	const Vec3 towards = p_state.hold * (1.0f / hold);
	return p_wish + towards * (std::max(-p_wish.dot(towards), 0.0f) * std::min(hold, 1.0f));
}

/// Goes where the carrier has gone since the last tick. Who has just lost it keeps its speed.
void Mover::_ride(State &r_state, float p_delta) const {
	Frame frame;
	if (r_state.carrier == 0) {
		return;
	}
	if (!_surroundings.find_frame(r_state.carrier, frame)) {
		r_state.carrier = 0;
		return;
	}
	const Vec3 carried = frame.origin + frame.turn.rotate(r_state.local);
	const Vec3 moved = carried - r_state.position;
	r_state.position = carried;
	r_state.heading = wrapped(r_state.local_heading + facing_of(frame.turn));
	r_state.from = r_state.from + moved;
	r_state.to = r_state.to + moved;
	if (r_state.is_grounded == 0 && r_state.mode == Mode::WALK) {
		r_state.velocity = r_state.velocity + moved * (1.0f / p_delta);
		r_state.carrier = 0;
	}
}

/// Gets lower at once, and higher only where there is room.
void Mover::_choose_stance(State &r_state, Stance p_wanted) const {
	if (p_wanted == r_state.stance || (r_state.is_grounded == 0 && p_wanted == Stance::PRONE)) {
		return;
	}
	if (p_wanted < r_state.stance) {
		Sweep sweep;
		const float missing = HEIGHTS[std::size_t(p_wanted)] - HEIGHTS[std::size_t(r_state.stance)];
		_surroundings.sweep(r_state.stance, r_state.position, UP * missing, sweep);
		if (sweep.is_stopped) {
			return;
		}
	}
	r_state.stance = p_wanted;
}

/// What is wished, as far as a person can: slower sideways and backwards, and in a low stance.
Vec3 Mover::_wished_velocity(const State &p_state, const Wish &p_wish) const {
	const Vec3 wished{ p_wish.x, 0.0f, p_wish.z };
	const float speed = wished.length();
	if (!std::isfinite(speed) || speed < LEAST) {
		return {};
	}
	const float ahead = wished.dot(facing(p_state.heading)) / speed;
	const float fastest = ability.speed[std::size_t(p_state.stance)];
	const float back = std::min(ability.speed_back * fastest, ability.most_back);
	const float most = back + (fastest - back) * std::clamp(ahead * 1.5f, 0.0f, 1.0f);
	return wished.limited(most * std::clamp(1.0f - std::fabs(p_state.lift) / ability.most_lift, 0.1f, 1.0f));
}

void Mover::_walk(State &r_state, const Vec3 &p_wish, float p_delta) const {
	const float before = r_state.position.y;
	const Vec3 motion = level(r_state.velocity) * p_delta;
	if (motion.length() > LEAST) {
		Sweep sweep;
		_surroundings.sweep(r_state.stance, r_state.position, motion, sweep);
		if (!sweep.is_stopped) {
			r_state.position = r_state.position + sweep.travel;
		} else if (_takes_ladder(r_state, p_wish, sweep)) {
			return;
		} else if (wall_among(sweep, motion) == nullptr || !_step_up(r_state, motion)) {
			_slide(r_state, motion, p_delta);
		}
	}
	Sweep below;
	// Mostly the ground is right below: engines find what is near in fewer steps.
	_surroundings.sweep(r_state.stance, r_state.position, DOWN * TOUCH, below);
	if (!below.is_stopped) {
		_surroundings.sweep(r_state.stance, r_state.position, DOWN * ability.snap, below);
	}
	if (_finds_floor(r_state, below)) {
		r_state.position.y += below.travel.y;
		_stand_on(r_state, below);
	} else {
		r_state.is_grounded = 0;
	}
	r_state.lift += r_state.position.y - before;
}

void Mover::_fly(State &r_state, float p_delta) const {
	r_state.velocity.y = std::max(r_state.velocity.y - ability.gravity * p_delta, -FASTEST_FALL);
	_slide(r_state, r_state.velocity * p_delta, p_delta);
	if (r_state.velocity.y > LEAST) {
		return;
	}
	Sweep below;
	_surroundings.sweep(r_state.stance, r_state.position, DOWN * TOUCH, below);
	if (_finds_floor(r_state, below)) {
		r_state.velocity.y = 0.0f;
		_stand_on(r_state, below);
	}
}

/// Whether what stops a sweep downwards can be stood on. A foot whose rim is on the edge of a step meets it at a slant,
/// as it would a slope that is too steep; a little further in it finds the step level, and the slope as steep as
/// before.
bool Mover::_finds_floor(const State &p_state, Sweep &r_below) const {
	if (floor_among(r_below) != nullptr) {
		return true;
	}
	const Vec3 stopped = p_state.position + r_below.travel;
	for (int i = 0; i < r_below.count; i++) {
		const Contact contact = r_below.contacts[std::size_t(i)];
		if (contact.normal.y <= 0.05f) {
			continue;
		}
		Sweep sweep;
		_surroundings.sweep(p_state.stance, stopped + UP * EDGE, normalized(level(contact.normal)) * -EDGE, sweep);
		const Vec3 further = stopped + UP * EDGE + sweep.travel;
		_surroundings.sweep(p_state.stance, further, DOWN * (2.0f * EDGE), sweep);
		if (floor_among(sweep) != nullptr) {
			r_below.contacts = sweep.contacts;
			r_below.count = sweep.count;
			return true;
		}
	}
	return false;
}

bool Mover::_step_up(State &r_state, const Vec3 &p_motion) const {
	if (r_state.stance == Stance::PRONE) {
		return false;
	}
	Sweep sweep;
	const Vec3 raise = UP * ability.step;
	_surroundings.sweep(r_state.stance, r_state.position, raise, sweep);
	const Vec3 raised = r_state.position + sweep.travel;
	const Vec3 ahead = normalized(p_motion) * std::max(p_motion.length(), AHEAD);
	_surroundings.sweep(r_state.stance, raised, ahead, sweep);
	if (sweep.is_stopped && wall_among(sweep, ahead) != nullptr) {
		return false;
	}
	_surroundings.sweep(r_state.stance, raised + ahead, DOWN * ability.step, sweep);
	if (!_finds_floor(at_step(r_state, raised + ahead), sweep)) {
		return false;
	}
	// As far as it was to go, at the height of what is ahead.
	const float height = raised.y + sweep.travel.y;
	if (height < r_state.position.y - LEAST) {
		return false;
	}
	r_state.position = { raised.x + p_motion.x, height, raised.z + p_motion.z };
	return true;
}

void Mover::_slide(State &r_state, const Vec3 &p_motion, float p_delta) const {
	Vec3 left = p_motion;
	const Vec3 begin = r_state.position;
	for (int i = 0; i < SLIDES && left.length() > LEAST; i++) {
		Sweep sweep;
		_surroundings.sweep(r_state.stance, r_state.position, left, sweep);
		r_state.position = r_state.position + sweep.travel;
		if (!sweep.is_stopped) {
			break;
		}
		left = sweep.left;
		for (int c = 0; c < sweep.count; c++) {
			Vec3 normal = sweep.contacts[std::size_t(c)].normal;
			if (r_state.is_grounded != 0 && normal.y > FLOOR) {
				left = uphill(left, normal);
				continue;
			}
			if (r_state.is_grounded != 0) {
				normal = normalized(level(normal)); // Who walks is not lifted by a wall that leans.
			}
			if (left.dot(normal) < 0.0f) {
				left = slid(left, normal);
			}
			if (r_state.velocity.dot(normal) < 0.0f) {
				r_state.velocity = slid(r_state.velocity, normal);
			}
		}
		if (left.dot(p_motion) < 0.0f) {
			break; // Out of a corner, not back and forth in it.
		}
	}
	// What pushes out of what has come too near must throw nobody.
	const Vec3 moved = r_state.position - begin;
	r_state.velocity = r_state.velocity.limited(std::max(moved.length() / p_delta + 0.5f, ability.speed[0]));
}

/// Looks whether there is something ahead to get onto. Prefers standing on it; crouches where it is low above.
bool Mover::_begin_vault(State &r_state, float p_reach) const {
	Sweep sweep;
	const Vec3 ahead = facing(r_state.heading) * p_reach;
	_surroundings.sweep(r_state.stance, r_state.position + UP * TOUCH, ahead, sweep);
	if (!sweep.is_stopped || wall_among(sweep, ahead) == nullptr) {
		return false;
	}
	const Vec3 before = r_state.position;
	for (const Stance stance : { Stance::STAND, Stance::CROUCH }) {
		_surroundings.sweep(stance, before, UP * (ability.vault + 2.0f * TOUCH), sweep);
		const Vec3 above = before + sweep.travel;
		_surroundings.sweep(stance, above, ahead, sweep);
		const Vec3 over = above + sweep.travel;
		_surroundings.sweep(stance, over, DOWN * (over.y - before.y), sweep);
		const float height = over.y + sweep.travel.y - before.y;
		if (floor_among(sweep) == nullptr || height < 0.05f || height > ability.vault + TOUCH) {
			continue;
		}
		r_state.stance = std::max(stance, r_state.stance);
		r_state.mode = Mode::VAULT;
		r_state.time = 0.0f;
		r_state.from = before;
		r_state.to = { over.x, before.y + height, over.z };
		r_state.velocity = {};
		r_state.is_grounded = 0;
		return true;
	}
	return false;
}

void Mover::_vault(State &r_state, float p_delta) const {
	const float rise = r_state.to.y - r_state.from.y;
	const float duration = VAULT_S + VAULT_S_PER_M * rise;
	r_state.time += p_delta;
	const float share = std::min(r_state.time / duration, 1.0f);
	const float up = std::min(share / UP_SHARE, 1.0f);
	const float along = std::clamp((share - UP_SHARE) / (1.0f - UP_SHARE), 0.0f, 1.0f);
	Vec3 next = r_state.from + level(r_state.to - r_state.from) * along;
	next.y = r_state.from.y + (rise + TOUCH) * up * (2.0f - up);
	Sweep sweep;
	const Vec3 motion = next - r_state.position;
	_surroundings.sweep(r_state.stance, r_state.position, motion, sweep);
	r_state.position = r_state.position + sweep.travel;
	const bool is_blocked = sweep.is_stopped && sweep.left.length() > 0.1f;
	if (share < 1.0f && !is_blocked) {
		return;
	}
	r_state.mode = Mode::WALK;
	r_state.time = 0.0f;
	r_state.from = {};
	r_state.to = {};
	_surroundings.sweep(r_state.stance, r_state.position, DOWN * ability.snap, sweep);
	if (floor_among(sweep) != nullptr) {
		r_state.position.y += sweep.travel.y;
		_stand_on(r_state, sweep);
	}
}

/// Who walks against a ladder takes hold of it.
bool Mover::_takes_ladder(State &r_state, const Vec3 &p_wish, const Sweep &p_sweep) const {
	for (int i = 0; i < p_sweep.count; i++) {
		const Contact &contact = p_sweep.contacts[std::size_t(i)];
		const Vec3 out = normalized(level(contact.normal));
		if (contact.is_ladder && std::fabs(contact.normal.y) < 0.3f && out.dot(normalized(p_wish)) < -0.7f) {
			r_state.mode = Mode::LADDER;
			r_state.normal = out;
			r_state.carrier = contact.carrier;
			r_state.velocity = {};
			r_state.is_grounded = 0;
			r_state.heading = std::atan2(-out.x, -out.z);
			r_state.stance = Stance::STAND;
			return true;
		}
	}
	return false;
}

void Mover::_climb(State &r_state, const Vec3 &p_wish, float p_delta) const {
	const float in = -p_wish.dot(r_state.normal);
	const float speed = std::clamp(in, -1.0f, 1.0f) * ability.ladder_speed;
	Sweep sweep;
	_surroundings.sweep(r_state.stance, r_state.position, UP * (speed * p_delta), sweep);
	r_state.position = r_state.position + sweep.travel;
	r_state.velocity = UP * speed;
	if (speed < 0.0f && sweep.is_stopped && floor_among(sweep) != nullptr) {
		r_state.mode = Mode::WALK;
		r_state.velocity = {};
		_stand_on(r_state, sweep);
		return;
	}
	// Is there still a ladder before the feet?
	_surroundings.sweep(r_state.stance, r_state.position, r_state.normal * -(2.0f * LADDER_REACH), sweep);
	const bool holds = std::any_of(sweep.contacts.begin(), sweep.contacts.begin() + sweep.count,
			[](const Contact &p_contact) { return p_contact.is_ladder; });
	if (holds) {
		return;
	}
	r_state.mode = Mode::WALK;
	r_state.velocity = {};
	// At the top: onto what it leads to, whose edge is just below the feet.
	if (speed > 0.0f && !_begin_vault(r_state, REACH)) {
		r_state.velocity = r_state.normal * -1.5f + UP * 0.5f;
	}
}

void Mover::_stand_on(State &r_state, const Sweep &p_floor) const {
	const Contact *floor = floor_among(p_floor);
	r_state.is_grounded = 1;
	r_state.carrier = floor->carrier;
}

} // namespace mover
