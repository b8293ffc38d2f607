// SPDX-License-Identifier: MIT
#pragma once

#include <skeleton.hpp>

#include <array>
#include <cstdint>

namespace wire {

using kinematics::MAX_LIMBS;
using kinematics::PersonPose;
using kinematics::Quat;
using kinematics::Vec3;

/// A rotation on a lattice, as three whole numbers that stand for three of its components, and which one
/// is left out: that one is not negative. What a number means is the lattice's: PersonLattice divides by 1
/// plus the one left out, bodies scale the component itself.
struct RotationCode {
	std::array<int16_t, 3> parts{}; ///< In the order x, y, z, w, without the one left out.
	uint8_t dropped = 3; ///< 0 to 3: x, y, z or w.

	bool operator==(const RotationCode &p_other) const { return parts == p_other.parts && dropped == p_other.dropped; }
};

/// Where a person is, on the lattice that server and clients share.
struct PersonState {
	std::array<int32_t, 3> root{}; ///< Position of the root limb's frame in the world, mm.
	/// The root limb's orientation in the world; the others' relative to their parents.
	std::array<RotationCode, MAX_LIMBS> limbs{};
	/// Id of the body that carries the person, in whose frame root and root limb are; 0: none, in the world's.
	uint16_t frame = 0;
};

} // namespace wire
