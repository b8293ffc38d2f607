// SPDX-License-Identifier: MIT
#pragma once

#include "body/rig.hpp"
#include "joint/actuation.hpp"

namespace ragdoll {

/// The limb that is nearest to a position in the world (m), by the line from its joint through its centre to
/// its other end; of one group, or of all (-1).
/// Returns -1 where the group has no limb.
int find_nearest_limb(const Rig &p_rig, const RigState &p_state, const Vec3 &p_position, int p_group);

/// The least share of a joint's greatest torque that stops a limb within MAX_BEND after an impulse (N s) at
/// a position (m), 0 to 1: a neck stiffens, and its tissue holds, before a head is thrown off.
float find_least_strength(
		const Rig &p_rig, const RigState &p_state, int p_limb, const Vec3 &p_impulse, const Vec3 &p_position);
/// How far a joint is bent by a blow at most, rad, if its whole torque can help it: about what a neck can
/// be (AAOS 1965).
constexpr float MAX_BEND = 0.8f;

/// Lets a limb's group give way for a moment, and the groups that hang on it, or it on them, half as much:
/// what is left of their strength (0 to 1), which is whole again after a time, s.
void flinch(const Rig &p_rig, int p_limb, float p_strength, float p_blend_s, ActuationTable &r_table);

/// Lets the limb that is nearest to a position (m) and those around it give way for a moment, and says which
/// that is; -1 where the group has none. Whoever calls it gives the body the impulse (N s) itself.
/// @param p_strength what is left of the strength; more where MAX_BEND needs it
int give_way(const Rig &p_rig, const RigState &p_state, const Vec3 &p_impulse, const Vec3 &p_position, int p_group,
		float p_strength, float p_blend_s, ActuationTable &r_table);

} // namespace ragdoll
