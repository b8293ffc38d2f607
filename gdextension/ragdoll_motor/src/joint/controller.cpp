// SPDX-License-Identifier: MIT
#include "joint/controller.hpp"

#include <algorithm>

namespace ragdoll {

float braking_speed(float p_error, float p_deceleration) {
	return std::sqrt(std::max(2.0f * p_deceleration * p_error, 0.0f));
}

Controller::Controller(const Rig &p_rig, JointDriveMaker p_make_others) :
		_rig(&p_rig), _muscles(p_rig.size()), _turned(p_rig.size()), _make_others(p_make_others) {}

void Controller::reset() {
	if (_others) {
		_others->reset();
	}
	_muscles.reset();
}

void Controller::compute(const RigState &p_actual, const Pose &p_now, const Pose &p_next, float p_delta_s,
		const ActuationTable &p_table, std::vector<LimbCommand> &r_commands) {
	r_commands.resize(_rig->size());
	_turned.find(*_rig, p_actual);
	for (std::size_t i = 0; i < _rig->size(); i++) {
		LimbCommand &command = r_commands[i];
		command.mode = p_table.get_mode(i);
		command.max_torque = (*_rig)[i].max_torque * p_table.get_strength(i);
		command.whole_torque = command.max_torque;
		JointState joint = find_joint(i, p_actual, p_now, p_next, p_delta_s);
		if (command.mode == Actuation::VELOCITY_MOTOR) {
			command_velocity(i, joint, p_delta_s, command);
		} else if (command.mode == Actuation::DIRECT_SET || command.mode == Actuation::LIMP) {
			command.velocity = {};
		} else {
			command_other(i, joint, p_table, p_delta_s, command);
		}
	}
}

void Controller::command_other(std::size_t p_limb, JointState &r_joint, const ActuationTable &p_table, float p_delta_s,
		LimbCommand &r_command) {
	if (!_others && _make_others) {
		_others = _make_others(*_rig);
	}
	if (!_others) {
		r_command.velocity = {};
	} else if ((*_rig)[p_limb].parent < 0 && !_others->drives_root(r_command.mode)) {
		// The root's joint leads to the world and always has a motor.
		command_velocity(p_limb, r_joint, p_delta_s, r_command);
	} else {
		r_joint.spring = p_table.get_spring(p_limb);
		_others->command(p_limb, r_joint, settings, p_delta_s, r_command);
	}
}

JointState Controller::find_joint(
		std::size_t p_limb, const RigState &p_actual, const Pose &p_now, const Pose &p_next, float p_delta_s) const {
	const int parent = (*_rig)[p_limb].parent;
	const Quat &world = p_actual.orientations[p_limb];
	Quat actual = world;
	Quat now = p_now.orientations[p_limb];
	JointState result;
	result.next = p_next.orientations[p_limb];
	result.velocity = p_actual.angular[p_limb];
	if (parent >= 0) {
		actual = p_actual.orientations[parent].inverse() * actual;
		now = p_now.orientations[parent].inverse() * now;
		result.next = p_next.orientations[parent].inverse() * result.next;
		result.velocity = result.velocity - p_actual.angular[parent];
	}
	result.velocity = world.inverse().rotate(result.velocity);
	result.actual = actual;
	result.orientation = world;
	result.forward = log(now.inverse() * result.next) * (1.0f / p_delta_s);
	result.error = log(actual.inverse() * now);
	return result;
}

void Controller::command_velocity(
		std::size_t p_limb, const JointState &p_joint, float p_delta_s, LimbCommand &r_command) {
	const float gain = std::min(settings.gain * settings.eagerness, 1.0f / p_delta_s);
	Vec3 correction = p_joint.error * gain;
	const float error = p_joint.error.length();
	const bool is_root = (*_rig)[p_limb].parent < 0;
	// A leg brakes as if it were stretched: with the inertia of the present pose, less where it is bent,
	// feet that have come down skate more (bench gait, walk at 1.2 m/s: 3.0 instead of 2.6 cm/s).
	const bool is_leg = _rig->is_in_leg(p_limb);
	const Vec3 &turned = is_leg ? _rig->get_subtree_inertia(p_limb) : _turned[p_limb];
	if (!is_root && error > 0.0f) {
		const float inertia = p_joint.error.scaled(turned).length() / error;
		const float fastest = settings.eagerness * braking_speed(error, r_command.max_torque / inertia);
		correction = correction.limited(fastest);
	}
	if (is_root && settings.root_deceleration > 0.0f) {
		correction = correction.limited(braking_speed(error, settings.root_deceleration));
	}
	r_command.velocity = p_joint.forward + correction;
	// Legs are spared: swinging takes nearly all their torque, and a leg that comes down has to bear.
	if (!is_root && !is_leg && settings.muscle_speed > 0.0f) {
		const Vec3 missing = r_command.velocity - p_joint.velocity;
		r_command.max_torque = _muscles.get_torque(
				p_limb, p_joint.forward, missing, turned, settings.muscle_speed, p_delta_s, r_command.max_torque);
	}
}

void Controller::save(ArchiveWriter &p_archive) const {
	_muscles.save(p_archive);
	p_archive.put(_others != nullptr);
	if (_others) {
		_others->save(p_archive);
	}
}

bool Controller::restore(ArchiveReader &p_archive) {
	bool has_others = false;
	if (!_muscles.restore(p_archive) || !p_archive.get(has_others) || (has_others && !_make_others)) {
		return false;
	}
	_others = has_others ? _make_others(*_rig) : nullptr;
	return !_others || _others->restore(p_archive);
}

void place_limbs(const Rig &p_rig, const RigState &p_actual, const Pose &p_next, float p_delta_s,
		const ActuationTable &p_table, std::vector<Quat> &r_orientations, std::vector<Vec3> &r_joints) {
	r_orientations.resize(p_rig.size());
	r_joints.resize(p_rig.size());
	for (std::size_t i = 0; i < p_rig.size(); i++) {
		const Segment &limb = p_rig[i];
		if (p_table.get_mode(i) == Actuation::DIRECT_SET) {
			r_orientations[i] = slerp(p_actual.orientations[i], p_next.orientations[i], p_table.get_arrival(i));
			const Vec3 from = limb.parent < 0 ? p_rig.joint_of(p_actual, i) : Vec3();
			r_joints[i] = limb.parent < 0 ? from + (p_next.root - from) * p_table.get_arrival(i)
										  : r_joints[limb.parent] + r_orientations[limb.parent].rotate(limb.anchor);
			continue;
		}
		const Vec3 turn = p_actual.orientations[i].inverse().rotate(p_actual.angular[i] * p_delta_s);
		r_orientations[i] = p_actual.orientations[i] * exp(turn);
		r_joints[i] = p_actual.centres[i] + p_actual.linear[i] * p_delta_s - r_orientations[i].rotate(limb.centre);
	}
}

} // namespace ragdoll
