// SPDX-License-Identifier: MIT
#pragma once

#include "base/archive.hpp"
#include "clearance/clearance_body.hpp"

#include <cstdint>
#include <vector>

namespace ragdoll {

/// Moves the targets of arms and legs that lie inside the own body out to its surface, so that no motor pulls a limb
/// into another: a wearer is slimmer than the body, or the suit is off, and crossed forearms lie in the chest.
///
/// What is found is how far elbow and wrist (knee and ankle) are shifted. Contacts and the lengths of the limbs are
/// satisfied one after the other, by the turns of the two limbs that need least (Gauss-Seidel over the contacts, as in
/// position-based dynamics, Mueller et al. 2007). It begins with the shift of the step before, so that who has come
/// to lie on one side of the chest stays there. A shift is given up at once as far as nothing is in the way back, and
/// a little of it in any case, which contacts then renew: so it comes to the shortest.
class SelfClearance {
public:
	/// Overlap with which nothing is moved, m.
	static constexpr float NO_LIMIT = 1.0f;
	/// Greatest depth to which limbs may lie in each other, m, besides what they do in the rest pose. Flesh yields.
	float overlap = 0.01f;

	explicit SelfClearance(const Rig &p_rig);
	/// Moves the targets at the beginning and at the end of a step.
	/// @param p_begins whether the pose does not go on from the last step
	void advance(const Rig &p_rig, bool p_begins, float p_delta_s, Pose &r_now, Pose &r_next);
	/// Moves a single pose; the next step begins anew.
	void clear(const Rig &p_rig, Pose &r_pose);
	/// By how much the target of each limb was turned at the end of the last step, rad.
	std::vector<float> find_turns() const;

	void save(ArchiveWriter &p_archive) const;
	bool restore(ArchiveReader &p_archive);

private:
	/// What a limb's turn does to its axis besides the shift of its joints, as shapes do not lie quite between joints,
	/// m.
	struct Bias {
		Vec3 low;
		Vec3 high;
	};
	/// What is kept from step to step, in the axes of what the chain hangs on.
	struct Kept {
		ChainShift shift;
		ChainShift wanted; // From the first joint to the other two where the motion has them, m.
		ChainTurn turn;
		Bias upper;
		Bias lower;
		float left = 0.0f; // Depth that the contacts were left with, m.
		std::uint32_t is_moved = 0; // Of a size that leaves no gap: it is archived byte by byte.
	};
	struct Chain {
		ChainShift shift; // World axes, m.
		Vec3 upper; // From the first joint to the middle one where the motion has them, m.
		Vec3 lower; // On to the end.
		float upper_rate = 0.0f; // One over their lengths, 1/m.
		float lower_rate = 0.0f;
		Vec3 upper_way; // Along them as they are moved, unit vectors.
		Vec3 lower_way;
		float length = 0.0f; // Of the shift with which a step begins, m.
		Bias biases[2]; // Of the upper and the lower limb, world axes.
		ChainShift looked; // The shift with which pairs were looked at ...
		float moved = 0.0f; // ... and how far it has gone since, m.
		float way = 0.0f; // How far the motion went in the step, m.
		float left = 0.0f; // Deepest contact of the last pass, m.
		float room = 0.0f; // Until the chain meets anything, m.
		bool is_free = false; // The motion itself is clear of everything.
		bool is_fading = false; // It goes back through the body.
	};
	/// A pair that may come to touch, and how deep it was when it was looked at, m.
	struct Near {
		const ClearancePair *pair = nullptr;
		float depth = 0.0f;
	};
	/// Where a part lies now.
	struct Place {
		std::uint32_t step = 0; // In which its axes were turned.
		SolidAxis axis; // As it is moved.
	};
	struct Contact {
		Approach approach;
		float depth = 0.0f; // m; below zero there is a gap.
	};
	/// How a point moves in a direction where the upper and the lower limb are turned.
	struct Lever {
		Vec3 upper; // By the middle joint's way, m per m.
		Vec3 lower; // By the end's way about the middle.
		float square() const { return upper.dot(upper) + lower.dot(lower); }
	};

	void solve_anew(const Rig &p_rig, Pose &r_pose);
	void solve(const Rig &p_rig, bool p_begins, float p_delta_s, Pose &r_pose);
	void begin(const Rig &p_rig, bool p_begins, const Pose &p_pose);
	void solve_pairs(const Pose &p_pose, const std::vector<ClearancePair> &p_pairs, bool p_begins, float p_delta_s);
	bool has_work(const Pose &p_pose, const std::vector<ClearancePair> &p_pairs, bool p_begins);
	/// Looks at all pairs with gaps up to a margin, m. Returns whether any is too deep.
	bool find_near(const Pose &p_pose, const std::vector<ClearancePair> &p_pairs, float p_margin);
	void look(const ClearancePair &p_pair, const Contact &p_contact);
	void let_go(bool p_legs, float p_delta_s);
	bool push_apart(const Near &p_near);
	void push(const ClearancePair &p_pair, const Contact &p_contact);
	void keep(const Rig &p_rig, bool p_begins, float p_delta_s, Pose &r_pose);
	void keep_turn(const Rig &p_rig, std::size_t p_chain, Pose &r_pose);
	Bias find_bias(const ClearancePart &p_part, const Quat &p_orientation, const Vec3 &p_joint) const;

	void turn_axes(const Pose &p_pose, int p_part);
	void find_axis(std::size_t p_part);
	void move_chain(std::size_t p_chain);
	Contact meet(const ClearancePair &p_pair) const;
	Contact meet_unmoved(const ClearancePair &p_pair) const;
	Contact meet_end(const ClearancePair &p_pair, float p_end) const;
	Contact weigh(const ClearancePair &p_pair, const Approach &p_approach) const;
	AxisFreedom get_freedom(const ClearancePair &p_pair) const;
	Lever find_lever(const ClearancePart &p_part, float p_share, const Vec3 &p_normal) const;
	Chain &chain_of(int p_part) { return _chains[std::size_t(_body.parts[std::size_t(p_part)].chain)]; }

	ClearanceBody _body;
	std::size_t _limb_count;
	std::vector<Chain> _chains;
	std::vector<Kept> _kept;
	std::vector<Place> _places;
	bool _has_begun = false;
	// Kept between steps, so that a step allocates nothing.
	Pose _wanted;
	std::vector<Near> _near;
	std::vector<Vec3> _joints;
	std::uint32_t _step = 0;
};

} // namespace ragdoll
