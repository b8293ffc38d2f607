// SPDX-License-Identifier: MIT
#include "rig.hpp"

#include <utility>

namespace ragdoll {

void RigState::resize(std::size_t p_limb_count) {
	orientations.resize(p_limb_count);
	centres.resize(p_limb_count);
	linear.resize(p_limb_count);
	angular.resize(p_limb_count);
}

Vec3 turned_inertia(const Vec3 &p_moments, const Quat &p_turn) {
	const Vec3 x = p_turn.rotate({ 1.0f, 0.0f, 0.0f });
	const Vec3 y = p_turn.rotate({ 0.0f, 1.0f, 0.0f });
	const Vec3 z = p_turn.rotate({ 0.0f, 0.0f, 1.0f });
	return x.scaled(x) * p_moments.x + y.scaled(y) * p_moments.y + z.scaled(z) * p_moments.z;
}

Rig::Rig(std::vector<Segment> p_limbs) :
		limbs(std::move(p_limbs)), subtree_inertia(limbs.size()), own_inertia(limbs.size()), legs(limbs.size(), 0) {
	std::vector<Vec3> joints(limbs.size());
	for (std::size_t i = 0; i < limbs.size(); i++) {
		mass += limbs[i].mass;
		for (int above = int(i); limbs[i].is_foot && limbs[above].parent >= 0; above = limbs[above].parent) {
			legs[above] = 1;
		}
		if (limbs[i].parent >= 0) {
			const Segment &parent = limbs[limbs[i].parent];
			joints[i] = joints[limbs[i].parent] + parent.rest.rotate(limbs[i].anchor);
		}
		for (int above = int(i); above >= 0; above = limbs[above].parent) {
			const Quat turn = limbs[above].rest.inverse();
			const Vec3 arm = turn.rotate(joints[i] + limbs[i].rest.rotate(limbs[i].centre) - joints[above]);
			const Vec3 square = arm.scaled(arm) * limbs[i].mass;
			const Vec3 about_joint = turned_inertia(limbs[i].inertia, turn * limbs[i].rest) +
					Vec3{ square.y + square.z, square.x + square.z, square.x + square.y };
			subtree_inertia[above] = subtree_inertia[above] + about_joint;
			if (above == int(i)) {
				own_inertia[i] = about_joint;
			}
		}
	}
}

void Rig::joint_positions(const Pose &p_pose, std::vector<Vec3> &r_positions) const {
	r_positions.resize(limbs.size());
	for (std::size_t i = 0; i < limbs.size(); i++) {
		const int parent = limbs[i].parent;
		r_positions[i] =
				parent < 0 ? p_pose.root : r_positions[parent] + p_pose.orientations[parent].rotate(limbs[i].anchor);
	}
}

Vec3 Rig::centre_of_mass(const Pose &p_pose, const std::vector<Vec3> &p_joints) const {
	Vec3 sum;
	for (std::size_t i = 0; i < limbs.size(); i++) {
		sum = sum + (p_joints[i] + p_pose.orientations[i].rotate(limbs[i].centre)) * limbs[i].mass;
	}
	return sum * (1.0f / mass);
}

Vec3 Rig::joint_of(const RigState &p_state, std::size_t p_limb) const {
	return p_state.centres[p_limb] - p_state.orientations[p_limb].rotate(limbs[p_limb].centre);
}

} // namespace ragdoll
