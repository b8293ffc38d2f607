// SPDX-License-Identifier: MIT
#include "driver.hpp"

#include "comparison/lowest_contact.hpp"
#include "comparison/lowest_foot.hpp"
#include "gait/inertial_gait.hpp"

#include <algorithm>
#include <utility>

namespace ragdoll {

Driver::Driver(Rig p_rig, const std::vector<int> &p_groups, std::size_t p_group_count,
		const std::vector<ContactPoint> &p_contacts) :
		_rig(std::move(p_rig)),
		_stream(_rig.size()),
		_table(p_groups, p_group_count),
		_controller(_rig),
		_world(_rig.size()),
		_feed_forward(_rig),
		_torques(_rig.size()),
		_errors(_rig.size(), 0.0f),
		_saturations(_rig.size(), 0.0f),
		_contacts(p_contacts),
		_points_now(p_contacts.size()),
		_points_next(p_contacts.size()),
		_points_shown(p_contacts.size()),
		_turns(_rig.size()) {
	_foot_lock = FootLock(_rig, p_contacts);
	_balance = Balance(_rig, p_contacts);
	_travels[0] = std::make_unique<LowestFoot>(p_contacts);
	_travels[1] = std::make_unique<LowestContact>(p_contacts);
	_travels[2] = std::make_unique<InertialGait>(p_contacts);
	_commands.orientations.resize(_rig.size());
	_commands.joints.resize(_rig.size());
	_commands.pushes.resize(_rig.size());
	_joints_next.resize(_rig.size());
}

bool Driver::push(double p_time_s, const float *p_orientations, const Vec3 &p_root, const float *p_rates) {
	_stream.set_calms(finds_travel(root_mode)); // Noise in the pose makes feet skate that have to stand.
	const double before = _stream.is_empty() ? p_time_s : _stream.newest();
	if (!_stream.push(p_time_s, p_orientations, p_root, p_rates)) {
		return false;
	}
	if (p_time_s < before) {
		_meter.forget_waiting(); // The clock has been set back.
	}
	_meter.settle(_stream, _rig);
	return true;
}

const StepCommands &Driver::step(RigState &r_state, double p_time_s, float p_delta_s) {
	_commands.guarded = _guard.check(_rig, r_state);
	_commands.must_put = _commands.guarded != GUARD_NOTHING;
	ride(r_state, p_delta_s);
	_stream.predict(p_time_s, _now);
	_frame_now.apply(_now);
	_stream.predict(p_time_s + double(p_delta_s), _next);
	_frame_next.apply(_next);
	_frame_now = _frame_next;
	bool finds_anew = finds_travel(root_mode) && _travelled != root_mode;
	bool is_arriving = false;
	const bool begins = _alive == NEVER;
	const bool teleported = _stream.take_teleport() && !finds_travel(root_mode) && !is_free(root_mode);
	// Whoever moves the frame at once means it: a seat is taken whatever is between.
	const Vec3 carried = _frame_turn.rotate(_now.root) + _frame_shift - _now.root;
	const bool seated = carried.length() > PoseStream::TELEPORT_DISTANCE &&
			carried.length() > PoseStream::FASTEST_ROOT * p_delta_s && !finds_travel(root_mode) && !is_free(root_mode);
	const bool is_elsewhere = has_come_back(p_time_s) || teleported || seated;
	MotionFrame{ _frame_turn, _frame_shift, !seated }.apply(_now);
	const bool must_jump = hold_back(r_state, begins || seated, is_elsewhere, p_delta_s);
	if (must_jump || (_commands.guarded & GUARD_LOST) != 0) {
		put_into_pose(r_state);
		_commands.must_put = true;
		finds_anew = finds_travel(root_mode);
		_arrival_s = needs_ground(root_mode) ? ARRIVAL_S : 0.0f;
	} else if (_arrival_s > 0.0f) {
		// How fast the motion is only its next samples tell; feet alone could not take the body along.
		_arrival_s -= p_delta_s;
		is_arriving = true;
		_commands.must_put = true;
	}
	travel(r_state, p_delta_s);
	// Who is only carried along by what turns keeps the pose and the speed that he has.
	const bool was_put = must_jump || _commands.guarded != GUARD_NOTHING;
	if (is_arriving || (was_put && finds_anew)) {
		place(r_state); // On the ground that was found, wherever the root was told to be.
	}
	if (is_arriving) {
		set_in_motion(r_state, p_delta_s);
	}
	balance(r_state, p_delta_s);
	let_go_when_stalled(p_time_s);
	_table.advance(p_delta_s);
	compute_limbs(r_state, p_delta_s);
	push_limbs(r_state, p_delta_s);
	note_torques(r_state, p_delta_s);
	command_root(r_state, p_delta_s);
	if (_table.has_mode(Actuation::DIRECT_SET)) {
		place_limbs(_rig, r_state, _next, p_delta_s, _table, _commands.orientations, _commands.joints);
	}
	if (_commands.is_root_held && _table.get_mode(0) != Actuation::DIRECT_SET) {
		hold_root(r_state, p_delta_s);
	}
	_was_held = _commands.is_root_held;
	return _commands;
}

void Driver::hold_root(const RigState &p_state, float p_delta_s) {
	_commands.orientations[0] = _next.orientations[0];
	_commands.joints[0] = _next.root + _lift;
	const Vec3 displacement = _commands.joints[0] - p_state.root;
	const Vec3 turn = log(p_state.orientations[0].inverse() * _next.orientations[0]);
	const float distance = displacement.length() - (_next.root - _now.root).length();
	const float angle = turn.length() - angle_between(_now.orientations[0], _next.orientations[0]);
	_is_fetched = (_is_fetched || !_was_held) && (distance > FETCHED || angle > FETCHED);
	if (_is_fetched) {
		const float part =
				std::min(1.0f, p_delta_s / std::max(std::max(distance / FETCH_SPEED, angle / FETCH_TURN), p_delta_s));
		_commands.orientations[0] = p_state.orientations[0] * exp(turn * part);
		_commands.joints[0] = p_state.root + displacement * part;
	}
}

void Driver::compute_limbs(const RigState &p_state, float p_delta_s) {
	// A body that stands on shaking feet skates: noise is followed less eagerly.
	const float calmed = get_travel() ? CALMED * _stream.get_filter().get_unrest() : 0.0f;
	const bool is_grounded = root_mode == RootMode::GROUNDED;
	_controller.settings.eagerness = is_grounded ? _balance.get_eagerness() : 1.0f - calmed;
	for (std::size_t i = 0; i < _rig.size(); i++) {
		const bool bears = _rig.is_in_leg(i) || _rig[i].group == _rig[0].group;
		_table.set_scale(i, is_grounded ? _balance.get_strength(bears) : 1.0f);
	}
	_controller.compute(p_state, _now, _next, p_delta_s, _table, _commands.limbs);
	if (is_grounded) {
		ease_limbs(p_state, p_delta_s);
	}
}

bool Driver::has_come_back(double p_time_s) {
	_has_resumed = false;
	if (_stream.is_stalled(p_time_s)) {
		return false;
	}
	_has_resumed = p_time_s - _alive > PoseStream::STALL_AFTER;
	const bool paused = p_time_s - _alive > PUT_AFTER;
	_alive = p_time_s;
	return paused;
}

Travel *Driver::find_travel(RootMode p_mode) const {
	switch (p_mode) {
		case RootMode::LOWEST_FOOT:
			return _travels[0].get();
		case RootMode::CONTACTS:
			return _travels[1].get();
		case RootMode::INERTIAL:
			return _travels[2].get();
		default:
			return nullptr;
	}
}

void Driver::balance(const RigState &p_state, float p_delta_s) {
	if (root_mode != RootMode::GROUNDED) {
		_balance.clear();
		_controller.settings.root_deceleration = 0.0f;
		return;
	}
	BalanceInput input;
	input.state = &p_state;
	input.ground = ground ? ground : &_level_ground;
	input.turn = _frame_turn;
	input.shift = _frame_shift;
	input.delta_s = p_delta_s;
	input.gravity = std::max(-p_state.gravity.y, 0.0f);
	_balance.advance(_rig, input, _now, _next);
	_controller.settings.root_deceleration = _balance.get_deceleration();
}

void Driver::let_go_when_stalled(double p_time_s) {
	const bool stalled = p_time_s - _stream.newest() > LET_GO_AFTER;
	_table.set_overall(stalled ? STALLED_STRENGTH : 1.0f, LET_GO_S);
}

void Driver::command_root(const RigState &p_state, float p_delta_s) {
	const Actuation mode = _table.get_mode(0);
	const bool holds = root_mode == RootMode::HELD && mode != Actuation::LIMP;
	_commands.is_root_held =
			mode == Actuation::DIRECT_SET || (holds && (_commands.must_put || !is_obstructed(p_state, p_delta_s)));
	root_settings.gain = _controller.settings.gain * _controller.settings.eagerness;
	_lift = { 0.0f, lift_while_getting_up(p_state, p_delta_s), 0.0f };
	const float strength = mode == Actuation::LIMP ? 0.0f : _table.get_standing_strength(0);
	_commands.root = drive_root(
			root_mode, root_settings, _rig, p_state, _now.root + _lift, _next.root + _lift, p_delta_s, strength);
	if (root_mode == RootMode::GROUNDED) {
		_commands.root.torque = _balance.get_torque() * strength;
		_commands.root.push = _balance.get_force() * strength;
	}
	// A hit shoves and turns the hips too, but drops nobody.
	const float flinch = _table.get_flinch(0);
	_commands.root.force_across *= flinch;
	_commands.root.torque *= flinch;
	_commands.root.assist_torque *= flinch;
	_commands.root_turn = _commands.limbs[0].velocity;
	if (root_mode == RootMode::SELF_RIGHTING && righted_limb > 0) {
		const std::size_t limb = std::size_t(righted_limb);
		_commands.trunk_turn = righting_velocity(p_state.orientations[limb], _now.orientations[limb],
				_next.orientations[limb], p_delta_s, _controller.settings.gain);
	}
}

float Driver::lift_while_getting_up(const RigState &p_state, float p_delta_s) {
	const bool limp = _table.get_mode(0) == Actuation::LIMP;
	_is_getting_up = (_is_getting_up || _was_limp) && !limp;
	_was_limp = limp;
	_gets_up_s = _is_getting_up && finds_travel(root_mode) ? _gets_up_s + p_delta_s : 0.0f;
	if (!_is_getting_up) {
		return 0.0f;
	}
	float error = 0.0f;
	for (const float off : find_errors(p_state)) {
		error += off / float(_rig.size());
	}
	_upright_s = error > UPRIGHT ? 0.0f : _upright_s + p_delta_s;
	_is_getting_up = _upright_s < UPRIGHT_S;
	const float more = std::clamp(1.0f + (_gets_up_s - STUCK_S) * LIFTS_MORE, 1.0f, MAX_LIFT);
	const float lift = std::min(error, 0.5f) * GETTING_UP_LIFT * more;
	const float highest = std::max(p_state.root.y + FURTHEST_UP - _next.root.y, 0.0f);
	return finds_travel(root_mode) ? std::min(lift, highest) : lift;
}

const std::vector<float> &Driver::find_errors(const RigState &p_state) {
	for (std::size_t i = 0; i < _now.orientations.size(); i++) {
		_errors[i] = angle_between(p_state.orientations[i], _now.orientations[i]);
	}
	return _errors;
}

void Driver::note_torques(const RigState &p_state, float p_delta_s) {
	if (!measures_torque) {
		return;
	}
	_torques.note(_rig, p_state, p_delta_s);
	for (std::size_t i = 0; i < _rig.size(); i++) {
		const float most = i == 0 ? root_settings.torque : _rig[i].max_torque * _table.get_strength(i);
		_saturations[i] = most > 0.0f ? _torques.get_torques()[i] / most : 0.0f;
	}
}

void Driver::put_into_pose(RigState &r_state) {
	if (find_travel(root_mode) && _travelled == root_mode) {
		_now.root = _next_root;
	}
	place(r_state);
}

void Driver::place(RigState &r_state) {
	_rig.joint_positions(_now, _joints);
	for (std::size_t i = 0; i < _rig.size(); i++) {
		r_state.orientations[i] = _now.orientations[i];
		r_state.centres[i] = _joints[i] + _now.orientations[i].rotate(_rig[i].centre);
		r_state.linear[i] = {};
		r_state.angular[i] = {};
	}
	r_state.root = _now.root;
	_controller.reset();
	_feed_forward.clear();
	_balance.clear();
	_torques.clear();
}

void Driver::set_in_motion(RigState &r_state, float p_delta_s) {
	const float rate = 1.0f / p_delta_s;
	_joints_next.resize(_rig.size());
	_rig.joint_positions(_next, _joints_next);
	for (std::size_t i = 0; i < _rig.size(); i++) {
		const Vec3 centre = _joints_next[i] + _next.orientations[i].rotate(_rig[i].centre);
		r_state.linear[i] = (centre - r_state.centres[i]) * rate;
		const Quat turn = _next.orientations[i] * _now.orientations[i].inverse();
		r_state.angular[i] = log(turn) * rate;
	}
}

void Driver::pose_state(double p_time_s, RigState &r_state) {
	_stream.predict(p_time_s, _now);
	_frame_next.apply(_now);
	_next = _now;
	put_into_pose(r_state);
}

void Driver::measure(double p_time_s, const RigState &p_state) {
	if (_stream.is_empty() || _stream.is_stalled(p_time_s)) {
		return;
	}
	_joints.resize(_rig.size());
	for (std::size_t i = 0; i < _rig.size(); i++) {
		_joints[i] = _rig.joint_of(p_state, i);
	}
	if (_frame_next.is_identity) {
		_meter.note(p_time_s, p_state.orientations, _joints);
		return;
	}
	// The motion knows nothing of what carries the person: they are compared in the motion's own frame.
	const Quat back = _frame_next.orientation.inverse();
	_measured = p_state.orientations;
	for (std::size_t i = 0; i < _rig.size(); i++) {
		_measured[i] = back * _measured[i];
		_joints[i] = back.rotate(_joints[i] - _frame_next.origin);
	}
	_meter.note(p_time_s, _measured, _joints);
}

} // namespace ragdoll
