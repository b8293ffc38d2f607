// SPDX-License-Identifier: MIT
#include "body/rig.hpp"

#include <algorithm>
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

void scale_inertia(std::vector<Segment> &r_limbs, float p_bearing, float p_hanging) {
	std::vector<std::uint8_t> bears(r_limbs.size(), 0);
	for (std::size_t i = r_limbs.size(); i-- > 0;) {
		Segment &limb = r_limbs[i];
		bears[i] |= limb.is_foot || limb.group == r_limbs[0].group ? 1 : 0;
		if (bears[i] != 0 && limb.parent >= 0) {
			bears[std::size_t(limb.parent)] = 1;
		}
		const float most = std::max({ limb.inertia.x, limb.inertia.y, limb.inertia.z });
		limb.inertia = Vec3{ most, most, most } * (bears[i] != 0 ? p_bearing : p_hanging);
	}
}

Rig::Rig(std::vector<Segment> p_limbs) :
		_limbs(std::move(p_limbs)),
		_subtree_inertia(_limbs.size()),
		_own_inertia(_limbs.size()),
		_subtree_mass(_limbs.size(), 0.0f),
		_legs(_limbs.size(), 0) {
	std::vector<Vec3> joints(_limbs.size());
	for (std::size_t i = 0; i < _limbs.size(); i++) {
		_mass += _limbs[i].mass;
		for (int above = int(i); _limbs[i].is_foot && _limbs[above].parent >= 0; above = _limbs[above].parent) {
			_legs[above] = 1;
		}
		if (_limbs[i].parent >= 0) {
			const Segment &parent = _limbs[_limbs[i].parent];
			joints[i] = joints[_limbs[i].parent] + parent.rest.rotate(_limbs[i].anchor);
		}
		for (int above = int(i); above >= 0; above = _limbs[above].parent) {
			const Quat turn = _limbs[above].rest.inverse();
			const Vec3 arm = turn.rotate(joints[i] + _limbs[i].rest.rotate(_limbs[i].centre) - joints[above]);
			const Vec3 square = arm.scaled(arm) * _limbs[i].mass;
			const Vec3 about_joint = turned_inertia(_limbs[i].inertia, turn * _limbs[i].rest) +
					Vec3{ square.y + square.z, square.x + square.z, square.x + square.y };
			_subtree_inertia[above] = _subtree_inertia[above] + about_joint;
			_subtree_mass[above] += _limbs[i].mass;
			if (above == int(i)) {
				_own_inertia[i] = about_joint;
			}
		}
	}
}

void Rig::joint_positions(const Pose &p_pose, std::vector<Vec3> &r_positions) const {
	r_positions.resize(_limbs.size());
	for (std::size_t i = 0; i < _limbs.size(); i++) {
		const int parent = _limbs[i].parent;
		r_positions[i] =
				parent < 0 ? p_pose.root : r_positions[parent] + p_pose.orientations[parent].rotate(_limbs[i].anchor);
	}
}

Vec3 Rig::centre_of_mass(const Pose &p_pose, const std::vector<Vec3> &p_joints) const {
	Vec3 sum;
	for (std::size_t i = 0; i < _limbs.size(); i++) {
		sum = sum + (p_joints[i] + p_pose.orientations[i].rotate(_limbs[i].centre)) * _limbs[i].mass;
	}
	return sum * (1.0f / _mass);
}

Vec3 Rig::centre_of_mass(const RigState &p_state) const {
	return weigh(p_state.centres);
}

Vec3 Rig::mean_velocity(const RigState &p_state) const {
	return weigh(p_state.linear);
}

Vec3 Rig::weigh(const std::vector<Vec3> &p_values) const {
	Vec3 sum;
	for (std::size_t i = 0; i < _limbs.size(); i++) {
		sum = sum + p_values[i] * _limbs[i].mass;
	}
	return sum * (1.0f / _mass);
}

Vec3 Rig::joint_of(const RigState &p_state, std::size_t p_limb) const {
	return p_state.centres[p_limb] - p_state.orientations[p_limb].rotate(_limbs[p_limb].centre);
}

} // namespace ragdoll
