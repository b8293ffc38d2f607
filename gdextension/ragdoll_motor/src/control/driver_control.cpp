// SPDX-License-Identifier: MIT
// Driver: controls of single limbs, and hits.
#include "control/hit.hpp"
#include "driver.hpp"

#include <algorithm>

namespace ragdoll {

void Driver::set_control(std::size_t p_limb, const LimbControl &p_control, float p_blend_s) {
	const float blend = std::clamp(p_control.physics_blend, 0.0f, 1.0f);
	const float own = _rig[p_limb].max_torque;
	const float most = p_control.parent_angular.most;
	const float share = most > 0.0f && own > 0.0f ? most / own : 1.0f;
	const ControlSettings &usual = _controller.settings;
	const bool is_sprung = p_control.mode == Actuation::SPRING_TORQUE;
	_table.set_limb_mode(blend > 0.0f ? p_control.mode : Actuation::DIRECT_SET, p_limb, p_blend_s);
	_table.set_limb_share(std::max(p_control.strength, 0.0f) * share, p_limb, p_blend_s);
	_table.set_limb_spring(p_control.parent_angular.strength, p_control.parent_angular.damping_ratio,
			is_sprung ? usual.torque_frequency : usual.position_frequency, p_limb, p_blend_s);
	_table.set_physics_blend(blend, p_limb, p_blend_s);
	_world.set(p_limb, p_control.world_angular, p_control.world_linear, p_blend_s);
}

int Driver::hit(const RigState &p_state, const Vec3 &p_impulse, const Vec3 &p_position, int p_group, float p_strength,
		float p_blend_s) {
	const int limb = find_nearest_limb(_rig, p_state, p_position, p_group);
	if (limb >= 0) {
		const float least = find_least_strength(_rig, p_state, limb, p_impulse, p_position);
		flinch(_rig, limb, std::clamp(p_strength, least, 1.0f), p_blend_s, _table);
	}
	return limb;
}

void Driver::ease_limbs(const RigState &p_state, float p_delta_s) {
	float fastest = 0.0f;
	for (std::size_t i = 1; i < _rig.size(); i++) {
		const float turned = angle_between(_now.orientations[i], _next.orientations[i]);
		fastest = std::max(fastest, turned / p_delta_s);
	}
	if (fastest > EASE_BELOW) {
		return; // Who moves the arms needs their torque, and that of the trunk which holds them.
	}
	for (std::size_t i = 1; i < _rig.size(); i++) {
		LimbCommand &command = _commands.limbs[i];
		if (_rig.is_in_leg(i) || command.mode != Actuation::VELOCITY_MOTOR) {
			continue;
		}
		const std::size_t parent = std::size_t(_rig[i].parent);
		const Quat actual = p_state.orientations[parent].inverse() * p_state.orientations[i];
		const Quat wanted = _now.orientations[parent].inverse() * _now.orientations[i];
		const Vec3 error = p_state.orientations[i].rotate(log(actual.inverse() * wanted));
		const Vec3 turning = p_state.angular[i] - p_state.angular[parent];
		command.max_torque *= _balance.get_stiffness(error.length(), error.dot(turning) > 0.0f);
	}
}

void Driver::push_limbs(const RigState &p_state, float p_delta_s) {
	_world.advance(p_delta_s);
	if (_world.is_active()) {
		_rig.joint_positions(_now, _joints);
		_rig.joint_positions(_next, _joints_next);
		_world.compute(_rig, p_state, _now, _next, _joints, _joints_next, p_delta_s, _commands.pushes);
	} else {
		std::fill(_commands.pushes.begin(), _commands.pushes.end(), LimbPush());
	}
	_feed_forward.add(_rig, p_state, _now, _next, p_delta_s, _commands.limbs, _commands.pushes);
}

void Driver::blend_shown(const RigState &p_state, std::vector<Quat> &r_orientations, Vec3 &r_root_centre) const {
	r_orientations = p_state.orientations;
	r_root_centre = p_state.centres[0];
	if (!_table.is_blended() || _next.orientations.size() != _rig.size()) {
		return;
	}
	for (std::size_t i = 0; i < _rig.size(); i++) {
		r_orientations[i] = slerp(_next.orientations[i], p_state.orientations[i], _table.get_physics_blend(i));
	}
	const Vec3 target = _next.root + _next.orientations[0].rotate(_rig[0].centre);
	r_root_centre = target + (r_root_centre - target) * _table.get_physics_blend(0);
}

} // namespace ragdoll
