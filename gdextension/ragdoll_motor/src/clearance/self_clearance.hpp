// SPDX-License-Identifier: MIT
#pragma once

#include "base/archive.hpp"
#include "body/rig.hpp"
#include "clearance/limb_solid.hpp"
#include "clearance/two_bone_chain.hpp"

#include <cstdint>
#include <utility>
#include <vector>

namespace ragdoll {

/// Moves the targets of arms and legs that lie inside the own body out to its surface, so that no motor pulls a limb
/// into another: a wearer is slimmer, or a suit's measures are off, and crossed forearms lie in the chest.
///
/// Forearms and hands keep clear of trunk, head, legs and the other arm; thighs (from where they are apart) and shins
/// of the other leg. Elbow and wrist (knee and ankle) are the unknowns: contacts and the lengths of the limbs are
/// satisfied one after the other (position-based dynamics, Mueller et al. 2007), beginning from how they were moved
/// the step before, so that who has come to lie on one side stays there. What is not needed any more goes at once
/// where the way back is free.
class SelfClearance {
public:
	/// Greatest depth to which limbs may lie in each other, m, besides what they do in the rest pose. Flesh yields.
	float overlap = 0.01f;

	explicit SelfClearance(const Rig &p_rig);
	/// Moves the targets at the beginning and at the end of a step.
	/// @param p_begins whether the pose is not what the last step led to
	void advance(const Rig &p_rig, bool p_begins, float p_delta_s, Pose &r_now, Pose &r_next);
	/// Moves a single pose; the next step begins anew.
	void clear(const Rig &p_rig, Pose &r_pose);
	/// By how much the target of each limb at the beginning of the last step was turned, rad.
	std::vector<float> find_turns() const;

	void save(ArchiveWriter &p_archive) const;
	bool restore(ArchiveReader &p_archive);

private:
	/// Shares of a chain's shift (middle, end) that a point moves by.
	struct Shares {
		float middle = 0.0f;
		float end = 0.0f;
	};
	struct Chain {
		TwoBoneChain limbs;
		ChainShift shift; // World axes, at the end of the step.
		ChainShift before; // Where the step began, world axes as above.
		ChainShift kept; // In the axes of what the chain hangs on.
		Vec3 upper; // From the first joint to the middle one, where the motion has them, m.
		Vec3 lower; // On to the end.
		Vec3 upper_way; // Along the limbs as they are moved, unit vectors.
		Vec3 lower_way;
		float room = 0.0f; // Until the chain meets anything, m.
		bool is_free = false; // The motion itself is clear.
		bool is_fading = false; // It goes back through the body.
		Quat turned[2]; // The upper and lower limb's target before it was moved, at the step's beginning ...
		Quat moved[2]; // ... and after.
	};
	struct Part {
		LimbSolid solid;
		int chain = -1; // That moves it.
		Shares low; // At its axis' beginning ...
		Shares high; // ... and end.
		std::uint32_t placed = 0; // When its axes were turned.
	};
	struct Pair {
		int mover = 0; // Parts.
		int other = 0;
		float rest_overlap = 0.0f; // In the rest pose, m.
		bool is_shared = false; // Both can be moved.
	};
	/// How a point moves in a direction where the upper and the lower limb are turned.
	struct Lever {
		Vec3 upper; // By the middle joint's way, m per m.
		Vec3 lower; // By the end's way about the middle.
		float square() const { return upper.dot(upper) + lower.dot(lower); }
	};
	struct Contact {
		Approach approach;
		float depth = 0.0f;
	};

	void make_parts(const Rig &p_rig);
	void make_pairs(const Rig &p_rig);
	void close_faces(const Rig &p_rig);
	bool can_meet(const Rig &p_rig, const Part &p_mover, const Part &p_other) const;
	void place(const Rig &p_rig, const Pose &p_pose);
	void solve(const Rig &p_rig, bool p_begins, float p_delta_s, Pose &r_pose);
	void solve_pairs(const Pose &p_pose, const std::vector<Pair> &p_pairs, bool p_begins, float p_delta_s);
	/// Finds the pairs that may meet. Returns whether any do where the motion has them.
	bool find_near(const Pose &p_pose, const std::vector<Pair> &p_pairs);
	void let_go(bool p_legs, float p_delta_s);
	bool push_apart(const Pair &p_pair);
	static void find_ways(Chain &r_chain);
	Lever find_lever(const Part &p_part, float p_share, const Vec3 &p_normal) const;
	void push(const Pair &p_pair, const Contact &p_contact);
	void turn(const Rig &p_rig, Pose &r_pose);
	Vec3 shift_of(const Part &p_part, const Shares &p_shares) const;
	SolidAxis axis_of(const Part &p_part, bool p_moved) const;
	Contact meet(const Pair &p_pair, bool p_moved) const;
	Contact meet_end(const Pair &p_pair, float p_end) const;
	Contact weigh(const Pair &p_pair, const Approach &p_approach) const;

	std::size_t _limb_count;
	std::vector<Chain> _chains;
	std::vector<Part> _parts;
	std::vector<Pair> _leg_pairs; // Legs come first: arms keep clear of where they are then.
	std::vector<Pair> _arm_pairs;
	bool _has_begun = false;
	// Kept between steps, so that a step allocates nothing.
	std::vector<Pair> _near;
	std::vector<Vec3> _joints;
	std::uint32_t _placed = 0;
};

} // namespace ragdoll
