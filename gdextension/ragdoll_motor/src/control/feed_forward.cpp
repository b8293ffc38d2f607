// SPDX-License-Identifier: MIT
#include "control/feed_forward.hpp"

#include <algorithm>

namespace ragdoll {

namespace {

// What no limb of a person does; more is a glitch of the source, or a jump of it to another place.
constexpr float MAX_ACCELERATION = 100.0f; // m/s^2
constexpr float MAX_ANGULAR_ACCELERATION = 300.0f; // rad/s^2

} // namespace

FeedForward::FeedForward(const Rig &p_rig) :
		_linear(p_rig.size()),
		_angular(p_rig.size()),
		_joints(p_rig.size()),
		_joints_next(p_rig.size()),
		_impulses(p_rig.size()),
		_hanging(p_rig.size()),
		_shares(p_rig.size(), 1.0f),
		_driven(p_rig.size(), false) {}

void FeedForward::find_impulses(const Rig &p_rig, const RigState &p_state, const Pose &p_now, const Pose &p_next,
		float p_delta_s, const std::vector<LimbCommand> &p_commands) {
	p_rig.joint_positions(p_now, _joints);
	p_rig.joint_positions(p_next, _joints_next);
	const float rate = 1.0f / p_delta_s;
	for (std::size_t i = 1; i < p_rig.size(); i++) {
		const std::size_t parent = std::size_t(p_rig[i].parent);
		_impulses[i] = {};
		_driven[i] = p_commands[i].mode == Actuation::VELOCITY_MOTOR && !p_rig.is_in_leg(i) &&
				(parent == 0 || _driven[parent]);
		const Vec3 centre = _joints[i] + p_now.orientations[i].rotate(p_rig[i].centre);
		const Vec3 centre_next = _joints_next[i] + p_next.orientations[i].rotate(p_rig[i].centre);
		const Vec3 linear = (centre_next - centre) * rate;
		const Vec3 angular = log(p_next.orientations[i] * p_now.orientations[i].inverse()) * rate;
		if (_driven[i] && _has_before) {
			const Vec3 change = (linear - _linear[i]).limited(MAX_ACCELERATION * p_delta_s);
			_impulses[i].linear = (change - p_state.gravity * p_delta_s) * p_rig[i].mass;
			const Quat &turn = p_state.orientations[i];
			const Vec3 turned =
					turn.inverse().rotate((angular - _angular[i]).limited(MAX_ANGULAR_ACCELERATION * p_delta_s));
			_impulses[i].angular = turn.rotate(turned.scaled(p_rig[i].inertia));
		}
		_linear[i] = linear;
		_angular[i] = angular;
	}
}

void FeedForward::find_shares(
		const Rig &p_rig, const RigState &p_state, float p_delta_s, const std::vector<LimbCommand> &p_commands) {
	std::fill(_hanging.begin(), _hanging.end(), Impulse());
	for (std::size_t i = p_rig.size(); i-- > 1;) {
		if (!_driven[i]) {
			continue;
		}
		const Vec3 joint = p_rig.joint_of(p_state, i);
		Impulse &whole = _hanging[i];
		whole.angular = whole.angular + _impulses[i].angular + (p_state.centres[i] - joint).cross(_impulses[i].linear);
		whole.linear = whole.linear + _impulses[i].linear;
		const float torque = p_commands[i].whole_torque;
		const float most = torque * std::min(torque / std::max(p_rig[i].max_torque, 1e-6f), 1.0f) * p_delta_s;
		const float needed = whole.angular.length();
		_shares[i] = needed > most ? most / needed : 1.0f;
		Impulse &above = _hanging[std::size_t(p_rig[i].parent)];
		const Vec3 arm = joint - p_rig.joint_of(p_state, std::size_t(p_rig[i].parent));
		above.angular = above.angular + whole.angular + arm.cross(whole.linear);
		above.linear = above.linear + whole.linear;
	}
	for (std::size_t i = 1; i < p_rig.size(); i++) {
		const std::size_t parent = std::size_t(p_rig[i].parent);
		_shares[i] = parent > 0 ? std::min(_shares[i], _shares[parent]) : _shares[i];
	}
}

void FeedForward::add(const Rig &p_rig, const RigState &p_state, const Pose &p_now, const Pose &p_next, float p_delta_s,
		const std::vector<LimbCommand> &p_commands, std::vector<LimbPush> &r_pushes) {
	find_impulses(p_rig, p_state, p_now, p_next, p_delta_s, p_commands);
	find_shares(p_rig, p_state, p_delta_s, p_commands);
	for (std::size_t i = 1; i < p_rig.size() && _has_before; i++) {
		if (!_driven[i]) {
			continue;
		}
		const float rate = _shares[i] / p_delta_s;
		const Vec3 force = _impulses[i].linear * rate;
		const Vec3 torque = _impulses[i].angular * rate;
		r_pushes[i].force = r_pushes[i].force + force;
		r_pushes[i].torque = r_pushes[i].torque + torque;
		r_pushes[0].force = r_pushes[0].force - force;
		r_pushes[0].torque = r_pushes[0].torque - torque - (p_state.centres[i] - p_state.centres[0]).cross(force);
	}
	_has_before = true;
}

void FeedForward::save(ArchiveWriter &p_archive) const {
	p_archive.put_all(_linear);
	p_archive.put_all(_angular);
	p_archive.put(_has_before);
}

bool FeedForward::restore(ArchiveReader &p_archive) {
	return p_archive.get_all(_linear) && p_archive.get_all(_angular) && p_archive.get(_has_before);
}

} // namespace ragdoll
