// SPDX-License-Identifier: MIT
#include "root/held_root.hpp"

#include <algorithm>

namespace ragdoll {

bool HeldRoot::is_obstructed(const Rig &p_rig, const ActuationTable &p_table, const Obstacles *p_obstacles,
		const RigState &p_state, const Pose &p_now, const Pose &p_next, float p_delta_s) {
	_obstructed_s = std::max(_obstructed_s - p_delta_s, 0.0f);
	bool is_met = blocks_root(p_obstacles, p_state, p_next.root - p_state.root);
	p_rig.joint_positions(p_now, _joints);
	const Vec3 off = p_state.root - p_now.root;
	for (std::size_t i = 1; i < p_rig.size(); i++) {
		const bool is_strong = p_table.get_mode(i) != Actuation::LIMP && p_table.get_strength(i) > STRONG;
		is_met = is_met || (is_strong && (p_rig.joint_of(p_state, i) - _joints[i] - off).length() > HELD_BACK);
	}
	_obstructed_s = is_met ? OBSTRUCTED_S : _obstructed_s;
	return _obstructed_s > 0.0f;
}

void HeldRoot::place(const RigState &p_state, const Pose &p_now, const Pose &p_next, const Vec3 &p_lift,
		float p_delta_s, Quat &r_orientation, Vec3 &r_joint) {
	r_orientation = p_next.orientations[0];
	r_joint = p_next.root + p_lift;
	const Vec3 displacement = r_joint - p_state.root;
	const Vec3 turn = log(p_state.orientations[0].inverse() * p_next.orientations[0]);
	const float distance = displacement.length() - (p_next.root - p_now.root).length();
	const float angle = turn.length() - angle_between(p_now.orientations[0], p_next.orientations[0]);
	_is_coming = (_is_coming || !_was_held) && (distance > ARRIVED || angle > ARRIVED);
	if (_is_coming) {
		const float needed_s = std::max(std::max(distance / FETCH_SPEED, angle / FETCH_TURN), p_delta_s);
		const float part = std::min(1.0f, p_delta_s / needed_s);
		r_orientation = p_state.orientations[0] * exp(turn * part);
		r_joint = p_state.root + displacement * part;
	}
}

void HeldRoot::save(ArchiveWriter &p_archive) const {
	p_archive.put(_obstructed_s);
	p_archive.put(_was_held);
	p_archive.put(_is_coming);
}

bool HeldRoot::restore(ArchiveReader &p_archive) {
	return p_archive.get(_obstructed_s) && p_archive.get(_was_held) && p_archive.get(_is_coming);
}

} // namespace ragdoll
