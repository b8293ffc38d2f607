// SPDX-License-Identifier: MIT
#include "driver.hpp"

#include <algorithm>

namespace ragdoll {

void Driver::find_points(const Pose &p_pose, std::vector<Vec3> &r_points) {
	_rig.joint_positions(p_pose, _joints);
	for (std::size_t i = 0; i < _contacts.size(); i++) {
		const std::size_t limb = std::size_t(_contacts[i].limb);
		r_points[i] = _joints[limb] + p_pose.orientations[limb].rotate(_contacts[i].local);
	}
}

void Driver::find_shown(const RigState &p_state) {
	for (std::size_t i = 0; i < _contacts.size(); i++) {
		const std::size_t limb = std::size_t(_contacts[i].limb);
		_points_shown[i] = _rig.joint_of(p_state, limb) + p_state.orientations[limb].rotate(_contacts[i].local);
	}
}

void Driver::shift_travel(Travel &r_estimator, const Vec3 &p_offset) {
	r_estimator.shift(p_offset);
	_foot_lock.shift(p_offset);
	_path.shift(p_offset);
}

void Driver::give_in(Travel &r_estimator, const Vec3 &p_off) {
	const Vec3 across{ p_off.x, 0.0f, p_off.z };
	const float distance = across.length();
	if (distance > SLACK) {
		shift_travel(r_estimator, across * (1.0f - SLACK / distance));
	}
}

void Driver::stay_near(Travel &r_estimator, const RigState &p_state) {
	const Vec3 off = r_estimator.get_root() - Vec3{ 0.0f, _foot_lock.get_drop(), 0.0f } - p_state.root;
	const Vec3 up{ 0.0f, std::clamp(off.y, -FURTHEST_UP, FURTHEST_UP), 0.0f };
	const Vec3 across = Vec3{ off.x, 0.0f, off.z }.limited(FURTHEST_ACROSS);
	const Vec3 too_far = off - up - across;
	if (too_far.length() > 0.0f) {
		shift_travel(r_estimator, too_far * -1.0f);
	}
}

void Driver::travel(const RigState &p_state, float p_delta_s) {
	Travel *estimator = find_travel(root_mode);
	const bool goes_on = _travelled == root_mode;
	const Vec3 expected = _next_root; // Where the last step should have brought the root.
	_travelled = root_mode;
	if (!estimator) {
		_next_root = _next.root;
		return;
	}
	// Whoever lies limp is wherever the body is, and begins from there when he gets up. How a pose has changed
	// while nothing came says nothing of where the person went.
	const bool limp = _table.get_mode(0) == Actuation::LIMP;
	if (!goes_on || limp || _has_resumed) {
		estimator->reset(p_state.root);
		_foot_lock.clear();
		_path.clear();
	} else {
		give_in(*estimator, p_state.root - expected);
		const Ride &ride = _carrier.get_past();
		if (root_mode == RootMode::LOWEST_FOOT && ride.moves) {
			// The others know what their points stand on.
			shift_travel(*estimator, ride.apply(p_state.root) - p_state.root);
		}
	}
	estimate(*estimator, p_state, p_delta_s);
	if (goes_on) {
		stay_near(*estimator, p_state);
	}
	_now.root = estimator->get_root();
	_next.root = estimator->ahead(_points_next, p_delta_s);
	const PoseFilter &filter = _stream.get_filter();
	_path.advance(_now.root, filter.get_noise(), p_delta_s);
	if (filter.get_noise() > 0.0f) {
		_now.root = _path.get_position();
		_next.root = _path.ahead(p_delta_s);
	}
	_foot_lock.advance(*estimator, _now.root, _points_now, _points_shown, filter.get_unrest(), p_delta_s);
	_rig.joint_positions(_now, _joints);
	const float before = _foot_lock.get_drop();
	const float drop = _foot_lock.sink(_rig, filter.get_unrest(), _joints, p_delta_s);
	_now.root.y -= drop;
	_next.root.y -= 2.0f * drop - before; // It goes on coming down.
	_rig.joint_positions(_now, _joints);
	_foot_lock.apply(_rig, filter.get_unrest(), _now, _joints);
	_rig.joint_positions(_next, _joints);
	_foot_lock.apply(_rig, filter.get_unrest(), _next, _joints);
	_next_root = _next.root;
}

void Driver::estimate(Travel &r_estimator, const RigState &p_state, float p_delta_s) {
	_now.root = {};
	_next.root = {};
	find_points(_next, _points_next);
	find_points(_now, _points_now);
	find_shown(p_state);
	for (std::size_t i = 0; i < _rig.size(); i++) {
		_turns[i] = log(_next.orientations[i] * _now.orientations[i].inverse()) * (1.0f / p_delta_s);
	}
	GaitInput input;
	input.delta_s = p_delta_s;
	input.points = &_points_now;
	input.centre = _rig.centre_of_mass(_now, _joints);
	input.ground = ground ? ground : &_level_ground;
	input.gravity = p_state.gravity;
	input.turns = &_turns;
	input.shown = &_points_shown;
	r_estimator.step(input);
}

} // namespace ragdoll
