// SPDX-License-Identifier: MIT
#pragma once

#include "body/rig.hpp"

#include <vector>

namespace ragdoll {

/// Two limbs that bend between a trunk and an end: upper arm, forearm and hand, or thigh, shin and foot. Limbs by
/// their indices in the rig.
struct TwoBoneChain {
	int upper = 0;
	int lower = 0;
	int end = 0;
	bool is_leg = false;
};

/// Where the middle and the end joint of a chain are moved to, from where the motion has them, m.
struct ChainShift {
	Vec3 middle; ///< Elbow or knee.
	Vec3 end; ///< Wrist or ankle.

	bool is_none() const { return middle.dot(middle) == 0.0f && end.dot(end) == 0.0f; }
	/// The longer of the two, m.
	float length() const;
	ChainShift scaled(float p_factor) const { return { middle * p_factor, end * p_factor }; }
	ChainShift turned(const Quat &p_turn) const { return { p_turn.rotate(middle), p_turn.rotate(end) }; }
};

/// The chains of a body: limbs of one group, which is not the root's, each with just one limb of the group that hangs
/// on it; the last three of them. A leg ends in its foot.
std::vector<TwoBoneChain> find_chains(const Rig &p_rig);

/// Changes a shift such that the chain's two limbs keep their lengths.
/// @param p_upper from the first joint to the middle one where the motion has them, m
/// @param p_lower from the middle joint to the end where the motion has them, m
void keep_lengths(const Vec3 &p_upper, const Vec3 &p_lower, ChainShift &r_shift);

/// How the two limbs of a chain are turned, about the world's axes.
struct ChainTurn {
	Quat upper;
	Quat lower;
};

/// Turns a pose's two limbs to where a shift has their joints. The chain bends about the hinge that the motion bends
/// it about, as far as it is bent at all: the upper limb turns about its length to where the hinge is. What hangs on
/// the end keeps its orientation in the world. Returns the turns.
/// @param p_shift in world axes
ChainTurn turn_chain(const Rig &p_rig, const TwoBoneChain &p_chain, const ChainShift &p_shift, Pose &r_pose);

} // namespace ragdoll
