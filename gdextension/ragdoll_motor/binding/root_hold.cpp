// SPDX-License-Identifier: MIT
// RagdollBodies: the joint of the root to the world, and what else keeps the body upright.
#include "ragdoll_bodies.hpp"

#include "../../kinematics/binding/convert.hpp"

namespace godot {

using Joint = PhysicsServer3D;

namespace {

constexpr float PENDULUM_DEPTH = 5.0f; // Below the root's joint, m.
constexpr float PENDULUM_MASS = 0.5f; // Of the body's own.

PhysicsServer3D *server() {
	return PhysicsServer3D::get_singleton();
}

} // namespace

void RagdollBodies::free_assist() {
	if (assist_joint.is_valid()) {
		server()->free_rid(assist_joint);
		assist_joint = RID();
	}
	if (pendulum.is_valid()) {
		server()->free_rid(pendulum);
		pendulum = RID();
	}
	assist = ragdoll::RootMode::SOFT;
}

void RagdollBodies::set_assist(ragdoll::RootMode p_mode) {
	const bool wanted = ragdoll::is_free(p_mode);
	if (wanted ? assist == p_mode : assist == ragdoll::RootMode::SOFT) {
		return;
	}
	free_assist();
	if (p_mode == ragdoll::RootMode::PENDULUM) {
		make_pendulum();
	} else if (p_mode == ragdoll::RootMode::SELF_RIGHTING && righted_limb > 0) {
		assist_joint = make_joint(anchor, Transform3D(), std::size_t(righted_limb), true);
		for (const Vector3::Axis axis : { Vector3::AXIS_X, Vector3::AXIS_Y, Vector3::AXIS_Z }) {
			server()->generic_6dof_joint_set_flag(
					assist_joint, axis, Joint::G6DOF_JOINT_FLAG_ENABLE_LINEAR_MOTOR, false);
			server()->generic_6dof_joint_set_flag(assist_joint, axis, Joint::G6DOF_JOINT_FLAG_ENABLE_MOTOR, true);
		}
	}
	assist = wanted ? p_mode : ragdoll::RootMode::SOFT;
	assist_torque = -1.0f;
}

void RagdollBodies::make_pendulum() {
	// Thesis 8.4.3: "attaching a body with the center of mass to way outside and below the rag doll".
	ragdoll::RigState state;
	state.resize(specs.size());
	if (!read(state)) {
		return;
	}
	const ragdoll::Vec3 place = state.root - ragdoll::Vec3{ 0.0f, PENDULUM_DEPTH, 0.0f };
	const float mass = rig->get_mass() * PENDULUM_MASS;
	pendulum = server()->body_create();
	server()->body_set_mode(pendulum, Joint::BODY_MODE_RIGID);
	server()->body_set_param(pendulum, Joint::BODY_PARAM_MASS, mass);
	server()->body_set_param(pendulum, Joint::BODY_PARAM_INERTIA, Vector3(mass, mass, mass) * 0.1f);
	server()->body_set_state(pendulum, Joint::BODY_STATE_TRANSFORM, Transform3D(Basis(), from_core(place)));
	server()->body_set_state(pendulum, Joint::BODY_STATE_LINEAR_VELOCITY, from_core(state.linear[0]));
	server()->body_set_space(pendulum, space);
	server()->body_set_state(pendulum, Joint::BODY_STATE_CAN_SLEEP, false);
	assist_joint = make_joint(pendulum, Transform3D(Basis(), Vector3(0.0f, PENDULUM_DEPTH, 0.0f)), 0, true);
	for (const Vector3::Axis axis : { Vector3::AXIS_X, Vector3::AXIS_Y, Vector3::AXIS_Z }) {
		server()->generic_6dof_joint_set_flag(assist_joint, axis, Joint::G6DOF_JOINT_FLAG_ENABLE_LINEAR_LIMIT, true);
		server()->generic_6dof_joint_set_flag(assist_joint, axis, Joint::G6DOF_JOINT_FLAG_ENABLE_LINEAR_MOTOR, false);
		server()->generic_6dof_joint_set_flag(assist_joint, axis, Joint::G6DOF_JOINT_FLAG_ENABLE_MOTOR, true);
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
	const bool changed = hold.across != p_command.force_across || hold.up != p_command.force_up;
	const float axes[3] = { p_command.velocity.x, p_command.velocity.y, p_command.velocity.z };
	for (int i = 0; i < 3; i++) {
		const Vector3::Axis axis = Vector3::Axis(i);
		if (changed) {
			server()->generic_6dof_joint_set_flag(
					joints[0], axis, Joint::G6DOF_JOINT_FLAG_ENABLE_LINEAR_MOTOR, limits[i] > 0.0f);
			server()->generic_6dof_joint_set_param(
					joints[0], axis, Joint::G6DOF_JOINT_LINEAR_MOTOR_FORCE_LIMIT, limits[i]);
		}
		server()->generic_6dof_joint_set_param(
				joints[0], axis, Joint::G6DOF_JOINT_LINEAR_MOTOR_TARGET_VELOCITY, axes[i]);
	}
	hold.across = p_command.force_across;
	hold.up = p_command.force_up;
}

void RagdollBodies::draw_root(ragdoll::RootMode p_mode, const ragdoll::RootCommand &p_command,
		const ragdoll::Vec3 &p_turn, const ragdoll::Vec3 &p_trunk_turn) {
	set_kinematic(0, false);
	set_assist(p_mode);
	set_drive(0, p_command.torque > 0.0f ? Drive::MOTOR : Drive::FREE);
	set_torque(joints[0], p_command.torque, written[0].torque);
	set_forces(p_command);
	set_motors(joints[0], specs[0].axes.inverse().rotate(p_turn));
	if (!assist_joint.is_valid()) {
		return;
	}
	const bool swings = assist == ragdoll::RootMode::PENDULUM;
	const std::size_t limb = swings ? 0 : std::size_t(righted_limb);
	set_torque(assist_joint, p_command.assist_torque, assist_torque);
	set_motors(assist_joint, specs[limb].axes.inverse().rotate(swings ? p_turn : p_trunk_turn));
}

} // namespace godot
