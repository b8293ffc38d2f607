// SPDX-License-Identifier: MIT
#include "ragdoll_bodies.hpp"

#include <convert.hpp>

#include <godot_cpp/classes/engine.hpp>
#include <godot_cpp/classes/physics_direct_body_state3d.hpp>
#include <godot_cpp/core/error_macros.hpp>

#include <utility>

namespace godot {

using Joint = PhysicsServer3D;

RagdollBodies::~RagdollBodies() {
	free_all();
}

void RagdollBodies::free_all() {
	_assist.reset();
	for (std::size_t i = 0; i < _is_set.size(); i++) {
		// Bodies that were held at a pose fall again, as far as they are still there.
		if (_is_set[i] && server()->body_get_direct_state(_specs[i].body) != nullptr) {
			set_kinematic(i, false);
		}
	}
	_is_set.clear();
	for (const LimbJoint &joint : _joints) {
		if (joint.get_rid().is_valid()) {
			server()->free_rid(joint.get_rid());
		}
	}
	_joints.clear();
	_anchor.free();
}

Transform3D RagdollBodies::frame_in_body(std::size_t p_limb) const {
	return Transform3D(Basis(from_core(_specs[p_limb].axes)), from_core((*_rig)[p_limb].centre * -1.0f));
}

void RagdollBodies::make(const ragdoll::Rig &p_rig, std::vector<JointSpec> p_specs, const RID &p_space) {
	free_all();
	_rig = &p_rig;
	_specs = std::move(p_specs);
	_space = p_space;
	_joints.assign(_specs.size(), LimbJoint());
	_is_set.assign(_specs.size(), false);
	_states.assign(_specs.size(), nullptr);
	_hold = Hold();
	_has_stepped = false;
	// A physics frame ends with its step; what is made between two is stepped by the next.
	const Engine *engine = Engine::get_singleton();
	_first_frame = engine->get_physics_frames() + (engine->is_in_physics_frame() ? 0 : 1);
	// The order of creation is the order of solving: from the trunk outwards, what is carried is right sooner.
	for (std::size_t i = 1; i < _specs.size(); i++) {
		const ragdoll::Segment &limb = p_rig[i];
		const ragdoll::Segment &parent = p_rig[limb.parent];
		const ragdoll::Quat relative = parent.rest.inverse() * limb.rest;
		const Transform3D frame(Basis(from_core(relative * _specs[i].axes)), from_core(limb.anchor - parent.centre));
		_joints[i] = LimbJoint(make_joint(_specs[limb.parent].body, frame, i), _specs[i].axes, relative);
		server()->joint_disable_collisions_between_bodies(_joints[i].get_rid(), true);
	}
	_anchor.make(_space);
	const RID hold = make_motor_joint(_anchor.get_rid(), Transform3D(), _specs[0].body, frame_in_body(0));
	_joints[0] = LimbJoint(hold, _specs[0].axes, ragdoll::Quat());
}

void RagdollBodies::remake() {
	const std::vector<JointSpec> kept = _specs;
	const RID where = _space;
	free_all();
	// Out in the opposite order: the engine gives a freed slot to the next that comes, and solves in
	// the order of slots.
	for (std::size_t i = kept.size(); i-- > 0;) {
		server()->body_set_space(kept[i].body, RID());
	}
	for (const JointSpec &spec : kept) {
		server()->body_set_space(spec.body, where);
	}
	make(*_rig, kept, where);
}

RID RagdollBodies::make_joint(const RID &p_a, const Transform3D &p_frame_a, std::size_t p_limb) {
	const JointSpec &spec = _specs[p_limb];
	const RID joint = server()->joint_create();
	server()->joint_make_generic_6dof(joint, p_a, p_frame_a, spec.body, frame_in_body(p_limb));
	// A new joint has no flag. The engine makes it anew for each limit: none is written in vain.
	for (int i = 0; i < 3; i++) {
		const Vector3::Axis axis = Vector3::Axis(i);
		server()->generic_6dof_joint_set_flag(joint, axis, Joint::G6DOF_JOINT_FLAG_ENABLE_LINEAR_LIMIT, true);
		if (spec.has_limits) {
			server()->generic_6dof_joint_set_flag(joint, axis, Joint::G6DOF_JOINT_FLAG_ENABLE_ANGULAR_LIMIT, true);
			server()->generic_6dof_joint_set_param(joint, axis, Joint::G6DOF_JOINT_ANGULAR_LOWER_LIMIT, spec.lower[i]);
			server()->generic_6dof_joint_set_param(joint, axis, Joint::G6DOF_JOINT_ANGULAR_UPPER_LIMIT, spec.upper[i]);
		}
	}
	return joint;
}

void RagdollBodies::prepare(bool p_self_collision) {
	for (std::size_t i = 0; i < _specs.size(); i++) {
		const RID &body = _specs[i].body;
		server()->body_set_mode(body, Joint::BODY_MODE_RIGID);
		server()->body_set_param(body, Joint::BODY_PARAM_INERTIA, from_core((*_rig)[i].inertia));
		server()->body_set_enable_continuous_collision_detection(body, true);
		server()->body_set_state(body, Joint::BODY_STATE_CAN_SLEEP, false);
		for (std::size_t j = 0; j < i; j++) {
			// Limbs that hang on the same one meet at its end: upper legs, upper arms.
			const bool meet = (*_rig)[i].parent == (*_rig)[j].parent;
			if (p_self_collision && !meet) {
				server()->body_remove_collision_exception(body, _specs[j].body);
			} else {
				server()->body_add_collision_exception(body, _specs[j].body);
			}
		}
	}
}

bool RagdollBodies::read(ragdoll::RigState &r_state) {
	for (std::size_t i = 0; i < _specs.size(); i++) {
		_states[i] = server()->body_get_direct_state(_specs[i].body);
		if (!_states[i]) {
			// Said once, not every tick.
			if (!_is_lost) {
				ERR_PRINT("RagdollMotor: a body is not in a physics space (any more).");
			}
			_is_lost = true;
			return false;
		}
		// With many people nothing of them is in the processor's cache any more: waiting for one body
		// after the other would take a twentieth of the motor's time.
		__builtin_prefetch(_states[i]);
	}
	for (std::size_t i = 0; i < _specs.size(); i++) {
		const PhysicsDirectBodyState3D *state = _states[i];
		const Transform3D transform = state->get_transform();
		r_state.orientations[i] = to_core(transform.basis);
		r_state.centres[i] = to_core(transform.origin);
		r_state.linear[i] = to_core(state->get_linear_velocity());
		r_state.angular[i] = to_core(state->get_angular_velocity());
	}
	r_state.root = _rig->joint_of(r_state, 0);
	r_state.gravity = find_gravity();
	_is_lost = false;
	return true;
}

ragdoll::Vec3 RagdollBodies::find_gravity() {
	const Vector3 total = _states[0]->get_total_gravity(); // Of areas, by the body's own scale.
	_has_stepped = _has_stepped || Engine::get_singleton()->get_physics_frames() > _first_frame;
	if (_has_stepped || total != Vector3()) {
		return to_core(total);
	}
	// The engine finds it in its steps: a body that is new has none yet.
	const Vector3 down = server()->area_get_param(_space, Joint::AREA_PARAM_GRAVITY_VECTOR);
	const double most = server()->area_get_param(_space, Joint::AREA_PARAM_GRAVITY);
	const double scale = server()->body_get_param(_specs[0].body, Joint::BODY_PARAM_GRAVITY_SCALE);
	return to_core(down * float(most * scale));
}

void RagdollBodies::put(const ragdoll::RigState &p_state) {
	for (std::size_t i = 0; i < _specs.size(); i++) {
		const RID &body = _specs[i].body;
		// A kinematic body would travel there within a step and fling the others about.
		const bool was_kinematic = _is_set[i];
		set_kinematic(i, false);
		const Transform3D transform(Basis(from_core(p_state.orientations[i])), from_core(p_state.centres[i]));
		server()->body_set_state(body, Joint::BODY_STATE_TRANSFORM, transform);
		server()->body_set_state(body, Joint::BODY_STATE_LINEAR_VELOCITY, from_core(p_state.linear[i]));
		server()->body_set_state(body, Joint::BODY_STATE_ANGULAR_VELOCITY, from_core(p_state.angular[i]));
		set_kinematic(i, was_kinematic);
	}
}

void RagdollBodies::set_kinematic(std::size_t p_limb, bool p_kinematic) {
	if (_is_set[p_limb] != p_kinematic) {
		_is_set[p_limb] = p_kinematic;
		server()->body_set_mode(_specs[p_limb].body, p_kinematic ? Joint::BODY_MODE_KINEMATIC : Joint::BODY_MODE_RIGID);
	}
}

void RagdollBodies::set_pose(std::size_t p_limb, const ragdoll::Quat &p_orientation, const ragdoll::Vec3 &p_joint) {
	set_kinematic(p_limb, true);
	const ragdoll::Vec3 origin = p_joint + p_orientation.rotate((*_rig)[p_limb].centre);
	server()->body_set_state(_specs[p_limb].body, Joint::BODY_STATE_TRANSFORM,
			Transform3D(Basis(from_core(p_orientation)), from_core(origin)));
}

void RagdollBodies::push(std::size_t p_limb, const ragdoll::LimbCommand &p_command) {
	const Vector3 torque = from_core(p_command.torque);
	server()->body_apply_torque(_specs[p_limb].body, torque);
	server()->body_apply_torque(_specs[(*_rig)[p_limb].parent].body, -torque);
}

void RagdollBodies::push_limbs(
		const std::vector<ragdoll::LimbCommand> &p_commands, const std::vector<ragdoll::LimbPush> &p_pushes) {
	for (std::size_t i = 0; i < _specs.size(); i++) {
		const ragdoll::LimbPush &push = p_pushes[i];
		if (p_commands[i].mode == ragdoll::Actuation::DIRECT_SET) {
			continue;
		}
		if (push.force.dot(push.force) > 0.0f) {
			server()->body_apply_central_force(_specs[i].body, from_core(push.force));
		}
		if (push.torque.dot(push.torque) > 0.0f) {
			server()->body_apply_torque(_specs[i].body, from_core(push.torque));
		}
	}
}

void RagdollBodies::weaken(std::size_t p_limb, float p_share) {
	_joints[p_limb].weaken(p_share);
	if (p_limb == 0 && p_share < 1.0f && _hold.across > 0.0f) {
		_hold.across *= p_share;
		for (const Vector3::Axis axis : { Vector3::AXIS_X, Vector3::AXIS_Z }) {
			server()->generic_6dof_joint_set_param(
					_joints[0].get_rid(), axis, Joint::G6DOF_JOINT_LINEAR_MOTOR_FORCE_LIMIT, _hold.across);
		}
	}
}

void RagdollBodies::strike(std::size_t p_limb, const Vector3 &p_impulse, const Vector3 &p_position) {
	server()->body_apply_impulse(_specs[p_limb].body, p_impulse, p_position);
}

void RagdollBodies::write(const std::vector<ragdoll::LimbCommand> &p_commands,
		const std::vector<ragdoll::Quat> &p_orientations, const std::vector<ragdoll::Vec3> &p_joints) {
	for (std::size_t i = 1; i < _specs.size(); i++) {
		const ragdoll::LimbCommand &command = p_commands[i];
		LimbJoint &joint = _joints[i];
		const bool hangs_on_set = p_commands[std::size_t((*_rig)[i].parent)].mode == ragdoll::Actuation::DIRECT_SET;
		joint.set_loose(command.mode == ragdoll::Actuation::DIRECT_SET && !hangs_on_set);
		if (command.mode == ragdoll::Actuation::DIRECT_SET) {
			joint.set_drive(LimbJoint::Drive::FREE);
			set_pose(i, p_orientations[i], p_joints[i]);
			continue;
		}
		set_kinematic(i, false);
		switch (command.mode) {
			case ragdoll::Actuation::SPRING_TORQUE:
				joint.set_drive(LimbJoint::Drive::FREE);
				push(i, command);
				break;
			case ragdoll::Actuation::POSITION_MOTOR:
				joint.set_drive(LimbJoint::Drive::SPRING);
				joint.pull(command);
				break;
			default:
				joint.set_drive(LimbJoint::Drive::MOTOR);
				joint.set_torque(command.max_torque);
				joint.turn(command.velocity);
				break;
		}
	}
}

RootAssist::Handle RagdollBodies::find_handle(std::size_t p_limb) const {
	return { _specs[p_limb].body, frame_in_body(p_limb), _specs[p_limb].axes };
}

void RagdollBodies::set_assist(ragdoll::RootMode p_mode) {
	if (!ragdoll::is_free(p_mode)) {
		_assist.reset();
	} else if (!_assist || _assist->get_mode() != p_mode) {
		_assist.reset(); // What the last mode needed goes first.
		_assist = make_assist(p_mode);
	}
}

std::unique_ptr<RootAssist> RagdollBodies::make_assist(ragdoll::RootMode p_mode) {
	ragdoll::RigState state;
	state.resize(_specs.size());
	RootAssist::Parts parts;
	parts.space = _space;
	parts.anchor = _anchor.get_rid();
	parts.root = find_handle(0);
	if (_righted_limb > 0) {
		parts.trunk = find_handle(std::size_t(_righted_limb));
	}
	parts.mass = _rig->get_mass();
	parts.state = read(state) ? &state : nullptr;
	return std::make_unique<RootAssist>(p_mode, parts);
}

void RagdollBodies::set_forces(const ragdoll::RootCommand &p_command) {
	const float limits[3] = { p_command.force_across, p_command.force_up, p_command.force_across };
	const bool changed = _hold.across != p_command.force_across || _hold.up != p_command.force_up;
	const float axes[3] = { p_command.velocity.x, p_command.velocity.y, p_command.velocity.z };
	for (int i = 0; i < 3; i++) {
		const Vector3::Axis axis = Vector3::Axis(i);
		if (changed) {
			server()->generic_6dof_joint_set_flag(
					_joints[0].get_rid(), axis, Joint::G6DOF_JOINT_FLAG_ENABLE_LINEAR_MOTOR, limits[i] > 0.0f);
			server()->generic_6dof_joint_set_param(
					_joints[0].get_rid(), axis, Joint::G6DOF_JOINT_LINEAR_MOTOR_FORCE_LIMIT, limits[i]);
		}
		server()->generic_6dof_joint_set_param(
				_joints[0].get_rid(), axis, Joint::G6DOF_JOINT_LINEAR_MOTOR_TARGET_VELOCITY, axes[i]);
	}
	_hold.across = p_command.force_across;
	_hold.up = p_command.force_up;
}

void RagdollBodies::hold_root(const ragdoll::Quat &p_orientation, const ragdoll::Vec3 &p_joint) {
	// A kinematic body would drag the anchor along with any force, which the solver remembers when it lets go.
	_joints[0].set_drive(LimbJoint::Drive::FREE);
	if (_hold.across != 0.0f || _hold.up != 0.0f) {
		set_forces({});
	}
	set_pose(0, p_orientation, p_joint);
}

void RagdollBodies::pull_root(
		ragdoll::RootMode p_mode, const ragdoll::RootCommand &p_command, const ragdoll::Vec3 &p_turn) {
	set_kinematic(0, false);
	set_assist(p_mode);
	_joints[0].set_drive(p_command.torque > 0.0f ? LimbJoint::Drive::MOTOR : LimbJoint::Drive::FREE);
	_joints[0].set_torque(p_command.torque);
	set_forces(p_command);
	if (p_command.push.length() > 0.0f) {
		server()->body_apply_central_force(_specs[0].body, from_core(p_command.push));
	}
	set_motor_velocity(_joints[0].get_rid(), _specs[0].axes.inverse().rotate(p_turn));
	if (_assist) {
		_assist->drive(p_command);
	}
}

} // namespace godot
