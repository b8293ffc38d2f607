// SPDX-License-Identifier: MIT
#include "clearance/two_bone_chain.hpp"

#include "body/leg.hpp"

#include <algorithm>

namespace ragdoll {

namespace {

constexpr float SHORTEST = 0.02f; // Of a limb that can be turned, m.
// Sine of the bend from which on a hinge's axis is known in part, and wholly: 6 and 24 degrees.
constexpr float STRAIGHT = 0.1f;
constexpr float BENT = 0.7f;

/// The only limb of the same group that hangs on a limb; -1 where there is none or are several.
int find_next(const Rig &p_rig, int p_limb) {
	int found = -1;
	for (std::size_t i = 0; i < p_rig.size(); i++) {
		if (p_rig[i].parent == p_limb && p_rig[i].group == p_rig[std::size_t(p_limb)].group) {
			if (found >= 0) {
				return -1;
			}
			found = int(i);
		}
	}
	return found;
}

/// A vector brought to a length.
Vec3 resized(const Vec3 &p_vector, float p_length) {
	const float now = p_vector.length();
	return now > 1e-6f ? p_vector * (p_length / now) : p_vector;
}

} // namespace

float ChainShift::length() const {
	return std::sqrt(std::max(middle.dot(middle), end.dot(end)));
}

std::vector<TwoBoneChain> find_chains(const Rig &p_rig) {
	std::vector<TwoBoneChain> chains;
	for (std::size_t i = 1; i < p_rig.size(); i++) {
		const Segment &parent = p_rig[std::size_t(p_rig[i].parent)];
		if (p_rig[i].group == p_rig[0].group || p_rig[i].group == parent.group) {
			continue;
		}
		TwoBoneChain chain{ -1, -1, int(i), p_rig[i].is_foot };
		for (int next = find_next(p_rig, chain.end); next >= 0 && !chain.is_leg; next = find_next(p_rig, next)) {
			chain = { chain.lower, chain.end, next, p_rig[std::size_t(next)].is_foot };
		}
		const bool is_whole = chain.upper >= 0 && chain.lower >= 0;
		if (is_whole && p_rig[std::size_t(chain.lower)].anchor.length() > SHORTEST &&
				p_rig[std::size_t(chain.end)].anchor.length() > SHORTEST) {
			chains.push_back(chain);
		}
	}
	return chains;
}

void keep_lengths(const Vec3 &p_upper, const Vec3 &p_lower, ChainShift &r_shift) {
	const Vec3 lower = resized(p_lower + r_shift.end - r_shift.middle, p_lower.length());
	r_shift.middle = resized(p_upper + r_shift.middle, p_upper.length()) - p_upper;
	r_shift.end = r_shift.middle + lower - p_lower;
}

ChainTurn turn_chain(const Rig &p_rig, const TwoBoneChain &p_chain, const ChainShift &p_shift, Pose &r_pose) {
	Quat &upper = r_pose.orientations[std::size_t(p_chain.upper)];
	Quat &lower = r_pose.orientations[std::size_t(p_chain.lower)];
	const Vec3 along = upper.rotate(p_rig[std::size_t(p_chain.lower)].anchor);
	const Vec3 on = lower.rotate(p_rig[std::size_t(p_chain.end)].anchor);
	const Vec3 new_along = along + p_shift.middle;
	const Vec3 new_on = on + p_shift.end - p_shift.middle;
	const float area = along.length() * on.length();
	Quat turn = rotation_between(along, new_along);
	const Vec3 hinge = turn.rotate(along.cross(on));
	const Vec3 new_hinge = new_along.cross(new_on);
	const float bend = std::min(hinge.length(), new_hinge.length()) / area;
	const float known = std::clamp((bend - STRAIGHT) / (BENT - STRAIGHT), 0.0f, 1.0f);
	if (known > 0.0f) {
		const Vec3 axis = new_along * (1.0f / new_along.length());
		// The sine instead of the angle: nothing jumps where a hinge comes to lie the other way round.
		const float angle = hinge.cross(new_hinge).dot(axis) / (hinge.length() * new_hinge.length());
		turn = exp(axis * (angle * known * known * (3.0f - 2.0f * known))) * turn;
	}
	const Quat bent = rotation_between(turn.rotate(on), new_on) * turn;
	upper = (turn * upper).normalized();
	lower = (bent * lower).normalized();
	return { turn, bent };
}

} // namespace ragdoll
