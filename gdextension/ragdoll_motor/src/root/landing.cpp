// SPDX-License-Identifier: MIT
#include "root/landing.hpp"

#include <algorithm>

namespace ragdoll {

namespace {

constexpr float NONE = 1e9f;

} // namespace

float Landing::find_way(const Rig &p_rig, const Obstacles &p_obstacles, const Vec3 &p_normal, const Vec3 &p_surface,
		float p_delta_s, const RigState &p_state) const {
	float least = NONE;
	for (std::size_t i = 0; i < p_rig.size(); i++) {
		const Vec3 way = (p_state.linear[i] - p_surface) * p_delta_s;
		const float into = -way.dot(p_normal);
		if (into <= 0.0f) {
			continue;
		}
		const Vec3 looked = way * ((into + THICKNESS) / into);
		Hit hit;
		if (p_obstacles.find_between(p_state.centres[i], p_state.centres[i] + looked, hit)) {
			least = std::min(least, std::max(hit.share * (into + THICKNESS) - THICKNESS, 0.0f));
		}
	}
	return least;
}

bool Landing::advance(const Rig &p_rig, const Obstacles *p_obstacles, const Vec3 &p_carried, float p_delta_s,
		RigState &r_state) const {
	const Vec3 centre = p_rig.centre_of_mass(r_state);
	const Vec3 way = p_rig.mean_velocity(r_state) * p_delta_s - p_carried;
	const float length = way.length();
	Hit hit;
	if (p_obstacles == nullptr || !(length > LONG_STEP) ||
			!p_obstacles->find_between(centre, centre + way * ((length + REACH) / length), hit)) {
		return false;
	}
	const float least = find_way(p_rig, *p_obstacles, hit.normal, hit.velocity, p_delta_s, r_state);
	const float fastest = std::max(least, SHORT_STEP) / p_delta_s;
	bool is_slowed = false;
	for (Vec3 &limb : r_state.linear) {
		const float into = (hit.velocity - limb).dot(hit.normal);
		if (into > fastest) {
			limb = limb + hit.normal * (into - fastest);
			is_slowed = true;
		}
	}
	return is_slowed;
}

} // namespace ragdoll
