// SPDX-License-Identifier: MIT
#pragma once

#include "control/feed_forward.hpp"
#include "control/world_drive.hpp"

#include <vector>

namespace ragdoll {

/// What the limbs' bodies get besides their joints' motors: the springs of controls in the world, and the forces
/// that the motion itself needs (feed-forward).
class LimbPushes {
public:
	explicit LimbPushes(const Rig &p_rig);

	/// Changes a limb's springs in the world within a time, s.
	void set_springs(std::size_t p_limb, const LimbControl &p_control, float p_blend_s) {
		_world.set(p_limb, p_control.world_angular, p_control.world_linear, p_blend_s);
	}
	/// Finds the pushes of this step.
	/// @param p_now, p_next the motion at the beginning and at the end of the step
	void advance(const Rig &p_rig, const RigState &p_state, const Pose &p_now, const Pose &p_next, float p_delta_s,
			const std::vector<LimbCommand> &p_commands, std::vector<LimbPush> &r_pushes);
	/// The body has been put elsewhere: what the motion did before counts no more.
	void clear() { _feed_forward.clear(); }

	void save(ArchiveWriter &p_archive) const;
	bool restore(ArchiveReader &p_archive);

private:
	WorldDrive _world;
	FeedForward _feed_forward;
	// Kept between steps, so that a step allocates nothing.
	std::vector<Vec3> _joints;
	std::vector<Vec3> _joints_next;
};

} // namespace ragdoll
