// SPDX-License-Identifier: MIT
#include "control/hit.hpp"

#include <algorithm>

namespace ragdoll {

namespace {

/// Share of the loss of strength that a neighbouring group has.
constexpr float NEIGHBOUR = 0.5f;

float distance_to_line(const Vec3 &p_from, const Vec3 &p_along, const Vec3 &p_position) {
	const float square = p_along.dot(p_along);
	const float part = square > 0.0f ? std::clamp(p_along.dot(p_position - p_from) / square, 0.0f, 1.0f) : 0.0f;
	return (p_from + p_along * part - p_position).length();
}

bool are_neighbours(const Rig &p_rig, int p_group, int p_other) {
	for (std::size_t i = 1; i < p_rig.size(); i++) {
		const int own = p_rig[i].group;
		const int above = p_rig[std::size_t(p_rig[i].parent)].group;
		if ((own == p_group && above == p_other) || (own == p_other && above == p_group)) {
			return true;
		}
	}
	return false;
}

} // namespace

int find_nearest_limb(const Rig &p_rig, const RigState &p_state, const Vec3 &p_position, int p_group) {
	int nearest = -1;
	float least = 0.0f;
	for (std::size_t i = 0; i < p_rig.size(); i++) {
		if (p_group >= 0 && p_rig[i].group != p_group) {
			continue;
		}
		const Vec3 joint = p_rig.joint_of(p_state, i);
		const float distance = distance_to_line(joint, (p_state.centres[i] - joint) * 2.0f, p_position);
		if (nearest < 0 || distance < least) {
			nearest = int(i);
			least = distance;
		}
	}
	return nearest;
}

void flinch(const Rig &p_rig, int p_limb, float p_strength, float p_blend_s, ActuationTable &r_table) {
	const int group = p_rig[std::size_t(p_limb)].group;
	for (std::size_t i = 0; i < p_rig.size(); i++) {
		if (p_rig[i].group == group) {
			r_table.flinch(i, p_strength, p_blend_s);
		} else if (are_neighbours(p_rig, group, p_rig[i].group)) {
			r_table.flinch(i, 1.0f - NEIGHBOUR * (1.0f - p_strength), p_blend_s);
		}
	}
}

} // namespace ragdoll
