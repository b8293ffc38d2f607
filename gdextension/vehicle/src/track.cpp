// SPDX-License-Identifier: MIT
#include "track.hpp"

#include <algorithm>
#include <cmath>

namespace vehicle {

namespace {

/// A sphere may run ahead of its track by so much, m/s: more would be a track that has come apart.
constexpr float AHEAD = 0.6f;
/// Share of the mean load that a sphere counts with beside its own: in the air, so that it turns with its track,
/// and at a wall, which it climbs although it loads no spring.
constexpr float FLOOR_SHARE = 0.1f;
constexpr float WALL_SHARE = 3.0f;
constexpr float RESTS = 0.05f; ///< m/s.

} // namespace

float track_speed(const std::vector<SphereMotor> &p_spheres, std::size_t p_first, std::size_t p_count) {
	float weights = 0.0f;
	float sum = 0.0f;
	float plain = 0.0f;
	for (std::size_t i = p_first; i < p_first + p_count; i++) {
		const float weight = std::max(0.0f, p_spheres[i].load);
		weights += weight;
		sum += weight * p_spheres[i].speed;
		plain += p_spheres[i].speed / float(p_count);
	}
	return weights > 1.0f ? sum / weights : plain;
}

void share_track(std::vector<SphereMotor> &r_spheres, std::size_t p_first, std::size_t p_count, float p_drive,
		float p_brake, float p_sphere_mass, float p_delta) {
	const float speed = track_speed(r_spheres, p_first, p_count);
	float loads = 0.0f;
	for (std::size_t i = p_first; i < p_first + p_count; i++) {
		loads += std::max(0.0f, r_spheres[i].load);
	}
	const float mean = std::max(loads, 1.0f) / float(p_count);
	const auto weight = [mean](const SphereMotor &p_sphere) {
		return std::max(0.0f, p_sphere.load) + mean * (FLOOR_SHARE + WALL_SHARE * p_sphere.wall);
	};
	float weights = 0.0f;
	for (std::size_t i = p_first; i < p_first + p_count; i++) {
		weights += weight(r_spheres[i]);
	}
	// What is left of drive against brake, and which way it turns the track.
	const bool is_held = std::abs(p_drive) <= p_brake;
	const float moving = speed > RESTS ? 1.0f : (speed < -RESTS ? -1.0f : 0.0f);
	float target = 0.0f;
	float force = 0.0f;
	if (is_held) {
		force = std::max(0.0f, p_brake - p_drive * moving);
	} else {
		const float way = p_drive > 0.0f ? 1.0f : -1.0f;
		// At rest brakes hold back as well.
		force = std::abs(p_drive) - p_brake * (moving == 0.0f ? 1.0f : moving * way);
		target = speed + way * AHEAD;
	}
	for (std::size_t i = p_first; i < p_first + p_count; i++) {
		SphereMotor &sphere = r_spheres[i];
		const float share = weight(sphere) / weights;
		sphere.target = target;
		// Enough to stay with the track where the ground does not see to it.
		const float apart = std::abs(sphere.speed - speed);
		const float keep = std::min(apart, AHEAD) * p_sphere_mass / p_delta * 0.2f;
		sphere.force = force * share + (is_held ? 0.0f : keep);
	}
}

} // namespace vehicle
