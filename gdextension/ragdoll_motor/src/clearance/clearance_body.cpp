// SPDX-License-Identifier: MIT
#include "clearance/clearance_body.hpp"

#include <algorithm>

namespace ragdoll {

namespace {

// Where another limb is within this of the place this far outside (m), a face is no way out: trunk on trunk.
constexpr float JOINED = 0.03f;

/// How a point of a chain's limb moves with it.
ChainShares find_shares(const Rig &p_rig, const TwoBoneChain &p_chain, int p_limb, const Vec3 &p_point) {
	if (p_limb == p_chain.end) {
		return { 0.0f, 1.0f }; // It is not turned.
	}
	const Vec3 &along = p_rig[std::size_t(p_limb == p_chain.upper ? p_chain.lower : p_chain.end)].anchor;
	const float share = std::clamp(p_point.dot(along) / along.dot(along), 0.0f, 1.0f);
	return p_limb == p_chain.upper ? ChainShares{ share, 0.0f } : ChainShares{ 1.0f - share, share };
}

} // namespace

ClearanceBody::ClearanceBody(const Rig &p_rig) : chains(find_chains(p_rig)) {
	make_parts(p_rig);
	Pose rest;
	for (std::size_t i = 0; i < p_rig.size(); i++) {
		rest.orientations.push_back(p_rig[i].rest);
	}
	std::vector<Vec3> joints;
	p_rig.joint_positions(rest, joints);
	for (ClearancePart &part : parts) {
		const std::size_t limb = std::size_t(part.solid.limb);
		part.solid.place(rest.orientations[limb], joints[limb]);
		part.solid.turn_axes(rest.orientations[limb]);
	}
	close_faces();
	make_pairs(p_rig);
}

void ClearanceBody::make_parts(const Rig &p_rig) {
	chain_parts.resize(chains.size());
	for (std::size_t i = 0; i < p_rig.size(); i++) {
		if (p_rig[i].shape.type == LimbShape::Type::NONE) {
			continue;
		}
		ClearancePart part;
		part.solid = LimbSolid(p_rig, i);
		const Vec3 half = part.solid.get_local_half();
		for (std::size_t c = 0; c < chains.size(); c++) {
			const int limb = int(i);
			if (limb == chains[c].upper || limb == chains[c].lower || limb == chains[c].end) {
				part.chain = int(c);
				chain_parts[c].push_back(int(parts.size()));
				part.low = find_shares(p_rig, chains[c], limb, p_rig[i].centre - half);
				part.high = find_shares(p_rig, chains[c], limb, p_rig[i].centre + half);
			}
		}
		parts.push_back(part);
	}
}

void ClearanceBody::close_faces() {
	for (ClearancePart &part : parts) {
		for (int face = 0; face < 6 && part.solid.is_box && part.chain < 0; face++) {
			const Vec3 outside = part.solid.find_outside(face, JOINED);
			for (const ClearancePart &other : parts) {
				const bool is_arm = other.chain >= 0 && !is_leg(other);
				const Approach found = approach_point(outside, other.solid, other.solid.get_axis());
				part.solid.is_closed[face] |= &other != &part && !is_arm && found.distance < JOINED;
			}
		}
	}
}

bool ClearanceBody::can_meet(const Rig &p_rig, const ClearancePart &p_mover, const ClearancePart &p_other) const {
	if (p_mover.chain < 0 || p_mover.chain == p_other.chain) {
		return false;
	}
	const TwoBoneChain &own = chains[std::size_t(p_mover.chain)];
	if (own.is_leg) {
		// Feet are left where they tread.
		return is_leg(p_other) && p_mover.solid.limb != own.end &&
				p_other.solid.limb != chains[std::size_t(p_other.chain)].end;
	}
	// What hangs on the end is moved with it.
	for (int above = p_other.solid.limb; above >= 0; above = p_rig[std::size_t(above)].parent) {
		if (above == own.end) {
			return false;
		}
	}
	return p_mover.solid.limb != own.upper;
}

void ClearanceBody::make_pairs(const Rig &p_rig) {
	for (std::size_t i = 0; i < parts.size(); i++) {
		for (std::size_t j = 0; j < parts.size(); j++) {
			const LimbSolid &mover = parts[i].solid;
			const LimbSolid &other = parts[j].solid;
			if (!can_meet(p_rig, parts[i], parts[j])) {
				continue;
			}
			ClearancePair pair;
			pair.mover = std::int16_t(i);
			pair.other = std::int16_t(j);
			pair.reach = mover.reach + other.reach;
			pair.is_shared = parts[j].chain >= 0 && is_leg(parts[j]) == is_leg(parts[i]);
			// Of boxes the axis alone knows the ends: it is looked at from both sides. Pills are the same from either.
			if (j < i && pair.is_shared && !mover.is_box && !other.is_box && can_meet(p_rig, parts[j], parts[i])) {
				continue;
			}
			const Approach found = approach_axis(mover.get_axis(), AxisFreedom(), other, other.get_axis());
			pair.rest_overlap = std::max(mover.find_thickness(found.normal) - found.distance, 0.0f);
			(is_leg(parts[i]) ? leg_pairs : arm_pairs).push_back(pair);
		}
	}
}

} // namespace ragdoll
