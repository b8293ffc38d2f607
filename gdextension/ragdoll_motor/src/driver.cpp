// SPDX-License-Identifier: MIT
#include "driver.hpp"

#include "balance/ease.hpp"
#include "body/fingerprint.hpp"
#include "body/placement.hpp"
#include "comparison/comparison.hpp"
#include "control/hit.hpp"
#include "gait/inertial_gait.hpp"

#include <algorithm>
#include <utility>

namespace ragdoll {

namespace {

std::unique_ptr<Travel> make_travel(RootMode p_mode, const std::vector<ContactPoint> &p_contacts) {
	if (p_mode == RootMode::INERTIAL) {
		return std::make_unique<InertialGait>(p_contacts);
	}
	return make_thesis_travel(p_mode, p_contacts);
}

} // namespace

Driver::Driver(Rig p_rig, const std::vector<int> &p_groups, std::size_t p_group_count,
		const std::vector<ContactPoint> &p_contacts) :
		_rig(std::move(p_rig)),
		_contacts(p_contacts),
		_stream(_rig.size()),
		_clearance(_rig),
		_table(p_groups, p_group_count),
		_controller(_rig, make_thesis_joints),
		_pushes(_rig),
		_travel(_rig, p_contacts, make_travel),
		_balance(_rig, p_contacts),
		_surfaces(_rig),
		_torques(_rig.size()),
		_arrival(_rig.size()),
		_errors(_rig.size(), 0.0f) {
	_commands.orientations.resize(_rig.size());
	_commands.joints.resize(_rig.size());
	_commands.pushes.resize(_rig.size());
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

void Driver::clear_motion() {
	_frame.restart();
	_stream.clear();
	_meter.forget_waiting();
	_watch.clear();
}

const StepCommands &Driver::step(RigState &r_state, double p_time_s, float p_delta_s) {
	_commands.guarded = _guard.check(_rig, r_state);
	_commands.must_put = _commands.guarded != GUARD_NOTHING;
	const bool is_seated = find_motion(r_state, p_time_s, p_delta_s);
	const bool lands = _landing.advance(_rig, obstacles, _frame.get_way(r_state.root), p_delta_s, r_state);
	// Who sits in something is in it.
	const bool is_turned = !_frame.is_set() && _surfaces.advance(_rig, _table, obstacles, r_state);
	_commands.must_put = lands || is_turned || _commands.must_put;
	const bool begins = !_watch.has_begun();
	const bool is_teleported = _stream.take_teleport() && is_pulled();
	const bool was_stalled = _watch.is_stalled();
	const bool has_come_back = _watch.advance(_stream, p_time_s) &&
			(begins || _table.get_mode(0) != Actuation::LIMP); // Whoever lies limp stays where he lies.
	const bool goes_on = !begins && _watch.has_resumed() && can_go_on();
	if (is_seated) {
		_frame.move(_now);
	}
	_clearance.advance(_rig, begins || is_teleported || has_come_back || is_seated, p_delta_s, _now, _next);
	bool finds_anew = finds_travel(root_mode) && _travel.get_mode() != root_mode;
	const bool must_jump =
			hold_back(r_state, begins || is_seated, has_come_back || is_teleported || is_seated, goes_on, p_delta_s);
	if (must_jump || (_commands.guarded & GUARD_LOST) != 0) {
		put_into_pose(r_state);
		_commands.must_put = true;
		finds_anew = finds_travel(root_mode);
		_arrival.begin();
	}
	if (goes_on && !must_jump) {
		go_on(r_state);
		finds_anew = finds_travel(root_mode);
	}
	travel(r_state, p_delta_s);
	// Who is only carried along by what turns keeps the pose and the speed that he has.
	const bool was_put = _arrival.is_on() || _commands.guarded != GUARD_NOTHING;
	if (was_put && finds_anew) {
		place(r_state); // On the ground that was found, wherever the root was told to be.
	}
	if (_watch.is_stalled() && !was_stalled) {
		_arrival.note_stall(_rig, r_state, _now);
	}
	arrive(r_state, _stream.knows_rates() || _watch.is_stalled(), p_delta_s);
	balance(r_state, p_delta_s);
	const bool is_stalled = p_time_s - _stream.newest() > LET_GO_AFTER;
	_table.set_overall(is_stalled ? STALLED_STRENGTH : 1.0f, _arrival.is_on() ? 0.0f : LET_GO_S);
	_table.advance(p_delta_s);
	compute_limbs(r_state, p_delta_s);
	_pushes.advance(_rig, r_state, _now, _next, p_delta_s, _commands.limbs, _commands.pushes);
	if (measures_torque) {
		_torques.note(_rig, r_state, p_delta_s);
		_torques.compare(_rig, _table, _residual.get_latest().torque.length(), root_settings.torque);
	}
	command_root(r_state, p_delta_s);
	place_kinematic(r_state, p_delta_s);
	return _commands;
}

bool Driver::find_motion(RigState &r_state, double p_time_s, float p_delta_s) {
	_frame.advance(_rig, _contacts, r_state, ground, p_delta_s);
	const Vec3 &spiral = _frame.get_carrier().get_spiral();
	// The tether draws the others back to where they stood.
	if (!is_tethered(root_mode) && spiral.length() > 0.0f) {
		for (Vec3 &centre : r_state.centres) {
			centre = centre - spiral;
		}
		r_state.root = r_state.root - spiral;
		_commands.must_put = true;
	}
	_stream.predict(p_time_s, _now);
	// A pose that comes after a pause is not the end of a step that begins within that.
	_stream.predict(_stream.is_stalled(p_time_s) ? p_time_s : p_time_s + double(p_delta_s), _next);
	_frame.apply(_now, _next);
	// Whoever moves the frame at once means it: a seat is taken whatever is between.
	const float carried = _frame.get_way(_now.root).length();
	return carried > PoseStream::TELEPORT_DISTANCE && carried > PoseStream::FASTEST_ROOT * p_delta_s && is_pulled();
}

bool Driver::can_go_on() const {
	// Whoever lies is not stood up by a pause, and where feet alone move the root nothing pulls it along.
	return !is_free(root_mode) && _table.get_mode(0) != Actuation::LIMP && (root_mode != RootMode::GROUNDED || _stood);
}

Vec3 Driver::find_offset() const {
	return root_mode == RootMode::GROUNDED ? _steady_offset : Vec3();
}

void Driver::go_on(RigState &r_state) {
	const bool finds = finds_travel(root_mode);
	_now.root = finds ? r_state.root : _now.root;
	_arrival.begin_from(_rig, r_state, _now, find_offset(), finds, _table, obstacles);
	if (finds) {
		place(r_state);
	}
}

void Driver::arrive(RigState &r_state, bool p_may_end, float p_delta_s) {
	if (_arrival.is_on()) {
		forget();
		_arrival.advance(_rig, _now, _next, p_may_end, p_delta_s, r_state);
		_commands.must_put = true;
	}
}

bool Driver::hold_back(const RigState &p_state, bool p_begins, bool p_jumps, bool p_goes_on, float p_delta_s) {
	const bool goes_on = _travel.get_mode() == root_mode;
	const Vec3 motion = _now.root - p_state.root + (p_jumps ? Vec3() : find_offset());
	// Where the travel is found, the motion's own root means nothing in the world.
	const bool is_stopped = (p_jumps || p_goes_on) && !p_begins && !finds_travel(root_mode) &&
			motion.length() > SHORT_JUMP && blocks_root(obstacles, p_state, motion);
	if (p_begins || p_jumps || !goes_on || !is_tethered(root_mode)) {
		_tether.clear();
	}
	if (is_stopped && root_mode == RootMode::GROUNDED) {
		_balance.shift(level(_travel.get_target() - _now.root));
		_steady_offset = _balance.get_offset();
	} else if (is_stopped) {
		_tether.set(p_state.root - _now.root);
	} else if (!p_jumps && is_tethered(root_mode) && goes_on && _table.get_mode(0) != Actuation::LIMP) {
		_tether.advance(p_state.root - _travel.get_target(), p_delta_s);
	}
	_now.root = _now.root + _tether.get_now();
	_next.root = _next.root + _tether.get_next();
	return p_jumps && !is_stopped;
}

void Driver::travel(const RigState &p_state, float p_delta_s) {
	RootTravelInput input;
	input.mode = root_mode;
	input.state = &p_state;
	input.ground = ground;
	input.filter = &_stream.get_filter();
	input.ride = &_frame.get_carrier().get_past();
	// Whoever lies limp is wherever the body is, and begins from there when he gets up. How a pose has changed
	// while nothing came says nothing of where the person went.
	input.begins = _table.get_mode(0) == Actuation::LIMP || _watch.has_resumed();
	input.delta_s = p_delta_s;
	_travel.advance(_rig, input, _now, _next);
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
	input.turn = _frame.get_turn();
	input.shift = _frame.get_shift();
	input.delta_s = p_delta_s;
	input.gravity = std::max(-p_state.gravity.y, 0.0f);
	input.is_limp = _table.get_mode(0) == Actuation::LIMP;
	_balance.advance(_rig, input, _now, _next);
	if (!_watch.is_stalled()) {
		_steady_offset = _balance.get_offset();
		_stood = _balance.get_recovery().get_phase() == Recovery::Phase::NONE;
	}
	_controller.settings.root_deceleration = _balance.get_deceleration();
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
		ease_limbs(_rig, _controller.get_inertia(), p_state, _now, _next, _balance.get_ease(),
				_balance.settings.ease_frequency, p_delta_s, _commands.limbs);
	}
}

void Driver::command_root(const RigState &p_state, float p_delta_s) {
	const Actuation mode = _table.get_mode(0);
	const bool is_limp = mode == Actuation::LIMP;
	_commands.is_root_held = mode == Actuation::DIRECT_SET ||
			(root_mode == RootMode::HELD && !is_limp &&
					(_commands.must_put ||
							!_held_root.is_obstructed(_rig, _table, obstacles, p_state, _now, _next, p_delta_s)));
	root_settings.gain = _controller.settings.gain * _controller.settings.eagerness;
	_getting_up.advance(p_state, _now, _next, is_limp, finds_travel(root_mode), RootTravel::FURTHEST_UP, p_delta_s);
	const Vec3 &lift = _getting_up.get_lift();
	const float strength = is_limp ? 0.0f : _table.get_standing_strength(0);
	_commands.root_turn = _commands.limbs[0].velocity;
	if (is_free(root_mode)) {
		_commands.root = drive_thesis_root(
				root_mode, root_settings, p_state, _now, _next, _commands.root_turn, righted_limb, p_delta_s, strength);
	} else {
		_commands.root = drive_root(
				root_mode, root_settings, _rig, p_state, _now.root + lift, _next.root + lift, p_delta_s, strength);
	}
	if (root_mode == RootMode::GROUNDED) {
		_commands.root.torque = _balance.get_torque() * strength;
		_commands.root.push = _balance.get_force() * strength;
		LimbPush &push = _commands.pushes[0];
		push.torque = push.torque + _balance.get_recovery().get_help() * (strength * _table.get_flinch(0));
	}
	// A hit shoves and turns the hips too, but drops nobody.
	_commands.root.weaken(_table.get_flinch(0));
	_residual.expect({ _commands.root.push, _commands.pushes[0].torque });
}

void Driver::place_kinematic(const RigState &p_state, float p_delta_s) {
	if (_table.has_mode(Actuation::DIRECT_SET)) {
		place_limbs(_rig, p_state, _next, p_delta_s, _table, _commands.orientations, _commands.joints);
	}
	if (_commands.is_root_held && _table.get_mode(0) != Actuation::DIRECT_SET) {
		_held_root.place(p_state, _now, _next, _getting_up.get_lift(), p_delta_s, _commands.orientations[0],
				_commands.joints[0]);
	}
	_held_root.finish(_commands.is_root_held);
}

void Driver::put_into_pose(RigState &r_state) {
	if (_travel.find(root_mode) && _travel.get_mode() == root_mode) {
		_now.root = _travel.get_target();
	}
	place(r_state);
}

void Driver::place(RigState &r_state) {
	place_at_rest(_rig, _now, _joints, r_state);
	forget();
}

void Driver::forget() {
	_controller.reset();
	_pushes.clear();
	_balance.clear();
	_torques.clear();
}

void Driver::pose_state(double p_time_s, RigState &r_state) {
	_stream.predict(p_time_s, _now);
	_frame.to_world(_now);
	_clearance.clear(_rig, _now);
	_next = _now;
	put_into_pose(r_state);
}

void Driver::set_control(std::size_t p_limb, const LimbControl &p_control, float p_blend_s) {
	apply_to_joint(p_control, _rig, _controller.settings, p_limb, p_blend_s, _table);
	_pushes.set_springs(p_limb, p_control, p_blend_s);
}

int Driver::hit(const RigState &p_state, const Vec3 &p_impulse, const Vec3 &p_position, int p_group, float p_strength,
		float p_blend_s) {
	return give_way(_rig, p_state, p_impulse, p_position, p_group, p_strength, p_blend_s, _table);
}

void Driver::blend_shown(const RigState &p_state, std::vector<Quat> &r_orientations, Vec3 &r_root_centre) const {
	ragdoll::blend_shown(_rig, _table, _next, p_state, r_orientations, r_root_centre);
}

const std::vector<float> &Driver::find_errors(const RigState &p_state) {
	for (std::size_t i = 0; i < _now.orientations.size(); i++) {
		_errors[i] = angle_between(p_state.orientations[i], _now.orientations[i]);
	}
	return _errors;
}

void Driver::measure(double p_time_s, const RigState &p_state) {
	if (_stream.is_empty() || _stream.is_stalled(p_time_s)) {
		return;
	}
	_joints.resize(_rig.size());
	for (std::size_t i = 0; i < _rig.size(); i++) {
		_joints[i] = _rig.joint_of(p_state, i);
	}
	if (_frame.is_world()) {
		_meter.note(p_time_s, p_state.orientations, _joints);
		return;
	}
	// The motion knows nothing of what carries the person: they are compared in the motion's own frame.
	_measured = p_state.orientations;
	_frame.to_own(_measured, _joints);
	_meter.note(p_time_s, _measured, _joints);
}

void Driver::save(ArchiveWriter &p_archive) const {
	p_archive.put(find_fingerprint(_rig, _contacts));
	p_archive.put(root_mode);
	_arrival.save(p_archive);
	p_archive.put(_steady_offset);
	p_archive.put(_stood);
	_watch.save(p_archive);
	_getting_up.save(p_archive);
	_held_root.save(p_archive);
	_frame.save(p_archive);
	_clearance.save(p_archive);
	_surfaces.save(p_archive);
	_tether.save(p_archive);
	_travel.save(p_archive);
	_balance.save(p_archive);
	_stream.save(p_archive);
	_table.save(p_archive);
	_controller.save(p_archive);
	_pushes.save(p_archive);
}

bool Driver::restore(ArchiveReader &p_archive) {
	ArchiveWriter before;
	save(before);
	if (read(p_archive)) {
		return true;
	}
	ArchiveReader back(before.get_bytes().data(), before.get_bytes().size());
	read(back);
	return false;
}

bool Driver::read(ArchiveReader &p_archive) {
	std::uint64_t whose = 0;
	RootMode mode = RootMode::SOFT;
	// Archives hold indices of tables: those of another body must not come any further.
	if (!p_archive.get(whose) || whose != find_fingerprint(_rig, _contacts) || !p_archive.get(mode) || int(mode) < 0 ||
			int(mode) >= ROOT_MODE_COUNT) {
		return false;
	}
	root_mode = mode;
	_torques.clear();
	return _arrival.restore(p_archive) && p_archive.get(_steady_offset) && p_archive.get(_stood) &&
			_watch.restore(p_archive) && _getting_up.restore(p_archive) && _held_root.restore(p_archive) &&
			_frame.restore(p_archive) && _clearance.restore(p_archive) && _surfaces.restore(p_archive) &&
			_tether.restore(p_archive) && _travel.restore(p_archive) && _balance.restore(p_archive) &&
			_stream.restore(p_archive) && _table.restore(p_archive) && _controller.restore(p_archive) &&
			_pushes.restore(p_archive);
}

} // namespace ragdoll
