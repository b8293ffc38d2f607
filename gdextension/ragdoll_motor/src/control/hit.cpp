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

float find_least_strength(
		const Rig &p_rig, const RigState &p_state, int p_limb, const Vec3 &p_impulse, const Vec3 &p_position) {
	const std::size_t limb = std::size_t(p_limb);
	if (p_rig[limb].max_torque <= 0.0f) {
		return 0.0f; // The root's joint is to the world.
	}
	// The energy that the blow gives the limb about its joint, which the torque takes on the way.
	const Vec3 spin = (p_position - p_rig.joint_of(p_state, limb)).cross(p_impulse);
	const Vec3 momentum = p_state.orientations[limb].inverse().rotate(spin);
	const Vec3 &inertia = p_rig.get_subtree_inertia(limb);
	const float energy = 0.5f *
			(momentum.x * momentum.x / inertia.x + momentum.y * momentum.y / inertia.y +
					momentum.z * momentum.z / inertia.z);
	return std::min(energy / (p_rig[limb].max_torque * MAX_BEND), 1.0f);
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

int give_way(const Rig &p_rig, const RigState &p_state, const Vec3 &p_impulse, const Vec3 &p_position, int p_group,
		float p_strength, float p_blend_s, ActuationTable &r_table) {
	const int limb = find_nearest_limb(p_rig, p_state, p_position, p_group);
	if (limb >= 0) {
		const float least = find_least_strength(p_rig, p_state, limb, p_impulse, p_position);
		flinch(p_rig, limb, std::clamp(p_strength, least, 1.0f), p_blend_s, r_table);
	}
	return limb;
}

} // namespace ragdoll
