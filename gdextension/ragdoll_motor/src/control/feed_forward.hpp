// SPDX-License-Identifier: MIT
#pragma once

#include "base/archive.hpp"
#include "body/rig.hpp"
#include "control/world_drive.hpp"
#include "joint/controller.hpp"

#include <vector>

namespace ragdoll {

/// Adds to the motors the forces that the limbs above the legs need to move as the motion does: inverse dynamics.
///
/// Newton's and Euler's equations of each limb under the motion's accelerations and gravity (Featherstone
/// 2008, Rigid Body Dynamics Algorithms, section 5.3); the root gets the opposite of their sum, so that no
/// force comes from outside. The engine's solver goes over the joints a limited number of times, which is
/// too few for a chain of light and heavy bodies: what it begins with decides how far it gets. It knows
/// nothing of contacts, and takes no more of a joint than its torque; what the motor gives comes on top of
/// that. It falls faster than the strength of a joint that is weakened: a person has
/// to know beforehand to do it.
class FeedForward {
public:
	FeedForward() = default;
	explicit FeedForward(const Rig &p_rig);

	/// Forgets the motion so far: the next step adds nothing.
	void clear() { _has_before = false; }
	/// Adds to what the limbs get in the step from p_now to p_next. Only limbs with velocity motors on all
	/// joints up to the root get anything.
	void add(const Rig &p_rig, const RigState &p_state, const Pose &p_now, const Pose &p_next, float p_delta_s,
			const std::vector<LimbCommand> &p_commands, std::vector<LimbPush> &r_pushes);

	void save(ArchiveWriter &p_archive) const;
	bool restore(ArchiveReader &p_archive);

private:
	/// Change of momentum of a limb.
	struct Impulse {
		Vec3 linear; ///< N s
		Vec3 angular; ///< About the limb's centre, N m s.
	};

	void find_impulses(const Rig &p_rig, const RigState &p_state, const Pose &p_now, const Pose &p_next,
			float p_delta_s, const std::vector<LimbCommand> &p_commands);
	/// How much of its impulse the joints' torques give each limb, 0 to 1: no more than its parent gets.
	void find_shares(
			const Rig &p_rig, const RigState &p_state, float p_delta_s, const std::vector<LimbCommand> &p_commands);

	std::vector<Vec3> _linear; // The motion's velocities in the step before, m/s ...
	std::vector<Vec3> _angular; // ... and rad/s.
	std::vector<Vec3> _joints;
	std::vector<Vec3> _joints_next;
	std::vector<Impulse> _impulses;
	std::vector<Impulse> _hanging; // What hangs on each joint: all linear impulses, and the moment about it.
	std::vector<float> _shares;
	std::vector<bool> _driven; // By velocity motors from the root on.
	bool _has_before = false;
};

} // namespace ragdoll
