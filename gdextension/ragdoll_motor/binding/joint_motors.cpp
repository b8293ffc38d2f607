// SPDX-License-Identifier: MIT
#include "joint_motors.hpp"

namespace godot {

RID make_motor_joint(const RID &p_a, const Transform3D &p_frame_a, const RID &p_b, const Transform3D &p_frame_b) {
	const RID joint = server()->joint_create();
	server()->joint_make_generic_6dof(joint, p_a, p_frame_a, p_b, p_frame_b);
	for (int i = 0; i < 3; i++) {
		server()->generic_6dof_joint_set_flag(
				joint, Vector3::Axis(i), PhysicsServer3D::G6DOF_JOINT_FLAG_ENABLE_LINEAR_MOTOR, true);
	}
	return joint;
}

void set_motor_velocity(const RID &p_joint, const ragdoll::Vec3 &p_velocity) {
	const float axes[3] = { p_velocity.x, p_velocity.y, p_velocity.z };
	for (int i = 0; i < 3; i++) {
		// The engine's sign is the other way round for angular motors (not for linear ones).
		server()->generic_6dof_joint_set_param(
				p_joint, Vector3::Axis(i), PhysicsServer3D::G6DOF_JOINT_ANGULAR_MOTOR_TARGET_VELOCITY, -axes[i]);
	}
}

void set_motor_torque(const RID &p_joint, float p_torque, float &r_written) {
	if (r_written == p_torque) {
		return;
	}
	r_written = p_torque;
	for (int i = 0; i < 3; i++) {
		server()->generic_6dof_joint_set_param(
				p_joint, Vector3::Axis(i), PhysicsServer3D::G6DOF_JOINT_ANGULAR_MOTOR_FORCE_LIMIT, p_torque);
	}
}

} // namespace godot
