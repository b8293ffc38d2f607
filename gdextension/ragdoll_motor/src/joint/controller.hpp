// SPDX-License-Identifier: MIT
#pragma once

#include "body/composite_inertia.hpp"
#include "body/rig.hpp"
#include "joint/joint_drive.hpp"
#include "joint/muscles.hpp"

#include <cstddef>
#include <memory>
#include <vector>

namespace ragdoll {

/// Turns the limbs' present and target orientations into commands for the joints.
///
/// Every limb is driven relative to its parent. Its target is the *motion's* parent-relative
/// orientation: targets computed from the simulated parent are unstable.
class Controller {
public:
	/// Keeps a reference: the rig must live as long.
	/// @param p_make_others makes what drives joints in all modes but VELOCITY_MOTOR, DIRECT_SET and LIMP, when a
	/// limb is in one of them for the first time; null: they hang limp
	explicit Controller(const Rig &p_rig, JointDriveMaker p_make_others = nullptr);

	ControlSettings settings;

	/// @param p_now the motion at the beginning of the step
	/// @param p_next the motion at its end
	void compute(const RigState &p_actual, const Pose &p_now, const Pose &p_next, float p_delta_s,
			const ActuationTable &p_table, std::vector<LimbCommand> &r_commands);
	/// What each joint turned in the pose of the last compute().
	const CompositeInertia &get_inertia() const { return _turned; }
	/// The body has been put elsewhere: what was before counts no more.
	void reset();

	void save(ArchiveWriter &p_archive) const;
	bool restore(ArchiveReader &p_archive);

private:
	JointState find_joint(
			std::size_t p_limb, const RigState &p_actual, const Pose &p_now, const Pose &p_next, float p_delta_s) const;
	void command_velocity(std::size_t p_limb, const JointState &p_joint, float p_delta_s, LimbCommand &r_command);
	/// Drives a joint in a mode that is not known here.
	void command_other(std::size_t p_limb, JointState &r_joint, const ActuationTable &p_table, float p_delta_s,
			LimbCommand &r_command);

	const Rig *_rig = nullptr;
	Muscles _muscles;
	CompositeInertia _turned; // In the present pose.
	JointDriveMaker _make_others = nullptr;
	std::unique_ptr<JointDrive> _others; // The modes that are not known here; null until one is chosen.
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
