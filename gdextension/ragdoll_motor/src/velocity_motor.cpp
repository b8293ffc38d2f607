// SPDX-License-Identifier: MIT
#include "velocity_motor.hpp"

#include <algorithm>
#include <utility>

namespace ragdoll {

VelocityMotor::VelocityMotor(std::vector<int> p_parents) : parents(std::move(p_parents)) {}

void VelocityMotor::compute(const std::vector<Quat> &p_actual, const Pose &p_now, const Pose &p_next, float p_delta_s,
		float p_gain, std::vector<Vec3> &r_velocities) const {
	const std::size_t count = limb_count();
	const float gain = std::min(p_gain, 1.0f / p_delta_s);
	r_velocities.resize(count);
	for (std::size_t i = 0; i < count; i++) {
		const int parent = parents[i];
		Quat actual = p_actual[i];
		Quat now = p_now.orientations[i];
		Quat next = p_next.orientations[i];
		if (parent >= 0) {
			actual = p_actual[parent].inverse() * actual;
			now = p_now.orientations[parent].inverse() * now;
			next = p_next.orientations[parent].inverse() * next;
		}
		r_velocities[i] = log(now.inverse() * next) * (1.0f / p_delta_s) + log(actual.inverse() * now) * gain;
	}
}

void VelocityMotor::joint_positions(
		const Pose &p_pose, const std::vector<Vec3> &p_anchors, std::vector<Vec3> &r_positions) const {
	r_positions.resize(limb_count());
	for (std::size_t i = 0; i < limb_count(); i++) {
		const int parent = parents[i];
		r_positions[i] =
				parent < 0 ? p_pose.root : r_positions[parent] + p_pose.orientations[parent].rotate(p_anchors[i]);
	}
}

Vec3 root_velocity(const Vec3 &p_actual, const Vec3 &p_now, const Vec3 &p_next, float p_delta_s, float p_gain) {
	const float gain = std::min(p_gain, 1.0f / p_delta_s);
	return (p_next - p_now) * (1.0f / p_delta_s) + (p_now - p_actual) * gain;
}

} // namespace ragdoll
