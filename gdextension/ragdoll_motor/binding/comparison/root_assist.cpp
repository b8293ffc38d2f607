// SPDX-License-Identifier: MIT
#include "root_assist.hpp"

#include "../joint_motors.hpp"

#include <convert.hpp>

namespace godot {

namespace {

constexpr float PENDULUM_DEPTH = 5.0f; // Below the root's joint, m.
constexpr float PENDULUM_MASS = 0.5f; // Of the body's own.

} // namespace

RootAssist::RootAssist(ragdoll::RootMode p_mode, const Parts &p_parts) : _mode(p_mode) {
	if (p_mode == ragdoll::RootMode::PENDULUM && p_parts.state != nullptr) {
		make_pendulum(p_parts);
	} else if (p_mode == ragdoll::RootMode::SELF_RIGHTING && p_parts.trunk.body.is_valid()) {
		make_trunk_joint(p_parts);
	}
}

RootAssist::~RootAssist() {
	if (_joint.is_valid()) {
		server()->free_rid(_joint);
	}
	if (_pendulum.is_valid()) {
		server()->free_rid(_pendulum);
	}
}

void RootAssist::make_pendulum(const Parts &p_parts) {
	// Thesis 8.4.3: "attaching a body with the center of mass to way outside and below the rag doll".
	const ragdoll::Vec3 position = p_parts.state->root - ragdoll::Vec3{ 0.0f, PENDULUM_DEPTH, 0.0f };
	const float mass = p_parts.mass * PENDULUM_MASS;
	_pendulum = server()->body_create();
	server()->body_set_mode(_pendulum, PhysicsServer3D::BODY_MODE_RIGID);
	server()->body_set_param(_pendulum, PhysicsServer3D::BODY_PARAM_MASS, mass);
	server()->body_set_param(_pendulum, PhysicsServer3D::BODY_PARAM_INERTIA, Vector3(mass, mass, mass) * 0.1f);
	server()->body_set_state(
			_pendulum, PhysicsServer3D::BODY_STATE_TRANSFORM, Transform3D(Basis(), from_core(position)));
	server()->body_set_state(
			_pendulum, PhysicsServer3D::BODY_STATE_LINEAR_VELOCITY, from_core(p_parts.state->linear[0]));
	server()->body_set_space(_pendulum, p_parts.space);
	server()->body_set_state(_pendulum, PhysicsServer3D::BODY_STATE_CAN_SLEEP, false);
	const Transform3D frame(Basis(), Vector3(0.0f, PENDULUM_DEPTH, 0.0f));
	_joint = make_motor_joint(_pendulum, frame, p_parts.root.body, p_parts.root.frame);
	_axes = p_parts.root.axes;
	for (const Vector3::Axis axis : { Vector3::AXIS_X, Vector3::AXIS_Y, Vector3::AXIS_Z }) {
		server()->generic_6dof_joint_set_flag(
				_joint, axis, PhysicsServer3D::G6DOF_JOINT_FLAG_ENABLE_LINEAR_LIMIT, true);
		server()->generic_6dof_joint_set_flag(
				_joint, axis, PhysicsServer3D::G6DOF_JOINT_FLAG_ENABLE_LINEAR_MOTOR, false);
		server()->generic_6dof_joint_set_flag(_joint, axis, PhysicsServer3D::G6DOF_JOINT_FLAG_ENABLE_MOTOR, true);
	}
}

void RootAssist::make_trunk_joint(const Parts &p_parts) {
	_joint = make_motor_joint(p_parts.anchor, Transform3D(), p_parts.trunk.body, p_parts.trunk.frame);
	_axes = p_parts.trunk.axes;
	for (const Vector3::Axis axis : { Vector3::AXIS_X, Vector3::AXIS_Y, Vector3::AXIS_Z }) {
		server()->generic_6dof_joint_set_flag(
				_joint, axis, PhysicsServer3D::G6DOF_JOINT_FLAG_ENABLE_LINEAR_MOTOR, false);
		server()->generic_6dof_joint_set_flag(_joint, axis, PhysicsServer3D::G6DOF_JOINT_FLAG_ENABLE_MOTOR, true);
	}
}

void RootAssist::drive(const ragdoll::RootCommand &p_command) {
	if (_joint.is_valid()) {
		set_motor_torque(_joint, p_command.assist_torque, _torque);
		set_motor_velocity(_joint, _axes.inverse().rotate(p_command.assist_turn));
	}
}

} // namespace godot
