// SPDX-License-Identifier: MIT
#include "joint/muscles.hpp"

#include <algorithm>
#include <cmath>

namespace ragdoll {

float Muscles::get_torque(std::size_t p_limb, const Vec3 &p_forward, const Vec3 &p_missing, const Vec3 &p_inertia,
		float p_fast, float p_delta_s, float p_whole) {
	const Vec3 change = p_forward - _before[p_limb];
	_before[p_limb] = p_forward;
	const float speed = std::min(p_forward.length() / p_fast, 1.0f);
	const float hill = std::max(MIN, (1.0f - speed) / (1.0f + CURVE * speed));
	_left[p_limb] = std::min(hill, _left[p_limb] + RECOVERY * p_delta_s);
	// A motion that brakes needs torque too, but not of the muscles that push on where something holds
	// the limb up.
	const bool pushes = p_missing.dot(change) >= 0.0f;
	const float needed = pushes ? change.scaled(p_inertia).length() / p_delta_s : 0.0f;
	if (p_whole <= 0.0f) {
		return 0.0f;
	}
	const float share = std::min(1.0f, needed / p_whole + _left[p_limb]);
	float &given = _given[p_limb];
	given = share >= 1.0f || std::fabs(share - given) > DEAD_BAND ? share : given;
	return given * p_whole;
}

void Muscles::reset() {
	std::fill(_before.begin(), _before.end(), Vec3());
	std::fill(_left.begin(), _left.end(), 1.0f);
	std::fill(_given.begin(), _given.end(), 1.0f);
}

} // namespace ragdoll
