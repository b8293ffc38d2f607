// SPDX-License-Identifier: MIT
#include "balance/balance.hpp"

#include "base/calm.hpp"

#include <algorithm>
#include <cmath>

namespace ragdoll {

namespace {

constexpr float AHEAD_S = 0.12f; // The ground is looked for where a foot will be,
constexpr float FURTHER_S = 0.1f; // and what its toes have to clear so much later.
constexpr float BALL_SHARE = 0.8f; // Points of a foot that are so far from the ankle, of the furthest, are its ball.
constexpr float SETTLE_FROM_S = 0.3f; // Who has stood for so long stands ...
constexpr float SETTLE_S = 0.4f; // ... more and more within this time.
constexpr float MIN_GRAVITY = 0.1f; // For the capture point, m/s^2: without gravity there is none.
constexpr float NONE = 1e9f;
constexpr float MIN_HEIGHT = 0.3f; // Of the centre of mass over the feet, m: somebody who lies.

} // namespace

Balance::Balance(const Rig &p_rig, const std::vector<ContactPoint> &p_contacts) :
		_contacts(p_contacts), _recovery(p_rig, p_contacts) {
	for (const Leg &leg : find_legs(p_rig, p_contacts)) {
		Foot foot;
		foot.limbs = leg;
		foot.ball = find_ball(leg.foot);
		_feet.push_back(foot);
	}
	_joints_now.resize(p_rig.size());
	_joints_next.resize(p_rig.size());
}

Vec3 Balance::find_ball(int p_foot) const {
	float reach = 0.0f;
	for (const ContactPoint &contact : _contacts) {
		reach = contact.limb == p_foot ? std::max(reach, contact.local.length()) : reach;
	}
	Vec3 sum;
	float count = 0.0f;
	for (const ContactPoint &contact : _contacts) {
		if (contact.limb == p_foot && contact.local.length() > BALL_SHARE * reach) {
			sum = sum + contact.local;
			count += 1.0f;
		}
	}
	return count > 0.0f ? sum * (1.0f / count) : sum;
}

void Balance::clear() {
	for (Foot &foot : _feet) {
		Foot anew;
		anew.limbs = foot.limbs;
		anew.ball = foot.ball;
		foot = anew;
	}
	rest();
	_recovery.clear();
	_offset = {};
	_knock.clear();
	_begun = false;
}

void Balance::rest() {
	_loose.clear();
	_force = {};
	_capture = {};
	_bearing = 1.0f;
	_eagerness = 1.0f;
	_ease = 0.0f;
	_calm_s = 0.0f;
	_stood_s = 0.0f;
	_ran_s = 1e9f;
}

bool Balance::is_stepping() const {
	return std::any_of(_feet.begin(), _feet.end(), [](const Foot &p_foot) { return p_foot.step_s >= 0.0f; });
}

void Balance::find_error(const Rig &p_rig, const BalanceInput &p_input, const Pose &p_now, const Pose &p_next) {
	const RigState &state = *p_input.state;
	const Vec3 centre = p_rig.centre_of_mass(state);
	const Vec3 velocity = p_rig.mean_velocity(state);
	const Vec3 wanted = p_rig.centre_of_mass(p_now, _joints_now);
	const Vec3 wanted_next = p_rig.centre_of_mass(p_next, _joints_next);
	if (!_begun) {
		_offset = centre - wanted;
		for (Foot &foot : _feet) {
			foot.hold.begin(_offset.y);
		}
		_begun = true;
	}
	_error = level(centre - wanted - _offset);
	_velocity_error = level(velocity - (wanted_next - wanted) * (1.0f / p_input.delta_s));
	_velocity = level(velocity);
	float lowest = centre.y;
	for (Foot &foot : _feet) {
		const std::size_t limb = std::size_t(foot.limbs.foot);
		foot.shown = p_rig.joint_of(state, limb);
		foot.wanted = _joints_now[limb];
	}
	for (const Vec3 &limb : state.centres) {
		lowest = std::min(lowest, limb.y);
	}
	_speed = velocity.length();
	_lean = angle_between(state.orientations[0], p_now.orientations[0]);
	const Vec3 turning = log(p_next.orientations[0] * p_now.orientations[0].inverse()) * (1.0f / p_input.delta_s);
	_spin = (turning - state.angular[0]).length();
	_height = centre.y - lowest;
	float wanted_lowest = wanted.y;
	for (std::size_t i = 0; i < p_rig.size(); i++) {
		wanted_lowest = std::min(wanted_lowest, _joints_now[i].y + p_now.orientations[i].rotate(p_rig[i].centre).y);
	}
	_wanted_height = wanted.y - wanted_lowest;
	const float height = std::max(_height, MIN_HEIGHT);
	_capture = _error + _velocity_error * std::sqrt(height / std::max(p_input.gravity, MIN_GRAVITY));
}

void Balance::carry(const Quat &p_turn) {
	_offset = p_turn.rotate(_offset);
	for (Foot &foot : _feet) {
		foot.offset = p_turn.rotate(foot.offset);
	}
}

void Balance::move_offset(const BalanceInput &p_input) {
	const float delta = p_input.delta_s;
	// Feet that slide take the motion's place along; a body that leans over its feet does not.
	Vec3 slid;
	float standing = 0.0f;
	const Foot *last = nullptr;
	for (const Foot &foot : _feet) {
		if (!foot.is_up()) {
			slid = slid + level(foot.shown - foot.wanted - _offset - foot.offset);
			standing += 1.0f;
		}
		last = foot.is_new && !foot.is_up() ? &foot : last;
	}
	if (standing > 0.0f) {
		slid = slid * (1.0f / standing);
		const float distance = slid.length();
		if (distance > settings.slack) {
			_offset = _offset + slid * (1.0f - settings.slack / distance);
		}
	}
	const float beyond = std::max(level(_offset).length() - settings.slack, 0.0f);
	const float back = std::min(settings.walk_back + settings.walk_back_faster * beyond, settings.walk_back_most);
	Vec3 moved;
	if (last != nullptr) {
		moved = level(last->offset).limited(settings.follow_step * delta);
	} else if (std::any_of(_feet.begin(), _feet.end(), [](const Foot &p_foot) { return p_foot.swings; })) {
		moved = level(_offset).limited(back * delta) * -1.0f;
	}
	_offset = _offset + moved;
	float floor = NONE;
	for (Foot &foot : _feet) {
		foot.offset = foot.offset - moved;
		floor = !foot.is_up() ? std::min(floor, foot.hold.find_rise(settings.foothold)) : floor;
	}
	if (floor < NONE) {
		_offset.y = towards(_offset.y, floor, settings.rise_speed * delta);
	}
}

void Balance::begin_steps() {
	// Nobody lifts a foot while the other one is in the air.
	const bool is_up = std::any_of(_feet.begin(), _feet.end(), [](const Foot &p_foot) { return p_foot.is_up(); });
	if (is_up || _feet.size() < 2 || _stood_s < settings.stand_s) {
		return;
	}
	const bool falls = _capture.length() > settings.step_from;
	const Vec3 wanted = falls ? _capture : Vec3();
	Foot *chosen = nullptr;
	float furthest = falls ? 0.5f * settings.step_from : settings.close_from;
	for (Foot &foot : _feet) {
		const float distance = level(wanted - foot.offset).length();
		if (distance > furthest) {
			furthest = distance;
			chosen = &foot;
		}
	}
	if (chosen != nullptr) {
		chosen->step_s = 0.0f;
		for (Foot &foot : _feet) {
			foot.is_new = &foot == chosen && falls;
		}
	}
}

float Balance::sole_height(const Pose &p_pose, const Foot &p_foot) const {
	float lowest = NONE;
	const std::size_t limb = std::size_t(p_foot.limbs.foot);
	for (const ContactPoint &contact : _contacts) {
		if (contact.limb == p_foot.limbs.foot) {
			const Vec3 point = _joints_now[limb] + p_pose.orientations[limb].rotate(contact.local);
			lowest = std::min(lowest, point.y - contact.radius);
		}
	}
	return lowest;
}

void Balance::move_foot(const BalanceInput &p_input, const Pose &p_now, Foot &r_foot) {
	const std::size_t limb = std::size_t(r_foot.limbs.foot);
	const float delta = p_input.delta_s;
	const Vec3 velocity = find_velocity(p_input, limb);
	r_foot.swings = velocity.length() > settings.swing_speed * (r_foot.swings ? 0.5f : 1.0f);
	r_foot.is_new = r_foot.is_new && !r_foot.swings;
	r_foot.lift = 0.0f;
	if (r_foot.step_s >= 0.0f) {
		r_foot.step_s += delta;
		const float part = r_foot.step_s / settings.step_s;
		r_foot.lift = settings.step_height * std::sin(PI * std::min(part, 1.0f));
		r_foot.step_s = part < 1.0f ? r_foot.step_s : -1.0f;
	}
	if (r_foot.is_up()) {
		const float distance = _capture.length();
		const float part = settings.swing_gain * std::max(1.0f - settings.swing_from / std::max(distance, 1e-6f), 0.0f);
		const bool catches = r_foot.step_s >= 0.0f && r_foot.is_new;
		const Vec3 wanted = (_capture * (catches ? 1.0f : part)).limited(settings.longest_step);
		const Vec3 off = level(wanted - r_foot.offset).limited(settings.foot_speed * delta);
		r_foot.offset = r_foot.offset + off;
	}
	follow_ground(p_input, p_now, level(velocity), r_foot);
	r_foot.offset = r_foot.offset.limited(settings.longest_step);
}

Vec3 Balance::find_velocity(const BalanceInput &p_input, std::size_t p_limb) const {
	const Vec3 before = p_input.turn.rotate(_joints_now[p_limb]) + p_input.shift;
	return (_joints_next[p_limb] - before) * (1.0f / p_input.delta_s);
}

std::size_t Balance::count_moving(const BalanceInput &p_input, float p_speed) const {
	return std::size_t(std::count_if(_feet.begin(), _feet.end(), [&](const Foot &p_foot) {
		return find_velocity(p_input, std::size_t(p_foot.limbs.foot)).length() > p_speed;
	}));
}

void Balance::follow_ground(const BalanceInput &p_input, const Pose &p_now, const Vec3 &p_velocity, Foot &r_foot) {
	if (p_input.ground == nullptr) {
		return;
	}
	const std::size_t limb = std::size_t(r_foot.limbs.foot);
	const Vec3 ball = p_now.orientations[limb].rotate(r_foot.ball);
	FootPlace place;
	place.ankle = _joints_now[limb] + _offset + r_foot.offset + p_velocity * AHEAD_S;
	// Wherever the motion is: the ground is under the body.
	place.ankle.y = std::clamp(place.ankle.y, r_foot.shown.y - Ground::STEP, r_foot.shown.y + Ground::STEP);
	place.ball = level(ball);
	place.further = p_velocity * FURTHER_S;
	place.sole = sole_height(p_now, r_foot);
	place.toes = _joints_now[limb].y + ball.y;
	place.body = _offset.y;
	place.is_up = r_foot.is_up();
	r_foot.hold.advance(*p_input.ground, settings.foothold, place, p_input.delta_s);
}

void Balance::find_sunk(const BalanceInput &p_input, const Pose &p_now) {
	const bool is_loose =
			std::any_of(_feet.begin(), _feet.end(), [](const Foot &p_foot) { return p_foot.hold.is_loose(); });
	const float lower = p_now.root.y + _offset.y - p_input.state->root.y;
	_loose.advance(settings.loose, is_loose, lower, p_input.delta_s);
	_sunk = std::clamp(lower - (_ran_s < settings.run_s ? 0.0f : settings.sunk_slack), 0.0f, settings.sunk_most);
}

Vec3 Balance::find_away(const Foot &p_foot) const {
	const float sunk = std::max(p_foot.is_up() ? _sunk : 0.0f, -_loose.get_sag());
	return p_foot.offset + Vec3{ 0.0f, p_foot.hold.get_height() - _offset.y + p_foot.lift + sunk, 0.0f };
}

void Balance::give_way(const Rig &p_rig, const RigState &p_state, Foot &r_foot) const {
	const std::size_t thigh = std::size_t(r_foot.limbs.thigh);
	const Vec3 is = r_foot.shown - p_rig.joint_of(p_state, thigh);
	const Vec3 meant = r_foot.wanted - _joints_now[thigh] + find_away(r_foot);
	r_foot.give = _loose.find_give(settings.loose, is, meant);
	if (settings.leg_push > 0.0f && !r_foot.is_up()) {
		const float longest = is.length() + settings.leg_push;
		r_foot.give = meant.length() > longest ? meant * (longest / meant.length() - 1.0f) : r_foot.give;
	}
}

void Balance::push(const Rig &p_rig, const BalanceInput &p_input) {
	const float weight = p_rig.get_mass() * p_input.gravity;
	const Vec3 wanted = (_error * settings.follow + _velocity_error) * (-settings.follow * p_rig.get_mass());
	_force_limit = settings.residual * weight;
	_force = (_force + (wanted - _force) * share(p_input.delta_s, settings.smooth_s)).limited(_force_limit);
	const float stood = std::clamp((_stood_s - SETTLE_FROM_S) / SETTLE_S, 0.0f, 1.0f);
	_torque = settings.torque + (settings.standing_torque - settings.torque) * stood;
	if (_knock.is_knocked()) {
		_torque = std::min(_torque, settings.knocked_torque);
	}
	_bearing = settings.bearing + (1.0f - settings.bearing) * stood;
	_eagerness = 1.0f + (settings.standing_eagerness - 1.0f) * stood;
	_calm_s = is_stepping() || _stood_s == 0.0f ? 0.0f : _calm_s + p_input.delta_s;
	_ease = std::clamp((_calm_s - SETTLE_FROM_S) / SETTLE_S, 0.0f, 1.0f);
	const float quiet = settings.quiet_torque + settings.quiet_stiffness * _lean;
	_torque = std::min(_torque, quiet + (1.0f - _ease) * settings.torque);
	find_deceleration(p_rig);
	const float hold = settings.hold_torque + settings.hold_stiffness * _lean + settings.hold_damping * _spin;
	_torque = std::min(_torque, hold + stood * settings.torque);
}

void Balance::find_deceleration(const Rig &p_rig) {
	const float lever = std::max(_height, MIN_HEIGHT);
	_deceleration = settings.braking * _torque / (p_rig.get_mass() * lever * lever);
}

void Balance::stay(const Rig &p_rig, const BalanceInput &p_input, Pose &r_now, Pose &r_next) {
	// Where it gets up is where the motion's position will be.
	_offset = p_input.state->root - r_now.root;
	r_now.root = r_now.root + _offset;
	r_next.root = r_next.root + _offset;
	for (Foot &foot : _feet) {
		foot.offset = {};
		foot.hold.begin(_offset.y);
		foot.step_s = -1.0f;
		foot.lift = 0.0f;
		foot.is_new = false;
	}
	const float stood = count_moving(p_input, settings.swing_speed) > 0 ? 0.0f : _stood_s + p_input.delta_s;
	rest();
	// Who gets up to stand is not held as if he walked.
	_stood_s = stood;
	_calm_s = stood;
	_torque = 0.0f; // What helps is no hold, see Recovery::get_help().
	find_deceleration(p_rig);
	_knock.rest(_velocity, _velocity_error);
}

void Balance::bend(const Rig &p_rig, Pose &r_pose, std::vector<Vec3> &r_joints) {
	r_pose.root = r_pose.root + _offset;
	for (Vec3 &joint : r_joints) {
		joint = joint + _offset;
	}
	for (const Foot &foot : _feet) {
		const Vec3 away = find_away(foot) + foot.give;
		if (away.length() > 1e-4f) {
			bend_leg(p_rig, foot.limbs, away, r_pose, r_joints);
		}
	}
}

void Balance::advance(const Rig &p_rig, const BalanceInput &p_input, Pose &r_now, Pose &r_next) {
	p_rig.joint_positions(r_now, _joints_now);
	p_rig.joint_positions(r_next, _joints_next);
	find_error(p_rig, p_input, r_now, r_next);
	const RecoveryInput recovery{ p_input.state, _height, _wanted_height, _speed, p_input.gravity, p_input.is_limp,
		p_input.delta_s };
	_recovery.advance(p_rig, recovery, r_now, r_next);
	if (_recovery.get_phase() != Recovery::Phase::NONE) {
		stay(p_rig, p_input, r_now, r_next);
		return;
	}
	find_sunk(p_input, r_now);
	move_offset(p_input);
	begin_steps();
	_stood_s += p_input.delta_s;
	_ran_s = count_moving(p_input, settings.run_speed) == _feet.size() ? 0.0f : _ran_s + p_input.delta_s;
	for (Foot &foot : _feet) {
		move_foot(p_input, r_now, foot);
		give_way(p_rig, *p_input.state, foot);
		_stood_s = foot.swings ? 0.0f : _stood_s;
	}
	_knock.advance(_velocity, _velocity_error, p_input.delta_s);
	push(p_rig, p_input);
	bend(p_rig, r_now, _joints_now);
	bend(p_rig, r_next, _joints_next);
	carry(p_input.turn);
}

void Balance::save(ArchiveWriter &p_archive) const {
	for (const Foot &foot : _feet) {
		Foot::for_each_saved(foot, [&](const auto &p_value) { p_archive.put(p_value); });
		foot.hold.save(p_archive);
	}
	p_archive.put(_offset);
	_loose.save(p_archive);
	p_archive.put(_force);
	p_archive.put(_stood_s);
	p_archive.put(_ran_s);
	p_archive.put(_calm_s);
	_knock.save(p_archive);
	p_archive.put(_begun);
	_recovery.save(p_archive);
}

bool Balance::restore(ArchiveReader &p_archive) {
	for (Foot &foot : _feet) {
		Foot::for_each_saved(foot, [&](auto &r_value) { p_archive.get(r_value); });
		foot.hold.restore(p_archive);
	}
	return p_archive.get(_offset) && _loose.restore(p_archive) && p_archive.get(_force) && p_archive.get(_stood_s) &&
			p_archive.get(_ran_s) && p_archive.get(_calm_s) && _knock.restore(p_archive) && p_archive.get(_begun) &&
			_recovery.restore(p_archive);
}

} // namespace ragdoll
