// SPDX-License-Identifier: MIT
#pragma once

#include "gait/root_travel.hpp"
#include "joint/joint_drive.hpp"

#include <memory>
#include <vector>

namespace ragdoll {

/// The modes of the thesis on which this motor is based, and one of the engine. Nobody needs them to drive people:
/// they are here to be measured against the modes that do (`./run bench tracking --all`, `./run bench gait`).
/// This header is the only door to them; they come in through the interfaces Travel and JointDrive.
///
/// | mode | thesis | compared with | where |
/// |---|---|---|---|
/// | LOWEST_FOOT | 8.4.1 | INERTIAL | lowest_foot.hpp |
/// | CONTACTS | 8.4.2 | INERTIAL | lowest_contact.hpp |
/// | PENDULUM | 8.4.3 | GROUNDED | the binding's RootAssist: a weight of the engine's |
/// | SELF_RIGHTING | 8.4.4 | GROUNDED | find_righting_turn(), and RootAssist: a joint of the engine's |
/// | SPRING_TORQUE | 8.2 | VELOCITY_MOTOR | thesis_joints.hpp |
/// | ANGULAR_MOTOR | 8.3 | VELOCITY_MOTOR | thesis_joints.hpp |
/// | POSITION_MOTOR | - | VELOCITY_MOTOR | thesis_joints.hpp: the engine's springs |

/// The estimators of the root modes LOWEST_FOOT and CONTACTS.
std::vector<ModeTravel> make_thesis_travels(const std::vector<ContactPoint> &p_contacts);

/// What drives joints in SPRING_TORQUE, ANGULAR_MOTOR and POSITION_MOTOR. Keeps a reference to the rig.
std::unique_ptr<JointDrive> make_thesis_joints(const Rig &p_rig);

/// SELF_RIGHTING: the turning rate (rad/s, limb's axes) that brings a limb along in the world, whatever its parent
/// does: the trunk is kept upright by it.
/// @param p_gain how fast errors are corrected, 1/s
Vec3 find_righting_turn(const Quat &p_actual, const Quat &p_now, const Quat &p_next, float p_delta_s, float p_gain);

} // namespace ragdoll
