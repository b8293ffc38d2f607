// SPDX-License-Identifier: MIT
#include "ragdoll_motor.hpp"

#include <convert.hpp>

#include <godot_cpp/classes/engine.hpp>

#include <algorithm>
#include <cmath>

namespace godot {

namespace {

constexpr double MIN_STEP = 1e-5;
constexpr double MAX_STEP = 1.0;

} // namespace

bool RagdollMotor::is_state_current() const {
	const Engine *engine = Engine::get_singleton();
	const bool is_in_step = engine->is_in_physics_frame();
	const uint64_t frame = engine->get_physics_frames();
	// The simulation steps at the end of a physics frame: what was read since serves in the next one.
	const bool is_next = is_in_step && !_is_read_in_step && frame == _read_frame + 1;
	return _is_state_read && (is_next || (is_in_step == _is_read_in_step && frame == _read_frame));
}

bool RagdollMotor::read_bodies() {
	if (is_state_current()) {
		return true;
	}
	_is_state_read = _bodies->read(_state);
	_is_read_in_step = Engine::get_singleton()->is_in_physics_frame();
	_read_frame = Engine::get_singleton()->get_physics_frames();
	return _is_state_read;
}

void RagdollMotor::resize_body_pose() {
	int64_t slot_count = int64_t(_plan.get_reset_pose().size());
	for (int64_t i = 0; i < _sample_slots.size(); i++) {
		slot_count = std::max<int64_t>(slot_count, std::min<int64_t>(_sample_slots[i] + 1, 256));
	}
	_body_pose.resize(3 + 4 * slot_count);
	_body_pose.fill(0.0);
}

void RagdollMotor::note_body_pose() {
	const int32_t *slots = _sample_slots.is_empty() ? nullptr : _sample_slots.ptr();
	float *pose = _body_pose.ptrw();
	const int64_t slot_count = (_body_pose.size() - 3) / 4;
	ragdoll::Vec3 centre;
	_driver->blend_shown(_state, _shown, centre);
	pose[0] = centre.x;
	pose[1] = centre.y;
	pose[2] = centre.z;
	for (std::size_t i = 0; i < _shown.size(); i++) {
		const int64_t slot = slots != nullptr ? slots[i] : int64_t(i);
		if (slot >= 0 && slot < slot_count) {
			const ragdoll::Quat &orientation = _shown[i];
			float *values = pose + 3 + slot * 4;
			values[0] = orientation.x;
			values[1] = orientation.y;
			values[2] = orientation.z;
			values[3] = orientation.w;
		}
	}
}

void RagdollMotor::release() {
	_is_state_read = false;
	_ground.detach();
	_bodies.reset();
	_driver.reset();
}

void RagdollMotor::apply_settings() {
	if (!_driver) {
		return;
	}
	_driver->root_mode = ragdoll::RootMode(_root_mode);
	_driver->root_settings.force = float(_root_force);
	_driver->root_settings.torque = float(_root_torque);
	ragdoll::BalanceSettings &balance = _driver->get_balance().settings;
	balance.residual = float(_residual_share);
	balance.torque = float(_root_torque);
	balance.standing_torque = std::min(float(_standing_torque), float(_root_torque));
	_driver->get_controller().settings.gain = float(_gain);
	_driver->get_controller().settings.muscle_speed = float(_muscle_speed);
	_driver->get_guard().max_energy = float(_max_energy);
	_driver->measures_torque = _measures_torque;
	_driver->get_meter().measures_lag = _measures_lag;
	_obstacles.set_mask(std::uint32_t(_ground_mask));
	_driver->obstacles = &_obstacles;
	look_at_ground();
}

void RagdollMotor::look_at_ground() {
	const bool wanted = _driver && is_inside_tree();
	_driver->ground = wanted ? &_ground : nullptr;
	if (wanted) {
		_ground.attach(this, _plan.get_bodies(), std::uint32_t(_ground_mask));
	} else {
		_ground.detach();
	}
}

bool RagdollMotor::push_sample(double p_time_s, const PackedFloat32Array &p_rotations, const Vector3 &p_root,
		const PackedFloat32Array &p_rates) {
	const std::size_t count = _plan.get_reset_pose().size();
	// A sample may be of more limbs than the profile has, where slots say which are meant.
	const bool is_chosen = !_sample_slots.is_empty();
	if (!_driver || (is_chosen && _sample_slots.size() != int64_t(count)) || p_rotations.size() % 4 != 0 ||
			(!is_chosen && p_rotations.size() != int64_t(count) * 4) ||
			(!p_rates.is_empty() && p_rates.size() != int64_t(count) * 3)) {
		return false;
	}
	const float *rotations = p_rotations.ptr();
	const int32_t *slots = is_chosen ? _sample_slots.ptr() : nullptr;
	const int64_t most = p_rotations.size() / 4;
	for (std::size_t i = 0; i < count; i++) {
		const int64_t slot = slots ? slots[i] : int64_t(i);
		if (slot < 0 || slot >= most) {
			return false;
		}
		const float *values = rotations + slot * 4;
		// Thesis section 6.2: q = r i.
		const ragdoll::Quat target =
				ragdoll::Quat{ values[0], values[1], values[2], values[3] } * _plan.get_reset_pose()[i];
		_targets[i * 4] = target.x;
		_targets[i * 4 + 1] = target.y;
		_targets[i * 4 + 2] = target.z;
		_targets[i * 4 + 3] = target.w;
	}
	return _driver->push(p_time_s, _targets.data(), to_core(p_root), p_rates.is_empty() ? nullptr : p_rates.ptr());
}

void RagdollMotor::clear_motion() {
	if (_driver) {
		_driver->clear_motion();
	}
}

bool RagdollMotor::snap_to(double p_time_s) {
	ERR_FAIL_COND_V_MSG(!std::isfinite(p_time_s), false, "RagdollMotor: the time is not finite.");
	if (!is_ready()) {
		return false;
	}
	_driver->pose_state(p_time_s, _state);
	_bodies->put(_state);
	_is_state_read = false;
	return true;
}

bool RagdollMotor::drive(double p_time_s, double p_delta_s) {
	// Written so that NaN fails too; a step that is next to nothing would divide by zero.
	ERR_FAIL_COND_V_MSG(!(p_delta_s >= MIN_STEP && p_delta_s <= MAX_STEP), false,
			"RagdollMotor: the time step must be above zero (0.00001 s or more) and 1 s at most.");
	ERR_FAIL_COND_V_MSG(!std::isfinite(p_time_s), false, "RagdollMotor: the time is not finite.");
	if (!is_ready() || !read_bodies()) {
		return false;
	}
	_is_state_read = false; // It is about to change, by us and by the step.
	if ((_driver->ground != nullptr) != is_inside_tree()) {
		look_at_ground(); // It has come into the tree, or left it, since.
	}
	const ragdoll::StepCommands &commands = _driver->step(_state, p_time_s, float(p_delta_s));
	if (commands.must_put) {
		_bodies->put(_state);
	}
	const std::uint32_t guarded = commands.guarded;
	_bodies->write(commands.limbs, commands.orientations, commands.joints);
	if (commands.is_root_held) {
		_bodies->hold_root(commands.orientations[0], commands.joints[0]);
	} else {
		_bodies->pull_root(_driver->root_mode, commands.root, commands.root_turn, commands.trunk_turn);
	}
	_bodies->push_limbs(commands.limbs, commands.pushes);
	if (guarded != ragdoll::GUARD_NOTHING) {
		report(guarded); // Last of all: whoever listens may release or free this node.
	}
	return true;
}

int64_t RagdollMotor::drive_all(
		const TypedArray<RagdollMotor> &p_motors, const PackedFloat64Array &p_times_s, double p_delta_s) {
	ERR_FAIL_COND_V_MSG(p_motors.size() != p_times_s.size(), 0, "RagdollMotor: there must be one time for each motor.");
	const double *times = p_times_s.ptr();
	int64_t driven = 0;
	for (int64_t i = 0; i < p_motors.size(); i++) {
		RagdollMotor *motor = Object::cast_to<RagdollMotor>(p_motors[i]);
		driven += motor && motor->drive(times[i], p_delta_s) ? 1 : 0;
	}
	return driven;
}

void RagdollMotor::report(std::uint32_t p_guarded) {
	emit_signal("guard_acted", int64_t(p_guarded));
}

bool RagdollMotor::is_stalled(double p_time_s) const {
	return !_driver || _driver->get_stream().is_stalled(p_time_s);
}

void RagdollMotor::set_actuation(Actuation p_mode, const StringName &p_group, double p_blend_s) {
	int group = -1;
	ERR_FAIL_COND_MSG(!_driver, "RagdollMotor: set_actuation() comes after setup().");
	ERR_FAIL_COND_MSG(
			int(p_mode) < 0 || int(p_mode) >= ragdoll::ACTUATION_COUNT, "RagdollMotor: there is no such actuation.");
	ERR_FAIL_COND_MSG(
			!_plan.find_group(p_group, group), "RagdollMotor: the profile has no group " + String(p_group) + ".");
	_driver->get_table().set_mode(ragdoll::Actuation(p_mode), group, float(p_blend_s));
}

RagdollMotor::Actuation RagdollMotor::get_actuation(const StringName &p_group) const {
	int group = -1;
	if (!_driver || !_plan.find_group(p_group, group)) {
		return VELOCITY_MOTOR;
	}
	for (std::size_t i = 0; i < _driver->get_rig().size(); i++) {
		if (group < 0 || _driver->get_rig()[i].group == group) {
			return Actuation(_driver->get_table().get_wanted_mode(i));
		}
	}
	return VELOCITY_MOTOR;
}

void RagdollMotor::set_group_strength(double p_strength, const StringName &p_group, double p_blend_s) {
	int group = -1;
	ERR_FAIL_COND_MSG(!_driver, "RagdollMotor: set_group_strength() comes after setup().");
	ERR_FAIL_COND_MSG(!is_amount(p_strength), "RagdollMotor: a strength is 0 or more.");
	ERR_FAIL_COND_MSG(
			!_plan.find_group(p_group, group), "RagdollMotor: the profile has no group " + String(p_group) + ".");
	_driver->get_table().set_strength(float(p_strength), group, float(p_blend_s));
}

double RagdollMotor::get_group_strength(const StringName &p_group) const {
	int group = -1;
	if (!_driver || !_plan.find_group(p_group, group)) {
		return 0.0;
	}
	return _driver->get_table().get_group_strength(group < 0 ? 0 : group);
}

void RagdollMotor::set_group_spring(double p_frequency, double p_damping_ratio, const StringName &p_group) {
	int group = -1;
	ERR_FAIL_COND_MSG(!_driver, "RagdollMotor: set_group_spring() comes after setup().");
	ERR_FAIL_COND_MSG(!is_amount(p_frequency) || !is_amount(p_damping_ratio),
			"RagdollMotor: a spring's frequency and damping ratio are 0 or more.");
	ERR_FAIL_COND_MSG(
			!_plan.find_group(p_group, group), "RagdollMotor: the profile has no group " + String(p_group) + ".");
	_driver->get_table().set_spring(float(p_frequency), float(p_damping_ratio), group);
}

} // namespace godot
