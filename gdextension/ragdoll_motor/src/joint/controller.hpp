// SPDX-License-Identifier: MIT
#pragma once

#include "body/composite_inertia.hpp"
#include "body/rig.hpp"
#include "joint/actuation.hpp"
#include "joint/muscles.hpp"

#include <cstddef>
#include <vector>

namespace ragdoll {

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

/// Turns the limbs' present and target orientations into commands for the joints.
///
/// Every limb is driven relative to its parent. Its target is the *motion's* parent-relative
/// orientation: targets computed from the simulated parent are unstable.
class Controller {
public:
	Controller() = default;
	/// Keeps a reference: the rig must live as long.
	explicit Controller(const Rig &p_rig);

	ControlSettings settings;

	/// @param p_now the motion at the beginning of the step
	/// @param p_next the motion at its end
	void compute(const RigState &p_actual, const Pose &p_now, const Pose &p_next, float p_delta_s,
			const ActuationTable &p_table, std::vector<LimbCommand> &r_commands);
	/// Forgets the integrals.
	void reset();

	void save(ArchiveWriter &p_archive) const {
		p_archive.put_all(_integrals);
		_muscles.save(p_archive);
	}
	bool restore(ArchiveReader &p_archive) { return p_archive.get_all(_integrals) && _muscles.restore(p_archive); }

private:
	/// The motion of one limb relative to its parent, and how far the simulation is off.
	struct Relative {
		Quat actual; ///< The simulation now.
		Quat next; ///< Target at the end of the step.
		Vec3 forward; ///< Velocity of the motion, limb's axes, rad/s.
		Vec3 error; ///< Rotation vector from the simulation to the motion, limb's axes, rad.
		Vec3 velocity; ///< Velocity of the simulation, limb's axes, rad/s.
	};

	Relative relative(
			std::size_t p_limb, const RigState &p_actual, const Pose &p_now, const Pose &p_next, float p_delta_s) const;
	void command_velocity(std::size_t p_limb, const Relative &p_relative, float p_delta_s, LimbCommand &r_command);
	void command_torque(std::size_t p_limb, const Relative &p_relative, const Quat &p_orientation,
			const SpringSettings &p_spring, float p_delta_s, LimbCommand &r_command);
	void command_position(std::size_t p_limb, const Relative &p_relative, const SpringSettings &p_spring,
			float p_delta_s, LimbCommand &r_command) const;

	const Rig *_rig = nullptr;
	Muscles _muscles;
	CompositeInertia _turned; // In the present pose.
	std::vector<float> _integrals; // SPRING_TORQUE's leaky integrators, rad s.
};

/// The most a correction may go at (rad/s or m/s), so that the motor can still brake it: the speed from
/// which the greatest deceleration (rad/s^2 or m/s^2) stops within the error (rad or m).
float braking_speed(float p_error, float p_deceleration);

/// Where DIRECT_SET puts limbs: parents first, each where its joint meets the parent (thesis 8.1.1,
/// eq. 1-4), the others where they are about to be.
/// @param r_orientations world orientation of each limb at the end of the step
/// @param r_joints world position of each limb's joint at the end of the step, m
void place_limbs(const Rig &p_rig, const RigState &p_actual, const Pose &p_next, float p_delta_s,
		const ActuationTable &p_table, std::vector<Quat> &r_orientations, std::vector<Vec3> &r_joints);

} // namespace ragdoll
