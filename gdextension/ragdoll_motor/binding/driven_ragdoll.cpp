// SPDX-License-Identifier: MIT
#include "driven_ragdoll.hpp"

#include <convert.hpp>

#include <godot_cpp/classes/engine.hpp>

#include <algorithm>
#include <utility>

namespace godot {

namespace {

ragdoll::Rig make_rig(const RagdollPlan &p_plan, const MotorSettings &p_settings) {
	std::vector<ragdoll::Segment> limbs = p_plan.get_segments();
	ragdoll::scale_inertia(limbs, float(p_settings.inertia_scale), float(p_settings.arm_inertia_scale));
	return ragdoll::Rig(std::move(limbs));
}

} // namespace

DrivenRagdoll::DrivenRagdoll(Node *p_owner, RagdollPlan p_plan, const MotorSettings &p_settings, const RID &p_space) :
		_owner(p_owner),
		_plan(std::move(p_plan)),
		_driver(make_rig(_plan, p_settings), _plan.get_limb_groups(), _plan.get_group_count(), _plan.get_contacts()) {
	_driver.righted_limb = _plan.get_righted_limb();
	_driver.obstacles = &_obstacles;
	_obstacles.attach(_plan.get_bodies(), p_space);
	_state.resize(_plan.get_segments().size());
	apply(p_settings);
	_bodies.make(_driver.get_rig(), _plan.get_specs(), p_space);
	_bodies.set_righted_limb(_driver.righted_limb);
	_bodies.prepare(p_settings.self_collision);
}

void DrivenRagdoll::apply(const MotorSettings &p_settings) {
	p_settings.apply(_driver);
	_ground_mask = std::uint32_t(p_settings.ground_mask);
	_obstacles.set_mask(_ground_mask);
	look_at_ground();
}

TypedArray<RID> DrivenRagdoll::get_joints() const {
	TypedArray<RID> result;
	for (std::size_t i = 0; i < _driver.get_rig().size(); i++) {
		result.append(_bodies.get_joint(i));
	}
	return result;
}

void DrivenRagdoll::look_at_ground() {
	const bool wanted = _owner->is_inside_tree();
	_driver.ground = wanted ? &_ground : nullptr;
	if (wanted) {
		_ground.attach(_owner, _plan.get_bodies(), _ground_mask);
	} else {
		_ground.detach();
	}
}

bool DrivenRagdoll::is_state_current() const {
	const Engine *engine = Engine::get_singleton();
	const bool is_in_step = engine->is_in_physics_frame();
	const uint64_t frame = engine->get_physics_frames();
	// The simulation steps at the end of a physics frame: what was read since serves in the next one.
	const bool is_next = is_in_step && !_is_read_in_step && frame == _read_frame + 1;
	return _is_state_read && (is_next || (is_in_step == _is_read_in_step && frame == _read_frame));
}

bool DrivenRagdoll::read_if_old() {
	if (is_state_current()) {
		return true;
	}
	_is_state_read = read();
	_is_read_in_step = Engine::get_singleton()->is_in_physics_frame();
	_read_frame = Engine::get_singleton()->get_physics_frames();
	return _is_state_read;
}

bool DrivenRagdoll::drive(double p_time_s, float p_delta_s, std::uint32_t &r_guarded) {
	if (!read_if_old()) {
		return false;
	}
	_is_state_read = false; // It is about to change, by us and by the step.
	if ((_driver.ground != nullptr) != _owner->is_inside_tree()) {
		look_at_ground(); // The owner has come into the tree, or left it, since.
	}
	_driver.note_hold(_bodies.weigh_hold(_state.root, p_delta_s));
	const ragdoll::StepCommands &commands = _driver.step(_state, p_time_s, p_delta_s);
	if (commands.must_put) {
		_bodies.put(_state);
	}
	_bodies.write(commands.limbs, commands.orientations, commands.joints);
	if (commands.is_root_held) {
		_bodies.hold_root(commands.orientations[0], commands.joints[0]);
	} else {
		_bodies.pull_root(_driver.root_mode, commands.root, commands.root_turn);
	}
	_bodies.push_limbs(commands.limbs, commands.pushes);
	r_guarded = commands.guarded;
	return true;
}

void DrivenRagdoll::snap_to(double p_time_s) {
	_driver.pose_state(p_time_s, _state);
	_bodies.put(_state);
	_is_state_read = false;
}

int DrivenRagdoll::hit(
		const Vector3 &p_impulse, const Vector3 &p_position, float p_strength, float p_blend_s, int p_group) {
	if (!read()) {
		return -1;
	}
	const ragdoll::ActuationTable &table = _driver.get_table();
	std::vector<float> before(_driver.get_rig().size());
	for (std::size_t i = 0; i < before.size(); i++) {
		before[i] = table.get_flinch(i);
	}
	const int limb = _driver.hit(_state, to_core(p_impulse), to_core(p_position), p_group, p_strength, p_blend_s);
	if (limb >= 0) {
		for (std::size_t i = 0; i < before.size(); i++) {
			const float after = std::max(table.get_flinch(i), ragdoll::ActuationTable::LIMP_FRICTION);
			_bodies.weaken(i, after / std::max(before[i], after));
		}
		_bodies.strike(std::size_t(limb), p_impulse, p_position - from_core(_state.centres[std::size_t(limb)]));
	}
	_is_state_read = false; // Its velocities are others now.
	return limb;
}

void DrivenRagdoll::put_anew() {
	look_at_ground();
	_is_state_read = false;
	_bodies.remake();
	_bodies.put(_state);
}

} // namespace godot
