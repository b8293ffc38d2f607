// SPDX-License-Identifier: MIT
#pragma once

#include "body/rig.hpp"
#include "world/obstacles.hpp"

namespace ragdoll {

/// Lets a body that is about to strike something firm strike it no faster than the engine can bear.
///
/// A body that has fallen 50 m moves by half a metre in a step. The limb that strikes first is stopped, those behind
/// it go on, and the joints between push it through whatever is thin before the solver has spread the blow over the
/// whole body. In the step before it strikes, the whole body is slowed down to what takes it to the surface.
class Landing {
public:
	/// Who moves by no more than this in a step (m) is not looked after: the engine copes.
	static constexpr float LONG_STEP = 0.13f;
	/// Nobody is made to move by less than this in a step, m.
	static constexpr float SHORT_STEP = 0.05f;
	/// How far limbs reach from the centre of mass, m.
	static constexpr float REACH = 1.3f;
	/// Half a limb's thickness, m.
	static constexpr float THICKNESS = 0.06f;

	/// Begins a step. Returns whether velocities have been changed.
	/// @param p_carried how what carries the body moves in this step, m: only what differs from it can strike
	bool advance(const Rig &p_rig, const Obstacles *p_obstacles, const Vec3 &p_carried, float p_delta_s,
			RigState &r_state) const;

private:
	/// The way that is left to the limb that strikes first, m; more than a step's where none does.
	float find_way(const Rig &p_rig, const Obstacles &p_obstacles, const Vec3 &p_normal, const Vec3 &p_surface,
			float p_delta_s, const RigState &p_state) const;
};

} // namespace ragdoll
