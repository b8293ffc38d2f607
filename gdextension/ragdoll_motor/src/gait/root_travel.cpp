// SPDX-License-Identifier: MIT
#include "gait/root_travel.hpp"

#include <algorithm>
#include <utility>

namespace ragdoll {

RootTravel::RootTravel(const Rig &p_rig, const std::vector<ContactPoint> &p_contacts, TravelMaker p_make) :
		_make(p_make),
		_contacts(p_contacts),
		_foot_lock(p_rig, p_contacts),
		_points_now(p_contacts.size()),
		_points_next(p_contacts.size()),
		_points_shown(p_contacts.size()),
		_turns(p_rig.size()) {}

Travel *RootTravel::find(RootMode p_mode) const {
	for (const ModeTravel &mode : _estimators) {
		if (mode.mode == p_mode) {
			return mode.estimator.get();
		}
	}
	return nullptr;
}

Travel *RootTravel::make(RootMode p_mode) {
	std::unique_ptr<Travel> estimator = _make(p_mode, _contacts);
	if (!estimator) {
		return nullptr;
	}
	_estimators.push_back({ p_mode, std::move(estimator) });
	return _estimators.back().estimator.get();
}

void RootTravel::advance(const Rig &p_rig, const RootTravelInput &p_input, Pose &r_now, Pose &r_next) {
	Travel *estimator = find(p_input.mode);
	if (!estimator && finds_travel(p_input.mode)) {
		estimator = make(p_input.mode);
	}
	const bool goes_on = _mode == p_input.mode;
	const Vec3 expected = _target;
	_mode = p_input.mode;
	if (!estimator) {
		_target = r_next.root;
		return;
	}
	const RigState &state = *p_input.state;
	if (!goes_on || p_input.begins) {
		estimator->reset(state.root);
		_foot_lock.clear();
		_path.clear();
	} else {
		give_in(*estimator, state.root - expected);
		if (!estimator->knows_what_carries() && p_input.ride->moves) {
			shift(*estimator, p_input.ride->apply(state.root) - state.root);
		}
	}
	estimate(p_rig, p_input, *estimator, r_now, r_next);
	if (goes_on) {
		stay_near(*estimator, state);
	}
	r_now.root = estimator->get_root();
	r_next.root = estimator->ahead(_points_next, p_input.delta_s);
	const float noise = p_input.filter->get_noise();
	_path.advance(r_now.root, noise, p_input.delta_s);
	if (noise > 0.0f) {
		r_now.root = _path.get_position();
		r_next.root = _path.ahead(p_input.delta_s);
	}
	place_feet(p_rig, *estimator, p_input.filter->get_unrest(), p_input.delta_s, r_now, r_next);
	_target = r_next.root;
}

void RootTravel::give_in(Travel &r_estimator, const Vec3 &p_off) {
	const Vec3 across{ p_off.x, 0.0f, p_off.z };
	const float distance = across.length();
	if (distance > SLACK) {
		shift(r_estimator, across * (1.0f - SLACK / distance));
	}
}

void RootTravel::stay_near(Travel &r_estimator, const RigState &p_state) {
	const Vec3 off = r_estimator.get_root() - Vec3{ 0.0f, _foot_lock.get_drop(), 0.0f } - p_state.root;
	const Vec3 up{ 0.0f, std::clamp(off.y, -FURTHEST_UP, FURTHEST_UP), 0.0f };
	const Vec3 across = Vec3{ off.x, 0.0f, off.z }.limited(FURTHEST_ACROSS);
	const Vec3 too_far = off - up - across;
	if (too_far.length() > 0.0f) {
		shift(r_estimator, too_far * -1.0f);
	}
}

void RootTravel::shift(Travel &r_estimator, const Vec3 &p_offset) {
	r_estimator.shift(p_offset);
	_foot_lock.shift(p_offset);
	_path.shift(p_offset);
}

void RootTravel::estimate(
		const Rig &p_rig, const RootTravelInput &p_input, Travel &r_estimator, Pose &r_now, Pose &r_next) {
	r_now.root = {};
	r_next.root = {};
	find_points(p_rig, r_next, _points_next);
	find_points(p_rig, r_now, _points_now);
	find_shown(p_rig, *p_input.state);
	for (std::size_t i = 0; i < p_rig.size(); i++) {
		_turns[i] = log(r_next.orientations[i] * r_now.orientations[i].inverse()) * (1.0f / p_input.delta_s);
	}
	GaitInput input;
	input.delta_s = p_input.delta_s;
	input.points = &_points_now;
	input.centre = p_rig.centre_of_mass(r_now, _joints);
	input.ground = p_input.ground ? p_input.ground : &_level_ground;
	input.gravity = p_input.state->gravity;
	input.turns = &_turns;
	input.shown = &_points_shown;
	r_estimator.step(input);
}

void RootTravel::place_feet(
		const Rig &p_rig, const Travel &p_estimator, float p_unrest, float p_delta_s, Pose &r_now, Pose &r_next) {
	_foot_lock.advance(p_estimator, r_now.root, _points_now, _points_shown, p_unrest, p_delta_s);
	p_rig.joint_positions(r_now, _joints);
	const float before = _foot_lock.get_drop();
	const float drop = _foot_lock.sink(p_rig, p_unrest, _joints, p_delta_s);
	r_now.root.y -= drop;
	r_next.root.y -= 2.0f * drop - before; // It goes on coming down.
	p_rig.joint_positions(r_now, _joints);
	_foot_lock.apply(p_rig, p_unrest, r_now, _joints);
	p_rig.joint_positions(r_next, _joints);
	_foot_lock.apply(p_rig, p_unrest, r_next, _joints);
}

void RootTravel::find_points(const Rig &p_rig, const Pose &p_pose, std::vector<Vec3> &r_points) {
	p_rig.joint_positions(p_pose, _joints);
	for (std::size_t i = 0; i < _contacts.size(); i++) {
		const std::size_t limb = std::size_t(_contacts[i].limb);
		r_points[i] = _joints[limb] + p_pose.orientations[limb].rotate(_contacts[i].local);
	}
}

void RootTravel::find_shown(const Rig &p_rig, const RigState &p_state) {
	for (std::size_t i = 0; i < _contacts.size(); i++) {
		const std::size_t limb = std::size_t(_contacts[i].limb);
		_points_shown[i] = p_rig.joint_of(p_state, limb) + p_state.orientations[limb].rotate(_contacts[i].local);
	}
}

void RootTravel::save(ArchiveWriter &p_archive) const {
	p_archive.put(_mode);
	p_archive.put(_target);
	p_archive.put(std::uint32_t(_estimators.size()));
	for (const ModeTravel &mode : _estimators) {
		p_archive.put(mode.mode);
		mode.estimator->save(p_archive);
	}
	_foot_lock.save(p_archive);
	_path.save(p_archive);
}

bool RootTravel::restore(ArchiveReader &p_archive) {
	std::uint32_t count = 0;
	if (!p_archive.get(_mode) || !p_archive.get(_target) || !p_archive.get(count)) {
		return false;
	}
	_estimators.clear();
	for (std::uint32_t i = 0; i < count; i++) {
		RootMode mode = RootMode::SOFT;
		if (!p_archive.get(mode) || find(mode)) {
			return false;
		}
		Travel *estimator = make(mode);
		if (!estimator || !estimator->restore(p_archive)) {
			return false;
		}
	}
	return _foot_lock.restore(p_archive) && _path.restore(p_archive);
}

} // namespace ragdoll
