// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <vector>

namespace vehicle {

/// Where a wheel touches the ground, in the plane of the ground there: along is the way that the wheel rolls.
struct Patch {
	float load = 0.0f; ///< Force of the ground along its normal, N; 0 is no contact.
	float grip_along = 1.0f; ///< Coefficient of friction.
	float grip_across = 1.0f;
	float stiffness = 1e6f; ///< Of the tread against the ground, N/m.
	float damping = 1e4f; ///< N s/m.
	float speed_along = 0.0f; ///< Of the hull over the ground here, m/s.
	float speed_across = 0.0f;
	float bend_along = 0.0f; ///< How far the tread is bent against the ground, m: kept from step to step.
	float bend_across = 0.0f;
	float force_along = 0.0f; ///< On the hull, N.
	float force_across = 0.0f;
	bool slides = false;
};

/// What turns as one: a wheel, or a track with all the wheels that roll on it. Speeds are at the rim.
///
/// The tread is a brush: it sticks to the ground and bends until friction gives way (Dahl 1968; Pacejka 2012,
/// chapter 3). So a vehicle at rest stays where it is, on a slope too. The rim's speed is found implicitly, as it
/// weighs little against the stiffness of the tread.
struct Rim {
	float mass = 1000.0f; ///< Of all that turns, as mass at the rim, kg.
	float speed = 0.0f; ///< m/s, forward positive.

	/// One step with a drive (N, signed) and brakes with rolling resistance (N). Sets the patches' forces and bends.
	void step(float p_drive, float p_brake, std::vector<Patch> &r_patches, std::size_t p_first, std::size_t p_count,
			float p_delta);
};

} // namespace vehicle
