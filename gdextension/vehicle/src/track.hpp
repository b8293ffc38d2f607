// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace vehicle {

/// A sphere of a track as its motor is told: it turns towards a speed with no more than a force.
struct SphereMotor {
	float load = 0.0f; ///< Of the spring, N: given.
	float speed = 0.0f; ///< At the rim, over the hull, m/s: given.
	float wall = 0.0f; ///< How steep what it touches is, 0 (or nothing) to 1 (upright): given.
	float target = 0.0f; ///< At the rim, m/s.
	float force = 0.0f; ///< At the rim at most, N.
};

/// Speed of a track whose spheres turn each by itself: their mean by load, m/s.
float track_speed(const std::vector<SphereMotor> &p_spheres, std::size_t p_first, std::size_t p_count);

/// Shares a drive (N, signed), brakes and rolling resistance (N) out among the spheres of a track. The ones that
/// carry more get more, and those in the air keep up with the track.
void share_track(std::vector<SphereMotor> &r_spheres, std::size_t p_first, std::size_t p_count, float p_drive,
		float p_brake, float p_sphere_mass, float p_delta);

} // namespace vehicle
