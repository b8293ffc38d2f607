// SPDX-License-Identifier: MIT
#pragma once

#include "gait/root_travel.hpp"
#include "joint/joint_drive.hpp"
#include "root/root_drive.hpp"

#include <memory>
#include <vector>

namespace ragdoll {

/// The modes of the thesis on which this motor is based, and one of the engine. Nobody needs them to drive people:
/// they are here to be measured against the modes that do (`./run bench tracking --all`, `./run bench gait`).
/// This header is the only door to them. They come in through the interfaces Travel and JointDrive, and are made
/// when somebody chooses them.
///
/// | mode | thesis | compared with | where |
/// |---|---|---|---|
/// | LOWEST_FOOT | 8.4.1 | INERTIAL | lowest_foot.hpp |
/// | CONTACTS | 8.4.2 | INERTIAL | lowest_contact.hpp |
/// | PENDULUM | 8.4.3 | GROUNDED | the binding's RootAssist: a weight of the engine's |
/// | SELF_RIGHTING | 8.4.4 | GROUNDED | drive_thesis_root(), and RootAssist: a joint of the engine's |
/// | SPRING_TORQUE | 8.2 | VELOCITY_MOTOR | thesis_joints.hpp |
/// | ANGULAR_MOTOR | 8.3 | VELOCITY_MOTOR | thesis_joints.hpp |
/// | POSITION_MOTOR | - | VELOCITY_MOTOR | thesis_joints.hpp: the engine's springs |

/// The estimator of LOWEST_FOOT or CONTACTS; null for other root modes.
std::unique_ptr<Travel> make_thesis_travel(RootMode p_mode, const std::vector<ContactPoint> &p_contacts);

/// What drives joints in SPRING_TORQUE, ANGULAR_MOTOR and POSITION_MOTOR. Keeps a reference to the rig.
std::unique_ptr<JointDrive> make_thesis_joints(const Rig &p_rig);

/// The root's command for a step in PENDULUM and SELF_RIGHTING: in the first the weight's joint turns as the root is
/// to turn, in the second the trunk's joint brings it along in the world, whatever its parent does.
/// @param p_turn the turning rate that the root is to have, limb's axes, rad/s
/// @param p_trunk the limb that SELF_RIGHTING keeps upright besides the root; -1 for none
/// @param p_strength multiplies the limits
RootCommand drive_thesis_root(RootMode p_mode, const RootSettings &p_settings, const RigState &p_actual,
		const Pose &p_now, const Pose &p_next, const Vec3 &p_turn, int p_trunk, float p_delta_s, float p_strength);

} // namespace ragdoll
