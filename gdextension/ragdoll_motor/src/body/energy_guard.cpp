// SPDX-License-Identifier: MIT
#include "body/energy_guard.hpp"

#include <cmath>

namespace ragdoll {

namespace {

bool is_finite(const RigState &p_state) {
	for (std::size_t i = 0; i < p_state.orientations.size(); i++) {
		if (!p_state.orientations[i].is_finite() || !p_state.centres[i].is_finite() || !p_state.linear[i].is_finite() ||
				!p_state.angular[i].is_finite()) {
			return false;
		}
	}
	return true;
}

float energy_about(const Rig &p_rig, const RigState &p_state, const Vec3 &p_mean) {
	float twice = 0.0f;
	for (std::size_t i = 0; i < p_rig.size(); i++) {
		const Vec3 moving = p_state.linear[i] - p_mean;
		const Vec3 turning = p_state.orientations[i].inverse().rotate(p_state.angular[i]);
		const Vec3 &inertia = p_rig[i].inertia;
		twice += p_rig[i].mass * moving.dot(moving) + inertia.x * turning.x * turning.x +
				inertia.y * turning.y * turning.y + inertia.z * turning.z * turning.z;
	}
	return 0.5f * twice;
}

} // namespace

float EnergyGuard::internal_energy(const Rig &p_rig, const RigState &p_state) {
	return energy_about(p_rig, p_state, p_rig.mean_velocity(p_state));
}

std::uint32_t EnergyGuard::check(const Rig &p_rig, RigState &r_state) const {
	if (!is_finite(r_state)) {
		return GUARD_LOST;
	}
	std::uint32_t acted = GUARD_NOTHING;
	const Vec3 mean = p_rig.mean_velocity(r_state);
	const float speed = mean.length();
	const float energy = energy_about(p_rig, r_state, mean);
	const float most = max_energy * p_rig.get_mass();
	if (speed > max_speed || energy > most) {
		const Vec3 kept = speed > max_speed ? mean * (max_speed / speed) : mean;
		const float factor = energy > most ? std::sqrt(most / energy) : 1.0f;
		acted |= (speed > max_speed ? GUARD_SPEED : 0u) | (energy > most ? GUARD_ENERGY : 0u);
		for (std::size_t i = 0; i < p_rig.size(); i++) {
			r_state.linear[i] = kept + (r_state.linear[i] - mean) * factor;
			r_state.angular[i] = r_state.angular[i] * factor;
		}
	}
	for (std::size_t i = 0; i < p_rig.size(); i++) {
		const int parent = p_rig[i].parent;
		if (parent < 0) {
			continue;
		}
		const Vec3 above = p_rig.joint_of(r_state, parent) + r_state.orientations[parent].rotate(p_rig[i].anchor);
		const Vec3 gap = above - p_rig.joint_of(r_state, i);
		if (gap.dot(gap) > max_gap * max_gap) {
			r_state.centres[i] = r_state.centres[i] + gap;
			r_state.linear[i] = r_state.linear[parent];
			r_state.angular[i] = r_state.angular[parent];
			acted |= GUARD_GAP;
		}
	}
	return acted;
}

} // namespace ragdoll
