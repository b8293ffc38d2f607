// SPDX-License-Identifier: MIT
#include "limb_joint.hpp"

#include "joint_motors.hpp"

#include <convert.hpp>

#include <cmath>

namespace godot {

using Joint = PhysicsServer3D;

namespace {

const Vector3::Axis AXES[3] = { Vector3::AXIS_X, Vector3::AXIS_Y, Vector3::AXIS_Z };

/// Angles of rotations about X, then Y, then Z, each about the axes so far (the engine's order for the
/// equilibrium of angular springs), rad.
Vector3 euler_zyx(const ragdoll::Quat &p_rotation) {
	const ragdoll::Quat &q = p_rotation;
	const float sine = 2.0f * (q.w * q.y - q.z * q.x);
	return Vector3(std::atan2(2.0f * (q.w * q.x + q.y * q.z), 1.0f - 2.0f * (q.x * q.x + q.y * q.y)),
			std::asin(sine > 1.0f ? 1.0f : (sine < -1.0f ? -1.0f : sine)),
			std::atan2(2.0f * (q.w * q.z + q.x * q.y), 1.0f - 2.0f * (q.y * q.y + q.z * q.z)));
}

} // namespace

void LimbJoint::set_loose(bool p_loose) {
	if (_is_loose == p_loose) {
		return;
	}
	// A limb that is put follows its parent. With its infinite mass it would drag that along, which
	// it follows then: a body with one arm in DIRECT_SET flew off.
	_is_loose = p_loose;
	for (const Vector3::Axis axis : AXES) {
		server()->generic_6dof_joint_set_flag(_joint, axis, Joint::G6DOF_JOINT_FLAG_ENABLE_LINEAR_LIMIT, !p_loose);
	}
}

void LimbJoint::set_drive(Drive p_drive) {
	if (_drive == p_drive) {
		return;
	}
	_drive = p_drive;
	for (const Vector3::Axis axis : AXES) {
		server()->generic_6dof_joint_set_flag(
				_joint, axis, Joint::G6DOF_JOINT_FLAG_ENABLE_MOTOR, p_drive == Drive::MOTOR);
		server()->generic_6dof_joint_set_flag(
				_joint, axis, Joint::G6DOF_JOINT_FLAG_ENABLE_ANGULAR_SPRING, p_drive == Drive::SPRING);
	}
	_torque = -1.0f;
}

void LimbJoint::turn(const ragdoll::Vec3 &p_velocity) {
	const ragdoll::Vec3 local = _axes.inverse().rotate(p_velocity);
	const float axes[3] = { local.x, local.y, local.z };
	for (int i = 0; i < 3; i++) {
		if (_velocity[i] != axes[i]) {
			_velocity[i] = axes[i];
			// The engine's sign is the other way round for angular motors (not for linear ones).
			server()->generic_6dof_joint_set_param(
					_joint, AXES[i], Joint::G6DOF_JOINT_ANGULAR_MOTOR_TARGET_VELOCITY, -axes[i]);
		}
	}
}

void LimbJoint::pull(const ragdoll::LimbCommand &p_command) {
	const ragdoll::Vec3 stiffness = ragdoll::turned_inertia(p_command.stiffness, _axes.inverse());
	const ragdoll::Vec3 damping = ragdoll::turned_inertia(p_command.damping, _axes.inverse());
	const bool stiffer = (_stiffness - stiffness).length() + (_damping - damping).length() > 0.0f;
	_stiffness = stiffness;
	_damping = damping;
	const Vector3 stiff = from_core(stiffness);
	const Vector3 damped = from_core(damping);
	const Vector3 angles = -euler_zyx(_axes.inverse() * (_rest_inverse * p_command.target) * _axes);
	for (int i = 0; i < 3; i++) {
		if (stiffer) {
			server()->generic_6dof_joint_set_param(
					_joint, AXES[i], Joint::G6DOF_JOINT_ANGULAR_SPRING_STIFFNESS, stiff[i]);
			server()->generic_6dof_joint_set_param(
					_joint, AXES[i], Joint::G6DOF_JOINT_ANGULAR_SPRING_DAMPING, damped[i]);
		}
		server()->generic_6dof_joint_set_param(
				_joint, AXES[i], Joint::G6DOF_JOINT_ANGULAR_SPRING_EQUILIBRIUM_POINT, angles[i]);
	}
}

void LimbJoint::set_torque(float p_torque) {
	set_motor_torque(_joint, p_torque, _torque);
}

void LimbJoint::weaken(float p_share) {
	if (p_share < 1.0f && _drive == Drive::MOTOR && _torque > 0.0f) {
		set_torque(_torque * p_share);
	}
}

} // namespace godot
