// SPDX-License-Identifier: MIT
// RagdollBodies: the joint of the root to the world, and what else keeps the body upright.
#include "ragdoll_bodies.hpp"

#include <convert.hpp>

namespace godot {

using Joint = PhysicsServer3D;

namespace {

constexpr float PENDULUM_DEPTH = 5.0f; // Below the root's joint, m.
constexpr float PENDULUM_MASS = 0.5f; // Of the body's own.

} // namespace

void RagdollBodies::free_assist() {
	if (_assist_joint.is_valid()) {
		server()->free_rid(_assist_joint);
		_assist_joint = RID();
	}
	if (_pendulum.is_valid()) {
		server()->free_rid(_pendulum);
		_pendulum = RID();
	}
	_assist = ragdoll::RootMode::SOFT;
}

void RagdollBodies::set_assist(ragdoll::RootMode p_mode) {
	const bool wanted = ragdoll::is_free(p_mode);
	if (wanted ? _assist == p_mode : _assist == ragdoll::RootMode::SOFT) {
		return;
	}
	free_assist();
	if (p_mode == ragdoll::RootMode::PENDULUM) {
		make_pendulum();
	} else if (p_mode == ragdoll::RootMode::SELF_RIGHTING && _righted_limb > 0) {
		_assist_joint = make_joint(_anchor, Transform3D(), std::size_t(_righted_limb), true);
		for (const Vector3::Axis axis : { Vector3::AXIS_X, Vector3::AXIS_Y, Vector3::AXIS_Z }) {
			server()->generic_6dof_joint_set_flag(
					_assist_joint, axis, Joint::G6DOF_JOINT_FLAG_ENABLE_LINEAR_MOTOR, false);
			server()->generic_6dof_joint_set_flag(_assist_joint, axis, Joint::G6DOF_JOINT_FLAG_ENABLE_MOTOR, true);
		}
	}
	_assist = wanted ? p_mode : ragdoll::RootMode::SOFT;
	_assist_torque = -1.0f;
}

void RagdollBodies::make_pendulum() {
	// Thesis 8.4.3: "attaching a body with the center of mass to way outside and below the rag doll".
	ragdoll::RigState state;
	state.resize(_specs.size());
	if (!read(state)) {
		return;
	}
	const ragdoll::Vec3 position = state.root - ragdoll::Vec3{ 0.0f, PENDULUM_DEPTH, 0.0f };
	const float mass = _rig->get_mass() * PENDULUM_MASS;
	_pendulum = server()->body_create();
	server()->body_set_mode(_pendulum, Joint::BODY_MODE_RIGID);
	server()->body_set_param(_pendulum, Joint::BODY_PARAM_MASS, mass);
	server()->body_set_param(_pendulum, Joint::BODY_PARAM_INERTIA, Vector3(mass, mass, mass) * 0.1f);
	server()->body_set_state(_pendulum, Joint::BODY_STATE_TRANSFORM, Transform3D(Basis(), from_core(position)));
	server()->body_set_state(_pendulum, Joint::BODY_STATE_LINEAR_VELOCITY, from_core(state.linear[0]));
	server()->body_set_space(_pendulum, _space);
	server()->body_set_state(_pendulum, Joint::BODY_STATE_CAN_SLEEP, false);
	_assist_joint = make_joint(_pendulum, Transform3D(Basis(), Vector3(0.0f, PENDULUM_DEPTH, 0.0f)), 0, true);
	for (const Vector3::Axis axis : { Vector3::AXIS_X, Vector3::AXIS_Y, Vector3::AXIS_Z }) {
		server()->generic_6dof_joint_set_flag(_assist_joint, axis, Joint::G6DOF_JOINT_FLAG_ENABLE_LINEAR_LIMIT, true);
		server()->generic_6dof_joint_set_flag(_assist_joint, axis, Joint::G6DOF_JOINT_FLAG_ENABLE_LINEAR_MOTOR, false);
		server()->generic_6dof_joint_set_flag(_assist_joint, axis, Joint::G6DOF_JOINT_FLAG_ENABLE_MOTOR, true);
	}
}

void RagdollBodies::set_motors(const RID &p_joint, const ragdoll::Vec3 &p_turn) {
	const float axes[3] = { p_turn.x, p_turn.y, p_turn.z };
	for (int i = 0; i < 3; i++) {
		server()->generic_6dof_joint_set_param(
				p_joint, Vector3::Axis(i), Joint::G6DOF_JOINT_ANGULAR_MOTOR_TARGET_VELOCITY, -axes[i]);
	}
}

void RagdollBodies::set_forces(const ragdoll::RootCommand &p_command) {
	const float limits[3] = { p_command.force_across, p_command.force_up, p_command.force_across };
	const bool changed = _hold.across != p_command.force_across || _hold.up != p_command.force_up;
	const float axes[3] = { p_command.velocity.x, p_command.velocity.y, p_command.velocity.z };
	for (int i = 0; i < 3; i++) {
		const Vector3::Axis axis = Vector3::Axis(i);
		if (changed) {
			server()->generic_6dof_joint_set_flag(
					_joints[0], axis, Joint::G6DOF_JOINT_FLAG_ENABLE_LINEAR_MOTOR, limits[i] > 0.0f);
			server()->generic_6dof_joint_set_param(
					_joints[0], axis, Joint::G6DOF_JOINT_LINEAR_MOTOR_FORCE_LIMIT, limits[i]);
		}
		server()->generic_6dof_joint_set_param(
				_joints[0], axis, Joint::G6DOF_JOINT_LINEAR_MOTOR_TARGET_VELOCITY, axes[i]);
	}
	_hold.across = p_command.force_across;
	_hold.up = p_command.force_up;
}

void RagdollBodies::pull_root(ragdoll::RootMode p_mode, const ragdoll::RootCommand &p_command,
		const ragdoll::Vec3 &p_turn, const ragdoll::Vec3 &p_trunk_turn) {
	set_kinematic(0, false);
	set_assist(p_mode);
	set_drive(0, p_command.torque > 0.0f ? Drive::MOTOR : Drive::FREE);
	set_torque(_joints[0], p_command.torque, _written[0].torque);
	set_forces(p_command);
	if (p_command.push.length() > 0.0f) {
		server()->body_apply_central_force(_specs[0].body, from_core(p_command.push));
	}
	set_motors(_joints[0], _specs[0].axes.inverse().rotate(p_turn));
	if (!_assist_joint.is_valid()) {
		return;
	}
	const bool swings = _assist == ragdoll::RootMode::PENDULUM;
	const std::size_t limb = swings ? 0 : std::size_t(_righted_limb);
	set_torque(_assist_joint, p_command.assist_torque, _assist_torque);
	set_motors(_assist_joint, _specs[limb].axes.inverse().rotate(swings ? p_turn : p_trunk_turn));
}

} // namespace godot
