// SPDX-License-Identifier: MIT
#include "comparison/comparison.hpp"

#include "comparison/lowest_contact.hpp"
#include "comparison/lowest_foot.hpp"
#include "comparison/thesis_joints.hpp"

#include <algorithm>

namespace ragdoll {

namespace {

/// The turning rate (rad/s, limb's axes) that brings a limb along in the world.
Vec3 find_righting_turn(const Quat &p_actual, const Quat &p_now, const Quat &p_next, float p_delta_s, float p_gain) {
	const float gain = std::min(p_gain, 1.0f / p_delta_s);
	return log(p_now.inverse() * p_next) * (1.0f / p_delta_s) + log(p_actual.inverse() * p_now) * gain;
}

} // namespace

std::unique_ptr<Travel> make_thesis_travel(RootMode p_mode, const std::vector<ContactPoint> &p_contacts) {
	switch (p_mode) {
		case RootMode::LOWEST_FOOT:
			return std::make_unique<LowestFoot>(p_contacts);
		case RootMode::CONTACTS:
			return std::make_unique<LowestContact>(p_contacts);
		default:
			return nullptr;
	}
}

std::unique_ptr<JointDrive> make_thesis_joints(const Rig &p_rig) {
	return std::make_unique<ThesisJoints>(p_rig);
}

RootCommand drive_thesis_root(RootMode p_mode, const RootSettings &p_settings, const RigState &p_actual,
		const Pose &p_now, const Pose &p_next, const Vec3 &p_turn, int p_trunk, float p_delta_s, float p_strength) {
	RootCommand command;
	command.assist_torque = p_settings.torque * p_strength;
	if (p_mode == RootMode::PENDULUM) {
		command.assist_turn = p_turn;
		return command;
	}
	command.torque = command.assist_torque;
	if (p_trunk > 0) {
		const std::size_t trunk = std::size_t(p_trunk);
		command.assist_turn = find_righting_turn(p_actual.orientations[trunk], p_now.orientations[trunk],
				p_next.orientations[trunk], p_delta_s, p_settings.gain);
	}
	return command;
}

} // namespace ragdoll
