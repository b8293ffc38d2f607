// SPDX-License-Identifier: MIT
#include "joint/torque_meter.hpp"

#include <algorithm>

namespace ragdoll {

TorqueMeter::TorqueMeter(std::size_t p_limb_count) :
		_linear_before(p_limb_count),
		_angular_before(p_limb_count),
		_forces(p_limb_count),
		_moments(p_limb_count),
		_torques(p_limb_count, 0.0f),
		_saturations(p_limb_count, 0.0f) {}

void TorqueMeter::note(const Rig &p_rig, const RigState &p_state, float p_delta_s) {
	const float rate = _is_known ? 1.0f / p_delta_s : 0.0f;
	std::fill(_forces.begin(), _forces.end(), Vec3());
	std::fill(_moments.begin(), _moments.end(), Vec3());
	for (std::size_t i = p_rig.size(); i-- > 0;) {
		const Segment &limb = p_rig[i];
		const Quat &turn = p_state.orientations[i];
		const Vec3 joint = p_rig.joint_of(p_state, i);
		const Vec3 acceleration = (p_state.linear[i] - _linear_before[i]) * rate - p_state.gravity;
		const Vec3 force = acceleration * limb.mass;
		const Vec3 spin = turn.inverse().rotate(p_state.angular[i]);
		const Vec3 speeding = turn.inverse().rotate((p_state.angular[i] - _angular_before[i]) * rate);
		const Vec3 &inertia = limb.inertia;
		const Vec3 momentum{ inertia.x * spin.x, inertia.y * spin.y, inertia.z * spin.z };
		const Vec3 own =
				Vec3{ inertia.x * speeding.x, inertia.y * speeding.y, inertia.z * speeding.z } + spin.cross(momentum);
		_forces[i] = _forces[i] + force;
		_moments[i] = _moments[i] + turn.rotate(own) + (p_state.centres[i] - joint).cross(force);
		_torques[i] = _moments[i].length();
		if (limb.parent >= 0) {
			const Vec3 arm = joint - p_rig.joint_of(p_state, limb.parent);
			_forces[limb.parent] = _forces[limb.parent] + _forces[i];
			_moments[limb.parent] = _moments[limb.parent] + _moments[i] + arm.cross(_forces[i]);
		}
		_linear_before[i] = p_state.linear[i];
		_angular_before[i] = p_state.angular[i];
	}
	_is_known = true;
}

void TorqueMeter::compare(const Rig &p_rig, const ActuationTable &p_table, float p_root_torque, float p_root_most) {
	_torques[0] = p_root_torque;
	for (std::size_t i = 0; i < p_rig.size(); i++) {
		const float most = i == 0 ? p_root_most : p_rig[i].max_torque * p_table.get_strength(i);
		_saturations[i] = most > 0.0f ? _torques[i] / most : 0.0f;
	}
}

} // namespace ragdoll
