// SPDX-License-Identifier: MIT
#include "root/surface_guard.hpp"

#include "body/leg.hpp"

#include <algorithm>
#include <cmath>

namespace ragdoll {

SurfaceGuard::SurfaceGuard(const Rig &p_rig) : _count(std::uint32_t(p_rig.size())), _moves(p_rig.size(), 0) {}

void SurfaceGuard::turn(const Rig &p_rig, std::size_t p_limb, const Quat &p_turn, RigState &r_state) {
	const Vec3 joint = p_rig.joint_of(r_state, p_limb);
	const Vec3 velocity = r_state.linear[std::size_t(p_rig[p_limb].parent)];
	std::fill(_moves.begin(), _moves.end(), std::uint8_t(0));
	for (std::size_t i = p_limb; i < p_rig.size(); i++) {
		const int parent = p_rig[i].parent;
		_moves[i] = std::uint8_t(i == p_limb || (parent >= 0 && _moves[std::size_t(parent)] != 0));
		if (_moves[i] != 0) {
			r_state.centres[i] = joint + p_turn.rotate(r_state.centres[i] - joint);
			r_state.orientations[i] = (p_turn * r_state.orientations[i]).normalized();
			r_state.linear[i] = velocity;
			r_state.angular[i] = {};
		}
	}
}

bool SurfaceGuard::advance(
		const Rig &p_rig, const ActuationTable &p_table, const Obstacles *p_obstacles, RigState &r_state) {
	if (p_obstacles == nullptr || _count < 2) {
		return false;
	}
	_limb = _limb + 1 < _count ? _limb + 1 : 1;
	const std::size_t limb = _limb;
	if (p_table.get_mode(limb) == Actuation::DIRECT_SET) {
		return false;
	}
	const Vec3 joint = p_rig.joint_of(r_state, limb);
	const Vec3 axis = (r_state.centres[limb] - joint) * LENGTH;
	const float length = axis.length();
	Hit hit;
	if (!(length > HEIGHT) || !p_obstacles->find_between(joint, joint + axis, hit)) {
		return false;
	}
	const Vec3 from = axis * (1.0f / length);
	const float into = from.dot(hit.normal);
	if (-into * (1.0f - hit.share) * length < DEEP) {
		return false;
	}
	Vec3 along = from - hit.normal * into;
	if (along.length() < 1e-3f) {
		// Straight into it: wherever the limb's own side points.
		const Vec3 side = r_state.orientations[limb].rotate({ 1.0f, 0.0f, 0.0f });
		along = side - hit.normal * side.dot(hit.normal);
	}
	if (along.length() < 1e-3f) {
		return false;
	}
	const float over = -into * hit.share * length; // The joint over the surface, m.
	const float up = std::clamp((HEIGHT - over) / length, -1.0f, 1.0f);
	const Vec3 to = along * (std::sqrt(1.0f - up * up) / along.length()) + hit.normal * up;
	turn(p_rig, limb, rotation_between(from, to), r_state);
	return true;
}

} // namespace ragdoll
