// SPDX-License-Identifier: MIT
#include "rim.hpp"

#include <algorithm>
#include <cmath>

namespace vehicle {

namespace {

constexpr int ITERATIONS = 12;

/// Force along on the hull if the rim had a speed.
float along(const Patch &p_patch, float p_rim, float p_delta) {
	const float slip = p_patch.speed_along - p_rim;
	const float most = p_patch.grip_along * p_patch.load;
	return std::clamp(
			-(p_patch.stiffness * (p_patch.bend_along + slip * p_delta) + p_patch.damping * slip), -most, most);
}

void finish(Patch &r_patch, float p_rim, float p_delta) {
	if (r_patch.load <= 0.0f) {
		r_patch.bend_along = r_patch.bend_across = r_patch.force_along = r_patch.force_across = 0.0f;
		r_patch.slides = false;
		return;
	}
	const float slip = r_patch.speed_along - p_rim;
	r_patch.bend_along += slip * p_delta;
	r_patch.bend_across += r_patch.speed_across * p_delta;
	float x = -(r_patch.stiffness * r_patch.bend_along + r_patch.damping * slip);
	float y = -(r_patch.stiffness * r_patch.bend_across + r_patch.damping * r_patch.speed_across);
	// Across, it gives way sooner where the tread is made to (tracks), and along and across share what there is.
	const float most_y = std::max(r_patch.grip_across * r_patch.load, 1e-3f);
	const float most = std::max(std::max(r_patch.grip_along, r_patch.grip_across) * r_patch.load, 1e-3f);
	const bool slides_across = std::abs(y) > most_y;
	y = std::clamp(y, -most_y, most_y);
	const float used = std::sqrt(x * x + y * y) / most;
	r_patch.slides = used > 1.0f || slides_across;
	x = used > 1.0f ? x / used : x;
	y = used > 1.0f ? y / used : y;
	if (used > 1.0f) {
		// The tread slips until it is bent no further than friction holds it.
		r_patch.bend_along = -x / r_patch.stiffness;
	}
	if (r_patch.slides) {
		r_patch.bend_across = -y / r_patch.stiffness;
	}
	r_patch.force_along = x;
	r_patch.force_across = y;
}

} // namespace

void Rim::step(float p_drive, float p_brake, std::vector<Patch> &r_patches, std::size_t p_first, std::size_t p_count,
		float p_delta) {
	const float inertia = mass / p_delta;
	// What is left over if the rim had a speed; it grows with the speed, so there is one root.
	const auto rest = [&](float p_speed, float p_resisting) {
		float sum = inertia * (p_speed - speed) - p_drive + p_resisting;
		for (std::size_t i = p_first; i < p_first + p_count; i++) {
			sum += along(r_patches[i], p_speed, p_delta);
		}
		return sum;
	};
	float found = 0.0f;
	const float at_zero = rest(0.0f, 0.0f);
	if (std::abs(at_zero) > p_brake) {
		const float resisting = at_zero < 0.0f ? p_brake : -p_brake;
		// Regula falsi between zero and a speed on the other side of the root.
		float low = 0.0f;
		float low_rest = at_zero + resisting;
		float high = speed + (p_drive - resisting) / inertia;
		for (std::size_t i = p_first; i < p_first + p_count; i++) {
			const float most = r_patches[i].grip_along * r_patches[i].load / inertia;
			high += at_zero < 0.0f ? most : -most;
		}
		float high_rest = rest(high, resisting);
		for (int i = 0; i < ITERATIONS && low_rest != high_rest; i++) {
			found = (low * high_rest - high * low_rest) / (high_rest - low_rest);
			const float found_rest = rest(found, resisting);
			if (std::abs(found_rest) < 1e-4f * (std::abs(p_drive) + p_brake + inertia * 0.01f)) {
				break;
			}
			if ((found_rest > 0.0f) == (high_rest > 0.0f)) {
				high = found;
				high_rest = found_rest;
				low_rest *= 0.5f; // Illinois: the other end must move as well.
			} else {
				low = found;
				low_rest = found_rest;
				high_rest *= 0.5f;
			}
		}
	}
	speed = found;
	for (std::size_t i = p_first; i < p_first + p_count; i++) {
		finish(r_patches[i], speed, p_delta);
	}
}

} // namespace vehicle
