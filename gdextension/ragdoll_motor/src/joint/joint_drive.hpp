// SPDX-License-Identifier: MIT
#pragma once

#include "base/archive.hpp"
#include "base/vectors.hpp"
#include "joint/actuation.hpp"

#include <cstddef>
#include <memory>

namespace ragdoll {

class Rig;

/// What the joint of one limb gets for a step.
struct LimbCommand {
	Actuation mode = Actuation::VELOCITY_MOTOR;
	/// Target velocity relative to the parent (the root: to the world) in the limb's axes, rad/s. For
	/// the modes with a motor, and for LIMP (zero).
	Vec3 velocity;
	/// SPRING_TORQUE: the torque on the limb in world axes, N m; the parent gets its opposite.
	Vec3 torque;
	/// POSITION_MOTOR: the spring's target, relative to the parent.
	Quat target;
	Vec3 stiffness; ///< POSITION_MOTOR, about the limb's axes, N m/rad.
	Vec3 damping; ///< POSITION_MOTOR, N m s/rad.
	float max_torque = 0.0f; ///< N m
	float whole_torque = 0.0f; ///< The same before the muscles' limit, N m.
};

/// Parameters of the modes.
struct ControlSettings {
	float gain = 50.0f; ///< VELOCITY_MOTOR: how fast errors are corrected, 1/s.
	/// VELOCITY_MOTOR: speed of the motion (rad/s) at which a joint has hardly any torque left besides
	/// what that motion needs (Muscles); 0 leaves it the whole torque at any speed.
	float muscle_speed = 8.0f;
	/// How fast the root can be braked when it turns back to where the motion has it, rad/s^2; 0: at once.
	float root_deceleration = 0.0f;
	/// VELOCITY_MOTOR: share of the gain and of the greatest speed that corrections get.
	float eagerness = 1.0f;
	float angular_gain = 10.0f; ///< ANGULAR_MOTOR: the spring "in the speed domain" (thesis 8.3.1), 1/s.
	float torque_frequency = 8.0f; ///< SPRING_TORQUE: Hz.
	float torque_damping_ratio = 0.5f; ///< SPRING_TORQUE.
	float leak = 4.0f; ///< SPRING_TORQUE: a of dx/dt = i - a x (thesis 8.2.1), 1/s.
	float leak_weight = 8.0f; ///< SPRING_TORQUE: how much the leaky integral adds, 1/s.
	float position_frequency = 12.0f; ///< POSITION_MOTOR: Hz.
	float position_damping_ratio = 1.0f; ///< POSITION_MOTOR.
};

/// The motion of one limb relative to its parent (the root: to the world), and how far the simulation is off.
struct JointState {
	Quat actual; ///< The simulation now.
	Quat next; ///< Target at the end of the step.
	Vec3 forward; ///< Velocity of the motion, limb's axes, rad/s.
	Vec3 error; ///< Rotation vector from the simulation to the motion, limb's axes, rad.
	Vec3 velocity; ///< Velocity of the simulation, limb's axes, rad/s.
	Quat orientation; ///< Of the limb in the world.
	SpringSettings spring; ///< Of the limb.
};

/// Drives a joint in the modes that Controller does not know itself (comparison/thesis_joints.hpp).
class JointDrive {
public:
	JointDrive() = default;
	JointDrive(const JointDrive &) = delete;
	JointDrive &operator=(const JointDrive &) = delete;
	virtual ~JointDrive() = default;

	/// Writes what the joint gets in this step. The mode and the greatest torque are in the command already.
	virtual void command(std::size_t p_limb, const JointState &p_joint, const ControlSettings &p_settings,
			float p_delta_s, LimbCommand &r_command) = 0;
	/// Whether the joint to the world, the root's, can be driven so; it has a velocity motor otherwise.
	virtual bool drives_root(Actuation p_mode) const = 0;
	/// The body has been put elsewhere: what was before counts no more.
	virtual void reset() = 0;

	virtual void save(ArchiveWriter &p_archive) const = 0;
	virtual bool restore(ArchiveReader &p_archive) = 0;
};

/// Makes one for a ragdoll; the rig must live as long.
using JointDriveMaker = std::unique_ptr<JointDrive> (*)(const Rig &p_rig);

} // namespace ragdoll
