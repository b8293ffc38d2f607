// SPDX-License-Identifier: MIT
#pragma once

#include "base/archive.hpp"
#include "body/rig.hpp"
#include "joint/actuation.hpp"
#include "world/obstacles.hpp"

#include <vector>

namespace ragdoll {

/// Moves a root that is kinematic (HELD), and says when it must be pulled by force instead.
class HeldRoot {
public:
	/// A root that becomes held is fetched with this speed (m/s and rad/s), not within a tick: that would fling
	/// the limbs.
	static constexpr float FETCH_SPEED = 3.0f;
	static constexpr float FETCH_TURN = 6.0f;
	/// It has been fetched when it is off by less than this, m and rad.
	static constexpr float ARRIVED = 0.02f;
	/// Something holds back a limb that is off by more than this from where the hips have it, m.
	static constexpr float HELD_BACK = 0.15f;
	/// Limbs with a smaller share of their strength are not asked: they may be off by themselves.
	static constexpr float STRONG = 0.9f;
	/// The root is pulled for this long after it was obstructed, s.
	static constexpr float OBSTRUCTED_S = 0.3f;

	/// Whether the root must be pulled in this step, as something is in its way or holds a limb back.
	/// @param p_obstacles null where nothing is known
	bool is_obstructed(const Rig &p_rig, const ActuationTable &p_table, const Obstacles *p_obstacles,
			const RigState &p_state, const Pose &p_now, const Pose &p_next, float p_delta_s);
	/// Where the root is put at the end of this step.
	/// @param p_lift how far above the motion, m
	/// @param r_joint its joint, m
	void place(const RigState &p_state, const Pose &p_now, const Pose &p_next, const Vec3 &p_lift, float p_delta_s,
			Quat &r_orientation, Vec3 &r_joint);
	/// Ends a step.
	void finish(bool p_is_held) { _was_held = p_is_held; }

	void save(ArchiveWriter &p_archive) const;
	bool restore(ArchiveReader &p_archive);

private:
	std::vector<Vec3> _joints; // Kept between steps, so that a step allocates nothing.
	float _obstructed_s = 0.0f; // How much longer it is pulled.
	bool _was_held = false;
	bool _is_coming = false; // It is on its way to where it will be held.
};

} // namespace ragdoll
