// SPDX-License-Identifier: MIT
#include "balance/recovery.hpp"

#include <algorithm>
#include <cmath>

namespace ragdoll {

namespace {

constexpr float GIVE_UP_S = 1.5f; // A phase that takes so much longer than planned begins anew.
constexpr float OVER_FEET = 0.5f; // Hips that lean less than this (rad) are over the feet.

constexpr float OPPOSITE = -0.8f; // Cosine.
constexpr float STILL = 0.3f; // A fall slower than this goes nowhere, m/s.

/// Limbs that hang beside others above the legs, and carry limbs themselves: arms, not the head.
std::vector<std::size_t> find_arms(const Rig &p_rig) {
	std::vector<int> hanging(p_rig.size(), 0);
	for (std::size_t i = 1; i < p_rig.size(); i++) {
		hanging[std::size_t(p_rig[i].parent)] += p_rig.is_in_leg(i) ? 0 : 1;
	}
	std::vector<std::size_t> arms;
	for (std::size_t i = 1; i < p_rig.size(); i++) {
		if (!p_rig.is_in_leg(i) && hanging[i] > 0 && hanging[std::size_t(p_rig[i].parent)] > 1) {
			arms.push_back(i);
		}
	}
	return arms;
}

bool hangs_on(const Rig &p_rig, std::size_t p_limb, std::size_t p_above) {
	int limb = p_rig[p_limb].parent;
	while (limb > int(p_above)) {
		limb = p_rig[std::size_t(limb)].parent;
	}
	return limb == int(p_above);
}

/// From 0 to 1, at rest at both ends.
float eased(float p_part) {
	const float part = std::clamp(p_part, 0.0f, 1.0f);
	return 0.5f - 0.5f * std::cos(PI * part);
}

} // namespace

Recovery::Recovery(const Rig &p_rig, const std::vector<ContactPoint> &p_contacts) :
		_legs(find_legs(p_rig, p_contacts)), _arms(find_arms(p_rig)), _start(p_rig.size()) {
	_crouch.orientations.resize(p_rig.size());
	if (_legs.size() != 2) {
		return;
	}
	const Segment &foot = p_rig[std::size_t(_legs[0].foot)];
	_left = p_rig[std::size_t(_legs[0].thigh)].anchor - p_rig[std::size_t(_legs[1].thigh)].anchor;
	_left = _left * (1.0f / std::max(_left.length(), 1e-6f));
	// Turned so that thighs lifted about it go where the feet point.
	const Vec3 ahead = p_rig[0].rest.rotate(_left).cross(Vec3{ 0.0f, 1.0f, 0.0f });
	if (ahead.dot(foot.rest.rotate(foot.centre)) < 0.0f) {
		_left = _left * -1.0f;
	}
}

void Recovery::go(Phase p_phase, const RigState &p_state) {
	_phase = p_phase;
	_time_s = 0.0f;
	std::copy(p_state.orientations.begin(), p_state.orientations.end(), _start.begin());
}

float Recovery::get_torque(float p_most) const {
	if (_phase == Phase::RISING) {
		return p_most;
	}
	return _phase == Phase::ROLLING ? std::min(settings.torque, p_most) : 0.0f;
}

bool Recovery::has_fallen(const RigState &p_state, float p_height, float p_wanted_height, const Pose &p_now) const {
	const float angle = angle_between(p_state.orientations[0], p_now.orientations[0]);
	return angle > settings.fall_angle ||
			(angle > 0.5f * settings.fall_angle && p_height < settings.fall_height * p_wanted_height);
}

void Recovery::crouch(const Rig &p_rig, const Pose &p_motion, float p_share, Pose &r_pose) const {
	r_pose.orientations = p_motion.orientations;
	if (_legs.size() != 2) {
		return;
	}
	const Vec3 left = p_motion.orientations[0].rotate(_left);
	const Quat trunk = exp(left * (settings.trunk_angle * p_share));
	for (std::size_t i = 0; i < p_rig.size(); i++) {
		if (!p_rig.is_in_leg(i)) {
			r_pose.orientations[i] = trunk * p_motion.orientations[i];
		}
	}
	const Quat hips = exp(left * (0.5f * settings.trunk_angle * p_share));
	r_pose.orientations[0] = hips * p_motion.orientations[0];
	const Quat thigh = exp(left * (-settings.thigh_angle * p_share));
	const Quat shin = exp(left * (settings.shin_angle * p_share));
	for (const Leg &leg : _legs) {
		r_pose.orientations[std::size_t(leg.thigh)] = thigh * p_motion.orientations[std::size_t(leg.thigh)];
		r_pose.orientations[std::size_t(leg.shin)] = shin * p_motion.orientations[std::size_t(leg.shin)];
	}
}

void Recovery::protect(const Rig &p_rig, const RigState &p_state, float p_time_s, Pose &r_pose) {
	crouch(p_rig, r_pose, settings.fall_crouch, _crouch);
	const Vec3 speed = level(p_state.linear[0]);
	const Vec3 ahead = speed.length() > STILL ? speed * (std::cos(settings.reach_down) / speed.length()) : Vec3();
	const Vec3 reach = ahead + Vec3{ 0.0f, -std::sin(settings.reach_down), 0.0f };
	// As the body lies in the air, not as the motion stands.
	const Quat turn = _crouch.orientations[0] * p_state.orientations[0].inverse();
	for (const std::size_t arm : _arms) {
		const Vec3 points = _crouch.orientations[arm].rotate(p_rig[arm].centre);
		const Vec3 wanted = turn.rotate(reach);
		// From where they point the other way they come down ahead: between opposites there is no shortest turn.
		const bool is_opposite = points.dot(wanted) < OPPOSITE * points.length() * wanted.length();
		const Quat ahead_first = is_opposite ? exp(_crouch.orientations[0].rotate(_left) * (0.5f * PI)) : Quat();
		const Quat raised = rotation_between(ahead_first.rotate(points), wanted) * ahead_first;
		for (std::size_t i = arm; i < p_rig.size(); i++) {
			if (i == arm || hangs_on(p_rig, i, arm)) {
				_crouch.orientations[i] = raised * _crouch.orientations[i];
			}
		}
	}
	const float share = eased(p_time_s / settings.protect_s);
	for (std::size_t i = 0; i < p_rig.size(); i++) {
		r_pose.orientations[i] = slerp(_start[i], _crouch.orientations[i], share);
	}
}

void Recovery::blend(const Rig &p_rig, float p_time_s, Pose &r_pose) {
	if (_phase == Phase::RISING) {
		const float share = 1.0f - eased(p_time_s / settings.rise_s);
		crouch(p_rig, r_pose, share, _crouch);
		r_pose.orientations = _crouch.orientations;
		return;
	}
	crouch(p_rig, r_pose, 1.0f, _crouch);
	const bool rolls = _phase == Phase::ROLLING;
	const float drawn = rolls ? 1.0f : eased(p_time_s / settings.tuck_s);
	const float rolled = rolls ? eased(p_time_s / settings.roll_s) : 0.0f;
	const Quat hips = slerp(_start[0], _crouch.orientations[0], rolled);
	const Quat turn = hips * _crouch.orientations[0].inverse();
	for (std::size_t i = 0; i < p_rig.size(); i++) {
		const Quat drawn_in = turn * _crouch.orientations[i];
		r_pose.orientations[i] = rolls ? drawn_in : slerp(_start[i], drawn_in, drawn);
	}
}

void Recovery::advance(const Rig &p_rig, const RigState &p_state, float p_height, float p_wanted_height, float p_speed,
		float p_delta_s, Pose &r_now, Pose &r_next) {
	_time_s += p_delta_s;
	switch (_phase) {
		case Phase::NONE:
			if (has_fallen(p_state, p_height, p_wanted_height, r_now)) {
				go(Phase::FALLING, p_state);
			}
			break;
		case Phase::FALLING:
			if ((p_speed < settings.rest_speed && _time_s > settings.rest_from_s) || _time_s > settings.rest_s) {
				go(Phase::TUCKING, p_state);
			}
			break;
		case Phase::TUCKING:
			if (_time_s > settings.tuck_s) {
				go(Phase::ROLLING, p_state);
			}
			break;
		case Phase::ROLLING:
			crouch(p_rig, r_now, 1.0f, _crouch);
			if (_time_s > settings.roll_s &&
					angle_between(p_state.orientations[0], _crouch.orientations[0]) < OVER_FEET) {
				go(Phase::RISING, p_state);
			} else if (_time_s > settings.roll_s + GIVE_UP_S) {
				go(Phase::TUCKING, p_state);
			}
			break;
		case Phase::RISING:
			crouch(p_rig, r_now, 1.0f - eased(_time_s / settings.rise_s), _crouch);
			if (angle_between(p_state.orientations[0], _crouch.orientations[0]) > settings.fall_angle) {
				go(Phase::FALLING, p_state);
			} else if (_time_s > settings.rise_s) {
				go(Phase::NONE, p_state);
			}
			break;
	}
	if (_phase == Phase::FALLING) {
		protect(p_rig, p_state, _time_s, r_now);
		protect(p_rig, p_state, _time_s + p_delta_s, r_next);
	} else if (_phase != Phase::NONE) {
		blend(p_rig, _time_s, r_now);
		blend(p_rig, _time_s + p_delta_s, r_next);
	}
}

void Recovery::save(ArchiveWriter &p_archive) const {
	p_archive.put_all(_start);
	p_archive.put(_phase);
	p_archive.put(_time_s);
}

bool Recovery::restore(ArchiveReader &p_archive) {
	return p_archive.get_all(_start) && p_archive.get(_phase) && int(_phase) >= 0 &&
			int(_phase) <= int(Phase::RISING) && p_archive.get(_time_s);
}

} // namespace ragdoll
