// SPDX-License-Identifier: MIT
#pragma once

#include "actuation.hpp"
#include "rig.hpp"

namespace ragdoll {

/// The limb that is nearest to a position in the world (m), by the line from its joint through its centre to
/// its other end; of one group, or of all (-1).
/// Returns -1 where the group has no limb.
int find_nearest_limb(const Rig &p_rig, const RigState &p_state, const Vec3 &p_position, int p_group);

/// Lets a limb's group give way for a moment, and the groups that hang on it, or it on them, half as much:
/// what is left of their strength (0 to 1), which is whole again after a time, s.
void flinch(const Rig &p_rig, int p_limb, float p_strength, float p_blend_s, ActuationTable &r_table);

} // namespace ragdoll
