// SPDX-License-Identifier: MIT
#pragma once

#include "body/rig.hpp"
#include "clearance/limb_solid.hpp"
#include "clearance/two_bone_chain.hpp"

#include <cstdint>
#include <vector>

namespace ragdoll {

/// Shares of a chain's shift that a point moves by.
struct ChainShares {
	float middle = 0.0f;
	float end = 0.0f;
};

/// A limb with a shape: how a chain moves it.
struct ClearancePart {
	LimbSolid solid;
	int chain = -1; ///< That moves it; -1 for trunk and head.
	ChainShares low; ///< Of its axis' beginning ...
	ChainShares high; ///< ... and end.

	/// How an axis point moves.
	ChainShares at(float p_share) const {
		return { low.middle + (high.middle - low.middle) * p_share, low.end + (high.end - low.end) * p_share };
	}
};

/// Two limbs that have to keep clear of each other.
struct ClearancePair {
	std::int16_t mover = 0; ///< A part of a chain.
	std::int16_t other = 0;
	float reach = 0.0f; ///< Centres that are further apart than this (m) are those of limbs that do not touch.
	float rest_overlap = 0.0f; ///< How deep they lie in each other in the rest pose, m.
	bool is_shared = false; ///< Both are moved; otherwise the other one stays.
};

/// What of a body has to keep clear of what: forearms and hands of trunk, head, legs and the other arm; thighs and
/// shins of the other leg. Limbs of one chain, and upper arms against the trunk, meet by build.
struct ClearanceBody {
	std::vector<TwoBoneChain> chains;
	std::vector<ClearancePart> parts;
	std::vector<std::vector<int>> chain_parts; ///< Of each chain.
	std::vector<ClearancePair> leg_pairs;
	std::vector<ClearancePair> arm_pairs;

	explicit ClearanceBody(const Rig &p_rig);

private:
	void make_parts(const Rig &p_rig);
	void close_faces();
	void make_pairs(const Rig &p_rig);
	bool can_meet(const Rig &p_rig, const ClearancePart &p_mover, const ClearancePart &p_other) const;
	bool is_leg(const ClearancePart &p_part) const { return p_part.chain >= 0 && chains[p_part.chain].is_leg; }
};

} // namespace ragdoll
