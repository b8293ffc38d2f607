// SPDX-License-Identifier: MIT
#pragma once

#include "joint/controller.hpp"

namespace ragdoll {

/// A damped spring that pulls at a target, in the words of Unreal Engine's Physics Control: what it
/// would do to the limb and all that hangs on it alone.
struct DriveStrength {
	float strength = 0.0f; ///< How many swings a second it would make undamped, Hz; 0 is none.
	float damping_ratio = 1.0f; ///< 1 comes to rest fastest without overshooting.
	float most = 0.0f; ///< Greatest force or torque, N or N m; 0 does not limit it.
};

/// How one limb is controlled.
struct LimbControl {
	/// How the joint follows the motion in the parent's space.
	Actuation mode = Actuation::VELOCITY_MOTOR;
	float strength = 1.0f; ///< Multiplies the joint's greatest torque.
	/// Parent space: the joint's springs, of the modes that have them (0 strength takes the mode's own), and
	/// the joint's greatest torque, N m (0 takes the limb's own). The joint itself holds the position.
	DriveStrength parent_angular;
	/// World space: pulls towards where the motion has the limb in the world, besides.
	DriveStrength world_angular;
	DriveStrength world_linear;
	/// 1: the limb is where physics leaves it; 0: kinematic, exactly where the motion has it. Between, it is
	/// simulated, and shown so far from the one to the other.
	float physics_blend = 1.0f;
};

/// Lets a limb's joint do what a control says of the parent's space, and be shown as it says, within a time, s.
/// @param p_usual gives the springs' frequencies where the control has none
void apply_to_joint(const LimbControl &p_control, const Rig &p_rig, const ControlSettings &p_usual, std::size_t p_limb,
		float p_blend_s, ActuationTable &r_table);

/// The limbs' orientations, and the centre of the root's body (m), as they are shown: between the motion and the
/// simulation, by the limbs' physics blend.
/// @param p_motion at the end of the last step
void blend_shown(const Rig &p_rig, const ActuationTable &p_table, const Pose &p_motion, const RigState &p_state,
		std::vector<Quat> &r_orientations, Vec3 &r_root_centre);

} // namespace ragdoll
