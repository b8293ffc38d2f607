// SPDX-License-Identifier: MIT
#include "balance/rise.hpp"

#include <algorithm>
#include <cmath>

namespace ragdoll {

namespace {

constexpr float ON_SIDE = 0.5f; // Level part of the direction between the hip joints of who does not lie on his side.
constexpr float FACE_UP_FROM = 0.2f; // Who lies on a side and looks up by so much (sine) turns onto the back.
constexpr float SITS_FROM = 0.7f; // Who sits or kneels has the hips upright (cosine).
constexpr std::size_t SITTING_STAGE = 2; // Where somebody who sits already begins among those who lie face up.
constexpr float DOWN = 0.2f; // Whose hips lean further (cosine) has fallen again.
constexpr float OVER_FEET = 0.18f; // A little more than half of a foot: who straightens up comes further, m.
constexpr float LOWEST_CENTRE = 0.3f; // Of the centre of mass over the feet, m.
constexpr float MIN_PULL = 0.1f; // m/s^2
constexpr float MAX_LEAN = 0.35f; // rad
// Poses are turned about their feet by so much at most, rad; not where the centre of mass is no higher over the feet
// than the first number, m, and all the way from the second one on: who lies is in no balance.
constexpr float MAX_TURN_BACK = 0.6f;
constexpr float LIES_BELOW = 0.2f;
constexpr float STANDS_FROM = 0.35f;
constexpr float HANDED_OVER = 0.25f; // In the last part of straightening up the pose comes to be the motion's own.
constexpr float LEAN_S = 0.1f; // How slowly the lean changes.
// The helping torque before its limit, N m/rad and N m s/rad: all of it from about 0.3 rad on. Not swept.
constexpr float STIFFNESS = 400.0f;
constexpr float DAMPING = 60.0f;
constexpr float HELPED_MORE = 1.5f; // Who does not get up is helped by so much more the next time ...
constexpr float MAX_HELPED = 4.0f; // ... and at most.
constexpr float MAX_TURN = 100.0f; // Of it about the vertical, N m.

} // namespace

float eased(float p_part) {
	return 0.5f - 0.5f * std::cos(PI * std::clamp(p_part, 0.0f, 1.0f));
}

Rise::Rise(const Rig &p_rig, const std::vector<Leg> &p_legs, const std::vector<std::size_t> &p_arms) :
		_anatomy(p_rig, p_legs, p_arms),
		_legs(p_legs),
		_start(p_rig.size()),
		_last(p_rig.size()),
		_wanted(p_rig.size()),
		_joints(p_rig.size()) {
	_flat.orientations.resize(p_rig.size());
	get_stages(_lie); // They are made here, not in a tick.
}

void Rise::begin(const Rig &p_rig, const RigState &p_state, bool p_again) {
	_help_scale = p_again ? std::min(_help_scale * HELPED_MORE, MAX_HELPED) : 1.0f;
	choose(p_rig, p_state);
}

void Rise::choose(const Rig &p_rig, const RigState &p_state) {
	const Quat &hips = p_state.orientations[0];
	const float face = _anatomy.get_ahead(hips).y;
	const float left = _anatomy.get_left(hips).y;
	_lie = face > 0.0f ? Lie::FACE_UP : Lie::FACE_DOWN;
	_stage = 0;
	if (_anatomy.get_up(hips).y > SITS_FROM) {
		const bool kneels = has_feet_behind(p_rig, p_state);
		_lie = kneels ? Lie::KNEELS : Lie::FACE_UP;
		_stage = kneels ? 0 : SITTING_STAGE;
	} else if (std::fabs(left) > std::fabs(face)) {
		_lie = face > FACE_UP_FROM ? (left > 0.0f ? Lie::RIGHT_BACK : Lie::LEFT_BACK)
								   : (left > 0.0f ? Lie::RIGHT_SIDE : Lie::LEFT_SIDE);
	}
	_is_done = !_anatomy.is_known();
	_has_failed = false;
	_lean = 0.0f;
	for (std::size_t i = 0; i < p_rig.size(); i++) {
		_last[i] =
				i == 0 ? hips : p_state.orientations[std::size_t(p_rig[i].parent)].inverse() * p_state.orientations[i];
	}
	start_stage(p_state);
}

bool Rise::has_feet_behind(const Rig &p_rig, const RigState &p_state) const {
	Vec3 shins;
	for (const Leg &leg : _legs) {
		shins = shins + p_rig.joint_of(p_state, std::size_t(leg.foot)) - p_rig.joint_of(p_state, std::size_t(leg.shin));
	}
	return shins.dot(_anatomy.get_ahead(p_state.orientations[0])) < 0.0f;
}

void Rise::start_stage(const RigState &p_state) {
	std::copy(_last.begin(), _last.end(), _start.begin());
	_start[0] = p_state.orientations[0];
	_time_s = 0.0f;
	find_heading(p_state);
}

void Rise::find_heading(const RigState &p_state) {
	const Quat &hips = p_state.orientations[0];
	const Vec3 left = level(_anatomy.get_left(hips));
	// Face up or down the face looks ahead once the hips are upright. On a side it will be where the head is, or
	// the legs of who turns onto the back.
	const bool to_back = _lie == Lie::LEFT_BACK || _lie == Lie::RIGHT_BACK;
	const Vec3 aside = level(_anatomy.get_up(hips)) * (to_back ? -1.0f : 1.0f);
	_heading = _anatomy.find_heading(left.length() < ON_SIDE ? aside : left.cross(UP));
}

void Rise::find_balance(const Rig &p_rig, const RigState &p_state, float p_gravity, float p_delta_s) {
	const Vec3 centre = p_rig.centre_of_mass(p_state);
	const Vec3 velocity = p_rig.mean_velocity(p_state);
	Vec3 feet;
	for (const Leg &leg : _legs) {
		feet = feet + p_state.centres[std::size_t(leg.foot)] * (1.0f / float(_legs.size()));
	}
	_began_ahead = _time_s == 0.0f ? (centre - feet).dot(_anatomy.get_view(_heading)) : _began_ahead;
	const float height = std::max(centre.y - feet.y, LOWEST_CENTRE);
	_ahead_of_feet = level(centre - feet + velocity * std::sqrt(height / std::max(p_gravity, MIN_PULL)));
	const float off = _ahead_of_feet.dot(_anatomy.get_view(_heading)) / height;
	const float wanted = std::clamp(off * get_stage().lean, -MAX_LEAN, MAX_LEAN);
	_lean += (wanted - _lean) * std::min(p_delta_s / LEAN_S, 1.0f);
}

void Rise::help(const RigState &p_state, const Pose &p_motion, float p_weight) {
	const RiseStage &stage = get_stage();
	const bool rises = stage.part == RisePart::RISING;
	const Quat wanted = rises ? p_motion.orientations[0] : _anatomy.get_hips(stage.pose, _heading);
	const Vec3 turn = log(wanted * p_state.orientations[0].inverse());
	_help = turn * STIFFNESS - p_state.angular[0] * DAMPING;
	if (stage.only_rolls) {
		const Vec3 along = _anatomy.get_up(p_state.orientations[0]);
		_help = along * along.dot(_help);
	}
	if (stage.lean > 0.0f) {
		// What keeps the capture point over the feet.
		const Vec3 upright = rises ? UP * std::clamp(_help.y, -MAX_TURN, MAX_TURN) : level(_help);
		_help = _ahead_of_feet.cross(UP) * p_weight + upright;
	}
	_help = _help.limited(get_most_help());
}

bool Rise::has_arrived(const RigState &p_state) const {
	const RiseStage &stage = get_stage();
	if (_time_s <= stage.blend_s) {
		return false;
	}
	const bool rises = stage.part == RisePart::RISING;
	const Quat hips = rises ? _motion_hips : _anatomy.get_hips(stage.pose, _heading);
	const float off = angle_between(hips, p_state.orientations[0]);
	const float ahead = _ahead_of_feet.dot(_anatomy.get_view(_heading));
	return (stage.within == 0.0f || off < stage.within) && (stage.lean == 0.0f || std::fabs(ahead) < OVER_FEET);
}

void Rise::advance(const Rig &p_rig, const RigState &p_state, const Pose &p_motion, float p_gravity, float p_delta_s) {
	_time_s += p_delta_s;
	_motion_hips = p_motion.orientations[0];
	if (_is_done) {
		return;
	}
	const bool is_last = _stage + 1 == get_stages(_lie).size();
	if (get_stage().part == RisePart::RISING) {
		_has_failed = _time_s > 0.5f * get_stage().blend_s && _anatomy.get_up(p_state.orientations[0]).y < DOWN;
		_is_done = _time_s > get_stage().blend_s;
	} else if (has_arrived(p_state) && !is_last) {
		_stage++;
		start_stage(p_state);
	} else if (has_arrived(p_state)) {
		choose(p_rig, p_state);
	} else if (_time_s > get_stage().most_s) {
		_help_scale = std::min(_help_scale * HELPED_MORE, MAX_HELPED);
		choose(p_rig, p_state);
	}
	find_balance(p_rig, p_state, p_gravity, p_delta_s);
	help(p_state, p_motion, p_rig.get_mass() * p_gravity);
}

void Rise::bend(const Rig &p_rig, float p_after, Pose &r_pose) {
	const RiseStage &stage = get_stage();
	const float share = eased((_time_s + p_after) / stage.blend_s);
	if (stage.part == RisePart::RISING) {
		std::copy(r_pose.orientations.begin(), r_pose.orientations.end(), _wanted.begin());
	} else {
		_anatomy.pose(stage.pose, _heading, _wanted);
	}
	// Joints bend, whatever the hips do.
	for (std::size_t i = 0; i < _wanted.size(); i++) {
		const std::size_t parent = std::size_t(std::max(p_rig[i].parent, 0));
		const Quat joint = i == 0 ? _wanted[0] : _wanted[parent].inverse() * _wanted[i];
		_last[i] = slerp(_start[i], joint, share);
		r_pose.orientations[i] = i == 0 ? _last[0] : r_pose.orientations[parent] * _last[i];
	}
	if (stage.part == RisePart::RISING) {
		balance(p_rig, share, r_pose);
	}
	if (stage.lean > 0.0f) {
		const Quat back = exp(_anatomy.get_view(_heading).cross(UP) * _lean);
		for (std::size_t i = 0; i < _wanted.size(); i++) {
			r_pose.orientations[i] = _anatomy.is_foot(i) ? r_pose.orientations[i] : back * r_pose.orientations[i];
		}
	}
}

void Rise::balance(const Rig &p_rig, float p_share, Pose &r_pose) {
	const Vec3 view = _anatomy.get_view(_heading);
	const Vec3 left = UP.cross(view);
	// How far the feet point down.
	Vec3 toes;
	for (const Leg &leg : _legs) {
		const std::size_t foot = std::size_t(leg.foot);
		toes = toes + _anatomy.get_toes(foot, r_pose.orientations[foot]);
	}
	const Quat level_feet = exp(left * std::atan2(toes.y, toes.dot(view)));
	for (std::size_t i = 0; i < p_rig.size(); i++) {
		_flat.orientations[i] = level_feet * r_pose.orientations[i];
	}
	p_rig.joint_positions(_flat, _joints);
	const float half = 1.0f / float(_legs.size());
	Vec3 feet;
	for (const Leg &leg : _legs) {
		const std::size_t foot = std::size_t(leg.foot);
		feet = feet + (_joints[foot] + _flat.orientations[foot].rotate(p_rig[foot].centre)) * half;
	}
	const Vec3 off = p_rig.centre_of_mass(_flat, _joints) - feet;
	const float wanted = _began_ahead * (1.0f - p_share);
	const float lean = std::atan2(off.dot(view) - wanted, std::max(off.y, LOWEST_CENTRE));
	const float stands = std::clamp((off.y - LIES_BELOW) / (STANDS_FROM - LIES_BELOW), 0.0f, 1.0f);
	const float share = stands * std::clamp((1.0f - p_share) / HANDED_OVER, 0.0f, 1.0f);
	const Quat back = exp(left * (share * -std::clamp(lean, -MAX_TURN_BACK, MAX_TURN_BACK)));
	for (std::size_t i = 0; i < p_rig.size(); i++) {
		const Quat flat = slerp(r_pose.orientations[i], _flat.orientations[i], share);
		r_pose.orientations[i] = _anatomy.is_foot(i) ? flat : back * flat;
	}
}

void Rise::save(ArchiveWriter &p_archive) const {
	p_archive.put(_lie);
	p_archive.put(std::uint32_t(_stage));
	p_archive.put(_time_s);
	p_archive.put(_heading);
	p_archive.put(_lean);
	p_archive.put(_began_ahead);
	p_archive.put(_help_scale);
	p_archive.put_all(_start);
	p_archive.put_all(_last);
}

bool Rise::restore(ArchiveReader &p_archive) {
	std::uint32_t stage = 0;
	if (!p_archive.get(_lie) || int(_lie) < 0 || int(_lie) >= LIE_COUNT || !p_archive.get(stage) ||
			stage >= get_stages(_lie).size()) {
		_lie = Lie::FACE_UP;
		_stage = 0;
		return false;
	}
	_stage = stage;
	_is_done = false;
	_has_failed = false;
	return p_archive.get(_time_s) && p_archive.get(_heading) && p_archive.get(_lean) && p_archive.get(_began_ahead) &&
			p_archive.get(_help_scale) && p_archive.get_all(_start) && p_archive.get_all(_last);
}

} // namespace ragdoll
