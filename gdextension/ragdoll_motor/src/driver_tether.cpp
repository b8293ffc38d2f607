// SPDX-License-Identifier: MIT
#include "driver.hpp"

#include <algorithm>

namespace ragdoll {

namespace {

// A jump that is shorter than this is not looked at, m: it cannot go through anything.
constexpr float SHORT_JUMP = 0.05f;
// HELD: a limb that is off by more than this (m) from where the hips have it is held back by something.
constexpr float HELD_BACK = 0.15f;
// By limbs of less strength nothing can be told.
constexpr float STRONG = 0.9f;
// HELD: for how long the root is pulled after it was obstructed, s.
constexpr float OBSTRUCTED_S = 0.3f;

} // namespace

void Driver::shift_root(const Vec3 &p_now, const Vec3 &p_next) {
	_now.root = _now.root + p_now;
	_next.root = _next.root + p_next;
}

bool Driver::hold_back(const RigState &p_state, bool p_begins, bool p_jumps, float p_delta_s) {
	// Where the travel is found, the motion's own root means nothing in the world.
	const bool is_stopped = p_jumps && !p_begins && !finds_travel(root_mode) && is_walled_off(p_state);
	if (p_begins || p_jumps || _travelled != root_mode || !is_tethered(root_mode)) {
		_tether.clear();
	}
	if (is_stopped && root_mode == RootMode::GROUNDED) {
		_balance.shift(level(_next_root - _now.root));
	} else if (is_stopped) {
		_tether.set(p_state.root - _now.root);
	} else if (!p_jumps && is_tethered(root_mode) && _travelled == root_mode && _table.get_mode(0) != Actuation::LIMP) {
		_tether.advance(p_state.root - _next_root, p_delta_s);
	}
	shift_root(_tether.get_now(), _tether.get_next());
	return p_jumps && !is_stopped;
}

bool Driver::is_walled_off(const RigState &p_state) const {
	const Vec3 motion = _now.root - p_state.root;
	return obstacles != nullptr && motion.is_finite() && motion.length() > SHORT_JUMP &&
			obstacles->is_in_way(0, p_state.orientations[0], p_state.centres[0], motion);
}

bool Driver::is_obstructed(const RigState &p_state, float p_delta_s) {
	_obstructed_s = std::max(_obstructed_s - p_delta_s, 0.0f);
	const Vec3 motion = _next.root - p_state.root;
	bool is_met = obstacles != nullptr && motion.is_finite() &&
			obstacles->is_in_way(0, p_state.orientations[0], p_state.centres[0], motion);
	_rig.joint_positions(_now, _joints);
	const Vec3 off = p_state.root - _now.root;
	for (std::size_t i = 1; i < _rig.size(); i++) {
		const bool is_strong = _table.get_mode(i) != Actuation::LIMP && _table.get_strength(i) > STRONG;
		is_met = is_met || (is_strong && (_rig.joint_of(p_state, i) - _joints[i] - off).length() > HELD_BACK);
	}
	_obstructed_s = is_met ? OBSTRUCTED_S : _obstructed_s;
	return _obstructed_s > 0.0f;
}

} // namespace ragdoll
