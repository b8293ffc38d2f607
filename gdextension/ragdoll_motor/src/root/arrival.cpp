// SPDX-License-Identifier: MIT
#include "root/arrival.hpp"

#include "body/placement.hpp"

#include <algorithm>

namespace ragdoll {

Arrival::Arrival(std::size_t p_limb_count) : _limbs(p_limb_count), _joints(p_limb_count) {
	_placed.orientations.resize(p_limb_count);
	_placed_next.orientations.resize(p_limb_count);
}

void Arrival::begin() {
	_is_on = true;
	_time_s = 0.0f;
	_offset = {};
	_off = {};
	for (Limb &limb : _limbs) {
		limb.off = {};
		limb.is_held = false;
	}
}

void Arrival::note_stall(const Rig &p_rig, const RigState &p_state, const Pose &p_now) {
	for (std::size_t i = 1; i < _limbs.size(); i++) {
		const std::size_t parent = std::size_t(p_rig[i].parent);
		const Quat actual = p_state.orientations[parent].inverse() * p_state.orientations[i];
		const Quat wanted = p_now.orientations[parent].inverse() * p_now.orientations[i];
		_limbs[i].was_held = angle_between(actual, wanted) > HELD;
	}
}

void Arrival::begin_from(const Rig &p_rig, const RigState &p_state, const Pose &p_now, const Vec3 &p_offset,
		bool p_at_once, const ActuationTable &p_table, const Obstacles *p_obstacles) {
	begin();
	_offset = p_offset;
	_off = p_state.root - p_now.root - p_offset;
	const bool is_far = p_at_once || _off.length() > LONG_WAY;
	p_rig.joint_positions(p_now, _joints);
	for (std::size_t i = 0; i < _limbs.size(); i++) {
		Limb &limb = _limbs[i];
		limb.off = is_far ? Vec3() : log(p_now.orientations[i].inverse() * p_state.orientations[i]);
		const int parent = p_rig[i].parent;
		if (parent < 0) {
			continue;
		}
		limb.held = p_state.orientations[std::size_t(parent)].inverse() * p_state.orientations[i];
		const Vec3 to = _joints[i] + p_now.orientations[i].rotate(p_rig[i].centre) + p_offset;
		limb.is_held = p_table.get_mode(i) == Actuation::LIMP;
		// Soles are at the floor, and may be in it before the hips are where they will be.
		if (!limb.is_held && !p_rig.is_in_leg(i)) {
			limb.is_held = limb.was_held ||
					(_off.length() < LONG_WAY && p_obstacles != nullptr &&
							p_obstacles->is_between(p_state.centres[i], to));
		}
	}
	_off = is_far ? Vec3() : _off;
}

void Arrival::blend(const Rig &p_rig, const Pose &p_motion, float p_left, Pose &r_pose) const {
	r_pose.root = p_motion.root + _offset + _off * p_left;
	for (std::size_t i = 0; i < _limbs.size(); i++) {
		const Limb &limb = _limbs[i];
		r_pose.orientations[i] = limb.is_held ? r_pose.orientations[std::size_t(p_rig[i].parent)] * limb.held
											  : p_motion.orientations[i] * exp(limb.off * p_left);
	}
}

void Arrival::advance(
		const Rig &p_rig, const Pose &p_now, const Pose &p_next, bool p_may_end, float p_delta_s, RigState &r_state) {
	const float left = 1.0f - std::min(_time_s / DURATION_S, 1.0f);
	blend(p_rig, p_now, left, _placed);
	// With the motion's velocity alone: the rest of the way is not gone by force, so that nobody is struck.
	blend(p_rig, p_next, left, _placed_next);
	place_at_rest(p_rig, _placed, _joints, r_state);
	set_in_motion(p_rig, _placed, _placed_next, p_delta_s, _joints, r_state);
	_is_on = _time_s < DURATION_S || !p_may_end;
	_time_s += p_delta_s;
}

void Arrival::save(ArchiveWriter &p_archive) const {
	for (const Limb &limb : _limbs) {
		p_archive.put(limb.off);
		p_archive.put(limb.held);
		p_archive.put(limb.is_held);
		p_archive.put(limb.was_held);
	}
	p_archive.put(_offset);
	p_archive.put(_off);
	p_archive.put(_time_s);
	p_archive.put(_is_on);
}

bool Arrival::restore(ArchiveReader &p_archive) {
	for (Limb &limb : _limbs) {
		if (!p_archive.get(limb.off) || !p_archive.get(limb.held) || !p_archive.get(limb.is_held) ||
				!p_archive.get(limb.was_held)) {
			return false;
		}
	}
	return p_archive.get(_offset) && p_archive.get(_off) && p_archive.get(_time_s) && p_archive.get(_is_on) &&
			_offset.is_finite() && _off.is_finite();
}

} // namespace ragdoll
