// SPDX-License-Identifier: MIT
#pragma once

#include "body/rig.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ragdoll {

/// What the guard had to do in a step; flags.
enum GuardAction : std::uint32_t {
	GUARD_NOTHING = 0,
	GUARD_ENERGY = 1, ///< The limbs moved too violently against each other: they were slowed down.
	GUARD_SPEED = 2, ///< The whole body was too fast: it was slowed down.
	GUARD_GAP = 4, ///< A limb was torn away from its joint: it was put back.
	GUARD_LOST = 8, ///< A limb's state was not finite: the body has to be put into the pose anew.
};

/// Keeps a simulated body from exploding, and says when it had to act.
///
/// It bounds the kinetic energy of the limbs against the centre of mass, the speed of the centre of mass, and the
/// gaps of the joints. The bounds are far above what a blow or a vehicle does to a person.
class EnergyGuard {
public:
	float max_energy = 60.0f; ///< Of the limbs against the centre of mass, J per kg of the body.
	float max_speed = 60.0f; ///< Of the centre of mass, m/s.
	float max_gap = 0.3f; ///< Of a joint, m.

	/// Checks a state and mends it in place. Returns flags of GuardAction; where it is not
	/// GUARD_NOTHING, the mended velocities and positions have to be given back to the simulation.
	std::uint32_t check(const Rig &p_rig, RigState &r_state) const;
	/// Kinetic energy of the limbs against the centre of mass, J.
	static float internal_energy(const Rig &p_rig, const RigState &p_state);
};

} // namespace ragdoll
