// SPDX-License-Identifier: MIT
#include "joint/controller.hpp"

#include <algorithm>

namespace ragdoll {

namespace {

float chosen(float p_own, float p_general) {
	return p_own > 0.0f ? p_own : p_general;
}

} // namespace

float braking_speed(float p_error, float p_deceleration) {
	return std::sqrt(std::max(2.0f * p_deceleration * p_error, 0.0f));
}

Controller::Controller(const Rig &p_rig) :
		_rig(&p_rig), _muscles(p_rig.size()), _turned(p_rig.size()), _integrals(p_rig.size(), 0.0f) {}

void Controller::reset() {
	std::fill(_integrals.begin(), _integrals.end(), 0.0f);
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
		const Relative state = relative(i, p_actual, p_now, p_next, p_delta_s);
		const bool is_root = (*_rig)[i].parent < 0;
		switch (command.mode) {
			case Actuation::VELOCITY_MOTOR:
				command_velocity(i, state, p_delta_s, command);
				break;
			case Actuation::ANGULAR_MOTOR:
				command.velocity = state.error * std::min(settings.angular_gain, 1.0f / p_delta_s);
				break;
			case Actuation::SPRING_TORQUE:
				if (is_root) { // Its joint leads to the world and always has a motor.
					command_velocity(i, state, p_delta_s, command);
					break;
				}
				command_torque(i, state, p_actual.orientations[i], p_table.get_spring(i), p_delta_s, command);
				break;
			case Actuation::POSITION_MOTOR:
				if (is_root) {
					command_velocity(i, state, p_delta_s, command);
					break;
				}
				command_position(i, state, p_table.get_spring(i), p_delta_s, command);
				break;
			case Actuation::DIRECT_SET:
			case Actuation::LIMP:
				command.velocity = {};
				break;
		}
	}
}

Controller::Relative Controller::relative(
		std::size_t p_limb, const RigState &p_actual, const Pose &p_now, const Pose &p_next, float p_delta_s) const {
	const int parent = (*_rig)[p_limb].parent;
	const Quat &world = p_actual.orientations[p_limb];
	Quat actual = world;
	Quat now = p_now.orientations[p_limb];
	Relative result;
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
	result.forward = log(now.inverse() * result.next) * (1.0f / p_delta_s);
	result.error = log(actual.inverse() * now);
	return result;
}

void Controller::command_velocity(
		std::size_t p_limb, const Relative &p_relative, float p_delta_s, LimbCommand &r_command) {
	const float gain = std::min(settings.gain * settings.eagerness, 1.0f / p_delta_s);
	Vec3 correction = p_relative.error * gain;
	const float error = p_relative.error.length();
	const bool is_root = (*_rig)[p_limb].parent < 0;
	// A leg brakes as if it were stretched: with the inertia of the present pose, less where it is bent,
	// feet that have come down skate more (bench gait, walk at 1.2 m/s: 3.0 instead of 2.6 cm/s).
	const bool is_leg = _rig->is_in_leg(p_limb);
	const Vec3 &turned = is_leg ? _rig->get_subtree_inertia(p_limb) : _turned[p_limb];
	if (!is_root && error > 0.0f) {
		const float inertia = p_relative.error.scaled(turned).length() / error;
		const float fastest = settings.eagerness * braking_speed(error, r_command.max_torque / inertia);
		correction = correction.limited(fastest);
	}
	if (is_root && settings.root_deceleration > 0.0f) {
		correction = correction.limited(braking_speed(error, settings.root_deceleration));
	}
	r_command.velocity = p_relative.forward + correction;
	// Legs are spared: swinging takes nearly all their torque, and a leg that comes down has to bear.
	if (!is_root && !is_leg && settings.muscle_speed > 0.0f) {
		const Vec3 missing = r_command.velocity - p_relative.velocity;
		r_command.max_torque = _muscles.get_torque(
				p_limb, p_relative.forward, missing, turned, settings.muscle_speed, p_delta_s, r_command.max_torque);
	}
}

void Controller::command_torque(std::size_t p_limb, const Relative &p_relative, const Quat &p_orientation,
		const SpringSettings &p_spring, float p_delta_s, LimbCommand &r_command) {
	const float angle = p_relative.error.length();
	float &integral = _integrals[p_limb];
	// dx/dt = i - a x over the step, exactly, with the input held.
	const float kept = std::exp(-settings.leak * p_delta_s);
	integral = integral * kept + angle * (1.0f - kept) / settings.leak;
	const float omega = TAU * chosen(p_spring.frequency, settings.torque_frequency);
	const float ratio = chosen(p_spring.damping_ratio, settings.torque_damping_ratio);
	const Vec3 &inertia = _rig->get_subtree_inertia(p_limb);
	const Vec3 &own = _rig->get_own_inertia(p_limb);
	const Vec3 stiffness = inertia * (omega * omega * (1.0f + settings.leak_weight * integral));
	const Vec3 damping = inertia * (2.0f * ratio * omega);
	// Taken at the end of the step, as if the limb turned alone (Tan, Liu, Turk 2011, "Stable
	// proportional-derivative controllers", eq. 4): within a step the limbs beyond its joints do not
	// turn with it. Explicit, the thesis's spring explodes.
	const Vec3 coming = p_relative.error - p_relative.velocity * p_delta_s;
	const Vec3 pull = coming.scaled(stiffness) - p_relative.velocity.scaled(damping);
	const Vec3 held_back = (damping + stiffness * p_delta_s) * p_delta_s;
	const Vec3 torque = { pull.x / (1.0f + held_back.x / own.x), pull.y / (1.0f + held_back.y / own.y),
		pull.z / (1.0f + held_back.z / own.z) };
	r_command.torque = p_orientation.rotate(torque.limited(r_command.max_torque));
}

void Controller::command_position(std::size_t p_limb, const Relative &p_relative, const SpringSettings &p_spring,
		float p_delta_s, LimbCommand &r_command) const {
	const float omega = TAU * chosen(p_spring.frequency, settings.position_frequency);
	const float ratio = chosen(p_spring.damping_ratio, settings.position_damping_ratio);
	const Vec3 &inertia = _rig->get_subtree_inertia(p_limb);
	r_command.stiffness = inertia * (omega * omega);
	r_command.damping = inertia * (2.0f * ratio * omega);
	// A damper holds back what moves anyway: the target lies ahead by damping / stiffness.
	const Quat ahead = p_relative.next * exp(p_relative.forward * (2.0f * ratio / omega));
	// The engine does not limit a spring's torque: it is asked for no more than the limit gives.
	const Vec3 wanted = log(p_relative.actual.inverse() * ahead);
	const float torque = wanted.scaled(r_command.stiffness).length();
	const Vec3 held_back = r_command.damping + r_command.stiffness * p_delta_s;
	const float most = r_command.max_torque + p_relative.velocity.scaled(held_back).length();
	r_command.target = p_relative.actual * exp(torque > most ? wanted * (most / torque) : wanted);
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
