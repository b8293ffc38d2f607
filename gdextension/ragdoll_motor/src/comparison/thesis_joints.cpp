// SPDX-License-Identifier: MIT
#include "comparison/thesis_joints.hpp"

#include <algorithm>

namespace ragdoll {

namespace {

float chosen(float p_own, float p_general) {
	return p_own > 0.0f ? p_own : p_general;
}

} // namespace

void ThesisJoints::command(std::size_t p_limb, const JointState &p_joint, const ControlSettings &p_settings,
		float p_delta_s, LimbCommand &r_command) {
	switch (r_command.mode) {
		case Actuation::ANGULAR_MOTOR:
			r_command.velocity = p_joint.error * std::min(p_settings.angular_gain, 1.0f / p_delta_s);
			break;
		case Actuation::SPRING_TORQUE:
			command_torque(p_limb, p_joint, p_settings, p_delta_s, r_command);
			break;
		case Actuation::POSITION_MOTOR:
			command_position(p_limb, p_joint, p_settings, p_delta_s, r_command);
			break;
		default:
			break;
	}
}

void ThesisJoints::reset() {
	std::fill(_integrals.begin(), _integrals.end(), 0.0f);
}

void ThesisJoints::command_torque(std::size_t p_limb, const JointState &p_joint, const ControlSettings &p_settings,
		float p_delta_s, LimbCommand &r_command) {
	const float angle = p_joint.error.length();
	float &integral = _integrals[p_limb];
	// dx/dt = i - a x over the step, exactly, with the input held.
	const float kept = std::exp(-p_settings.leak * p_delta_s);
	integral = integral * kept + angle * (1.0f - kept) / p_settings.leak;
	const float omega = TAU * chosen(p_joint.spring.frequency, p_settings.torque_frequency);
	const float ratio = chosen(p_joint.spring.damping_ratio, p_settings.torque_damping_ratio);
	const Vec3 &inertia = _rig->get_subtree_inertia(p_limb);
	const Vec3 &own = _rig->get_own_inertia(p_limb);
	const Vec3 stiffness = inertia * (omega * omega * (1.0f + p_settings.leak_weight * integral));
	const Vec3 damping = inertia * (2.0f * ratio * omega);
	// Taken at the end of the step, as if the limb turned alone (Tan, Liu, Turk 2011, "Stable
	// proportional-derivative controllers", eq. 4): within a step the limbs beyond its joints do not
	// turn with it. Explicit, the thesis's spring explodes.
	const Vec3 coming = p_joint.error - p_joint.velocity * p_delta_s;
	const Vec3 pull = coming.scaled(stiffness) - p_joint.velocity.scaled(damping);
	const Vec3 held_back = (damping + stiffness * p_delta_s) * p_delta_s;
	const Vec3 torque = { pull.x / (1.0f + held_back.x / own.x), pull.y / (1.0f + held_back.y / own.y),
		pull.z / (1.0f + held_back.z / own.z) };
	r_command.torque = p_joint.orientation.rotate(torque.limited(r_command.max_torque));
}

void ThesisJoints::command_position(std::size_t p_limb, const JointState &p_joint, const ControlSettings &p_settings,
		float p_delta_s, LimbCommand &r_command) const {
	const float omega = TAU * chosen(p_joint.spring.frequency, p_settings.position_frequency);
	const float ratio = chosen(p_joint.spring.damping_ratio, p_settings.position_damping_ratio);
	const Vec3 &inertia = _rig->get_subtree_inertia(p_limb);
	r_command.stiffness = inertia * (omega * omega);
	r_command.damping = inertia * (2.0f * ratio * omega);
	// A damper holds back what moves anyway: the target lies ahead by damping / stiffness.
	const Quat ahead = p_joint.next * exp(p_joint.forward * (2.0f * ratio / omega));
	// The engine does not limit a spring's torque: it is asked for no more than the limit gives.
	const Vec3 wanted = log(p_joint.actual.inverse() * ahead);
	const float torque = wanted.scaled(r_command.stiffness).length();
	const Vec3 held_back = r_command.damping + r_command.stiffness * p_delta_s;
	const float most = r_command.max_torque + p_joint.velocity.scaled(held_back).length();
	r_command.target = p_joint.actual * exp(torque > most ? wanted * (most / torque) : wanted);
}

} // namespace ragdoll
