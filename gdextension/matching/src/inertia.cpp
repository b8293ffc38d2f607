// SPDX-License-Identifier: MIT
#include "inertia.hpp"

namespace matching {

namespace {

/// Differences and their speeds beyond these are a jump of the person, not a motion to be kept.
constexpr float MAX_TURN = 2.5f;
constexpr float MAX_TURN_RATE = 12.0f;
constexpr float MAX_SPEED = 6.0f;

Vec3 place_of(const Pose &p_pose, std::size_t p_index) {
	return p_index == 0 ? p_pose.hips : p_pose.ankles[p_index - 1];
}

} // namespace

void Inertia::reset() {
	*this = Inertia();
}

void Inertia::change(const Pose &p_new, const Pose &p_next, float p_delta) {
	if (!_is_known) {
		return;
	}
	const float per_second = 1.0f / p_delta;
	for (std::size_t limb = 0; limb < LIMBS; limb++) {
		const Quat now = p_new.limbs[limb];
		const Vec3 old_rate = log(_last.limbs[limb] * _before.limbs[limb].inverse()) * per_second;
		const Vec3 new_rate = log(p_next.limbs[limb] * now.inverse()) * per_second;
		_limbs[limb].offset = log(_last.limbs[limb] * now.inverse()).limited(MAX_TURN);
		_limbs[limb].velocity = (old_rate - new_rate).limited(MAX_TURN_RATE);
	}
	for (std::size_t i = 0; i < _places.size(); i++) {
		const Vec3 old_speed = (place_of(_last, i) - place_of(_before, i)) * per_second;
		const Vec3 new_speed = (place_of(p_next, i) - place_of(p_new, i)) * per_second;
		_places[i].offset = place_of(_last, i) - place_of(p_new, i);
		_places[i].velocity = (old_speed - new_speed).limited(MAX_SPEED);
	}
}

void Inertia::apply(float p_delta, Pose &r_pose) {
	const Damping damping = Damping::of(HALFLIFE_S, p_delta);
	for (std::size_t limb = 0; limb < LIMBS; limb++) {
		_limbs[limb].advance(damping);
		r_pose.limbs[limb] = (exp(_limbs[limb].offset) * r_pose.limbs[limb]).normalized();
	}
	for (Decay &place : _places) {
		place.advance(damping);
	}
	r_pose.hips = r_pose.hips + _places[0].offset;
	r_pose.ankles[0] = r_pose.ankles[0] + _places[1].offset;
	r_pose.ankles[1] = r_pose.ankles[1] + _places[2].offset;
	_before = _is_known ? _last : r_pose;
	_last = r_pose;
	_is_known = true;
}

} // namespace matching
