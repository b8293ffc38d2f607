// SPDX-License-Identifier: MIT
#pragma once

#include "driver.hpp"
#include "state_of.hpp"

#include <random>
#include <vector>

/// A small ragdoll for tests: a trunk, a limb that hangs on it, and two that hang on that.
namespace fixtures {

inline std::vector<ragdoll::Segment> limbs() {
	std::vector<ragdoll::Segment> result(4);
	const int parents[4] = { -1, 0, 1, 1 };
	for (int i = 0; i < 4; i++) {
		result[i].parent = parents[i];
		result[i].anchor = { 0.0f, i == 0 ? 0.0f : 0.5f, 0.0f };
		result[i].centre = { 0.0f, 0.25f, 0.0f };
		result[i].mass = 10.0f;
		result[i].inertia = { 0.2f, 0.05f, 0.2f };
		result[i].max_torque = i == 0 ? 0.0f : 500.0f;
		result[i].group = i < 2 ? 0 : i - 1;
	}
	return result;
}

inline std::vector<int> groups() {
	return { 0, 0, 1, 2 };
}

inline ragdoll::Pose random_pose(std::mt19937 &p_random) {
	std::normal_distribution<float> normal(0.0f, 0.7f);
	ragdoll::Pose pose;
	for (std::size_t i = 0; i < limbs().size(); i++) {
		pose.orientations.push_back(ragdoll::exp({ normal(p_random), normal(p_random), normal(p_random) }));
	}
	return pose;
}

/// What ideal joints would do with the motors' velocities in one step.
inline ragdoll::Pose turned(const ragdoll::Rig &p_rig, const ragdoll::Pose &p_pose,
		const std::vector<ragdoll::LimbCommand> &p_commands, float p_delta_s) {
	ragdoll::Pose moved = p_pose;
	for (std::size_t i = 0; i < p_rig.size(); i++) {
		const int parent = p_rig[i].parent;
		const ragdoll::Quat relative =
				parent < 0 ? p_pose.orientations[i] : p_pose.orientations[parent].inverse() * p_pose.orientations[i];
		const ragdoll::Quat turn = relative * ragdoll::exp(p_commands[i].velocity * p_delta_s);
		moved.orientations[i] = parent < 0 ? turn : moved.orientations[parent] * turn;
	}
	return moved;
}

} // namespace fixtures
