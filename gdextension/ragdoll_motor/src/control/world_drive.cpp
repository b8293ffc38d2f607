// SPDX-License-Identifier: MIT
#include "control/world_drive.hpp"

#include <limits>

namespace ragdoll {

void WorldDrive::Spring::set(const DriveStrength &p_wanted, float p_blend_s) {
	const bool is_wanted = p_wanted.strength > 0.0f;
	if (is_wanted && !is_on) {
		damping_ratio = Ramp(p_wanted.damping_ratio);
		most = Ramp(0.0f);
	}
	strength.go(is_wanted ? p_wanted.strength : 0.0f, p_blend_s);
	if (is_wanted) {
		damping_ratio.go(p_wanted.damping_ratio, p_blend_s);
		is_limited = p_wanted.most > 0.0f;
		most.go(p_wanted.most, p_blend_s);
	}
	is_on = is_wanted || strength.get() > 0.0f;
}

void WorldDrive::Spring::advance(float p_delta_s) {
	strength.advance(p_delta_s);
	damping_ratio.advance(p_delta_s);
	most.advance(p_delta_s);
	is_on = strength.is_moving() || strength.get_target() > 0.0f;
}

float WorldDrive::Spring::limit() const {
	return is_limited ? most.get() : std::numeric_limits<float>::max();
}

void WorldDrive::set(
		std::size_t p_limb, const DriveStrength &p_angular, const DriveStrength &p_linear, float p_blend_s) {
	_limbs[p_limb].angular.set(p_angular, p_blend_s);
	_limbs[p_limb].linear.set(p_linear, p_blend_s);
	count();
}

void WorldDrive::count() {
	_active = 0;
	for (std::size_t i = 0; i < _limbs.size(); i++) {
		_active += is_pulled(i) ? 1 : 0;
	}
}

void WorldDrive::advance(float p_delta_s) {
	if (_active == 0) {
		return;
	}
	for (Limb &limb : _limbs) {
		limb.angular.advance(p_delta_s);
		limb.linear.advance(p_delta_s);
	}
	count();
}

void WorldDrive::compute(const Rig &p_rig, const RigState &p_state, const Pose &p_now, const Pose &p_next,
		const std::vector<Vec3> &p_joints_now, const std::vector<Vec3> &p_joints_next, float p_delta_s,
		std::vector<LimbPush> &r_pushes) const {
	const float rate = 1.0f / p_delta_s;
	for (std::size_t i = 0; i < _limbs.size(); i++) {
		r_pushes[i] = {};
		const Spring &linear = _limbs[i].linear;
		if (linear.is_on) {
			const Vec3 before = p_joints_now[i] + p_now.orientations[i].rotate(p_rig[i].centre);
			const Vec3 target = p_joints_next[i] + p_next.orientations[i].rotate(p_rig[i].centre);
			const float omega = TAU * linear.strength.get();
			const float stiffness = p_rig.get_subtree_mass(i) * omega * omega;
			const float damping = 2.0f * linear.damping_ratio.get() * p_rig.get_subtree_mass(i) * omega;
			const Vec3 coming = target - p_state.centres[i] - p_state.linear[i] * p_delta_s;
			const Vec3 slow = (target - before) * rate - p_state.linear[i];
			const float held_back = (damping + stiffness * p_delta_s) * p_delta_s / p_rig[i].mass;
			r_pushes[i].force =
					((coming * stiffness + slow * damping) * (1.0f / (1.0f + held_back))).limited(linear.limit());
		}
		const Spring &angular = _limbs[i].angular;
		if (angular.is_on) {
			// In the limb's axes, about the joint.
			const Quat &turn = p_state.orientations[i];
			const Vec3 spin = turn.inverse().rotate(p_state.angular[i]);
			const Vec3 forward = log(p_now.orientations[i].inverse() * p_next.orientations[i]) * rate;
			const float omega = TAU * angular.strength.get();
			const Vec3 stiffness = p_rig.get_subtree_inertia(i) * (omega * omega);
			const Vec3 damping = p_rig.get_subtree_inertia(i) * (2.0f * angular.damping_ratio.get() * omega);
			const Vec3 coming = log(turn.inverse() * p_next.orientations[i]) - spin * p_delta_s;
			const Vec3 pull = coming.scaled(stiffness) + (forward - spin).scaled(damping);
			const Vec3 held_back = (damping + stiffness * p_delta_s) * p_delta_s;
			const Vec3 &own = p_rig.get_own_inertia(i);
			const Vec3 torque = { pull.x / (1.0f + held_back.x / own.x), pull.y / (1.0f + held_back.y / own.y),
				pull.z / (1.0f + held_back.z / own.z) };
			r_pushes[i].torque = turn.rotate(torque.limited(angular.limit()));
		}
	}
}

void WorldDrive::save(ArchiveWriter &p_archive) const {
	p_archive.put_all(_limbs);
}

bool WorldDrive::restore(ArchiveReader &p_archive) {
	const bool is_whole = p_archive.get_all(_limbs);
	count();
	return is_whole;
}

} // namespace ragdoll
