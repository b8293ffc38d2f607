// SPDX-License-Identifier: MIT
#include "balance/recovery.hpp"

#include <algorithm>
#include <cmath>

namespace ragdoll {

namespace {

constexpr float OPPOSITE = -0.8f; // Cosine.
constexpr float STILL = 0.3f; // A fall slower than this goes nowhere, m/s.

bool hangs_on(const Rig &p_rig, std::size_t p_limb, std::size_t p_above) {
	int limb = p_rig[p_limb].parent;
	while (limb > int(p_above)) {
		limb = p_rig[std::size_t(limb)].parent;
	}
	return limb == int(p_above);
}

} // namespace

Recovery::Recovery(const Rig &p_rig, const std::vector<ContactPoint> &p_contacts) :
		_legs(find_legs(p_rig, p_contacts)), _arms(find_arms(p_rig)), _start(p_rig.size()), _rise(p_rig, _legs, _arms) {
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

float Recovery::get_strength() const {
	return _phase == Phase::FALLING ? settings.fall_strength : is_rising() ? settings.rise_strength : 1.0f;
}

bool Recovery::has_fallen(const RigState &p_state, float p_height, float p_wanted_height, const Pose &p_now) const {
	// Who only looks elsewhere stands.
	const Vec3 up = p_now.orientations[0].inverse().rotate(Vec3{ 0.0f, 1.0f, 0.0f });
	const float angle = std::acos(std::clamp(p_state.orientations[0].rotate(up).y, -1.0f, 1.0f));
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

void Recovery::get_up(const Rig &p_rig, const RecoveryInput &p_input, const Pose &p_motion) {
	_rise.advance(p_rig, *p_input.state, p_motion, p_input.gravity, p_input.delta_s);
	if (_rise.has_failed()) {
		go(Phase::FALLING, *p_input.state);
	} else if (_rise.is_done()) {
		go(Phase::NONE, *p_input.state);
	} else {
		_phase = Phase(int(Phase::TUCKING) + int(_rise.get_stage().part));
	}
}

void Recovery::advance(const Rig &p_rig, const RecoveryInput &p_input, Pose &r_now, Pose &r_next) {
	const RigState &state = *p_input.state;
	_time_s += p_input.delta_s;
	if (_phase == Phase::NONE) {
		if (has_fallen(state, p_input.height, p_input.wanted_height, r_now)) {
			go(Phase::FALLING, state);
		}
	} else if (p_input.is_limp) {
		go(Phase::FALLING, state); // It lies, however long.
	} else if (_phase == Phase::FALLING) {
		const bool rests = p_input.speed < settings.rest_speed && _time_s > settings.rest_from_s;
		if (rests || _time_s > settings.rest_s) {
			_rise.begin(p_rig, state, _rise.has_failed());
			get_up(p_rig, p_input, r_now);
		}
	} else {
		get_up(p_rig, p_input, r_now);
	}
	if (_phase == Phase::FALLING) {
		protect(p_rig, state, _time_s, r_now);
		protect(p_rig, state, _time_s + p_input.delta_s, r_next);
	} else if (is_rising()) {
		_rise.bend(p_rig, 0.0f, r_now);
		_rise.bend(p_rig, p_input.delta_s, r_next);
	}
}

void Recovery::save(ArchiveWriter &p_archive) const {
	p_archive.put_all(_start);
	p_archive.put(_phase);
	p_archive.put(_time_s);
	_rise.save(p_archive);
}

bool Recovery::restore(ArchiveReader &p_archive) {
	return p_archive.get_all(_start) && p_archive.get(_phase) && int(_phase) >= 0 &&
			int(_phase) <= int(Phase::RISING) && p_archive.get(_time_s) && _rise.restore(p_archive);
}

} // namespace ragdoll
