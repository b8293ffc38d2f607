// SPDX-License-Identifier: MIT
#include "ragdoll_control.hpp"

#include <algorithm>

namespace godot {

void RagdollControl::change(double &r_member, double p_value) {
	// Written so that NaN fails too; the core has it as a float.
	ERR_FAIL_COND_MSG(!(p_value >= 0.0 && p_value <= 1e30), "RagdollControl: this is a number of 0 or more.");
	r_member = p_value;
	emit_changed();
}

void RagdollControl::set_limbs(const PackedStringArray &p_limbs) {
	_limbs = p_limbs;
	emit_changed();
}

void RagdollControl::set_actuation(int64_t p_actuation) {
	ERR_FAIL_COND_MSG(
			p_actuation < 0 || p_actuation >= ragdoll::ACTUATION_COUNT, "RagdollControl: there is no such actuation.");
	_actuation = p_actuation;
	emit_changed();
}

void RagdollControl::set_physics_blend(double p_blend) {
	ERR_FAIL_COND_MSG(!(p_blend >= 0.0 && p_blend <= 1.0), "RagdollControl: a physics blend is 0 to 1.");
	change(_physics_blend, p_blend);
}

ragdoll::LimbControl RagdollControl::to_core() const {
	ragdoll::LimbControl control;
	control.mode = ragdoll::Actuation(_actuation);
	control.strength = float(_strength);
	control.parent_angular = { float(_parent_angular_strength), float(_parent_angular_damping_ratio),
		float(_parent_max_torque) };
	control.world_angular = { float(_world_angular_strength), float(_world_angular_damping_ratio),
		float(_world_max_torque) };
	control.world_linear = { float(_world_linear_strength), float(_world_linear_damping_ratio),
		float(_world_max_force) };
	control.physics_blend = float(_physics_blend);
	return control;
}

void RagdollControl::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_limbs", "limbs"), &RagdollControl::set_limbs);
	ClassDB::bind_method(D_METHOD("get_limbs"), &RagdollControl::get_limbs);
	ClassDB::bind_method(D_METHOD("set_actuation", "actuation"), &RagdollControl::set_actuation);
	ClassDB::bind_method(D_METHOD("get_actuation"), &RagdollControl::get_actuation);
	ClassDB::bind_method(D_METHOD("set_strength", "strength"), &RagdollControl::set_strength);
	ClassDB::bind_method(D_METHOD("get_strength"), &RagdollControl::get_strength);
	ClassDB::bind_method(
			D_METHOD("set_parent_angular_strength", "strength"), &RagdollControl::set_parent_angular_strength);
	ClassDB::bind_method(D_METHOD("get_parent_angular_strength"), &RagdollControl::get_parent_angular_strength);
	ClassDB::bind_method(
			D_METHOD("set_parent_angular_damping_ratio", "ratio"), &RagdollControl::set_parent_angular_damping_ratio);
	ClassDB::bind_method(
			D_METHOD("get_parent_angular_damping_ratio"), &RagdollControl::get_parent_angular_damping_ratio);
	ClassDB::bind_method(D_METHOD("set_parent_max_torque", "torque"), &RagdollControl::set_parent_max_torque);
	ClassDB::bind_method(D_METHOD("get_parent_max_torque"), &RagdollControl::get_parent_max_torque);
	ClassDB::bind_method(
			D_METHOD("set_world_angular_strength", "strength"), &RagdollControl::set_world_angular_strength);
	ClassDB::bind_method(D_METHOD("get_world_angular_strength"), &RagdollControl::get_world_angular_strength);
	ClassDB::bind_method(
			D_METHOD("set_world_angular_damping_ratio", "ratio"), &RagdollControl::set_world_angular_damping_ratio);
	ClassDB::bind_method(D_METHOD("get_world_angular_damping_ratio"), &RagdollControl::get_world_angular_damping_ratio);
	ClassDB::bind_method(D_METHOD("set_world_max_torque", "torque"), &RagdollControl::set_world_max_torque);
	ClassDB::bind_method(D_METHOD("get_world_max_torque"), &RagdollControl::get_world_max_torque);
	ClassDB::bind_method(D_METHOD("set_world_linear_strength", "strength"), &RagdollControl::set_world_linear_strength);
	ClassDB::bind_method(D_METHOD("get_world_linear_strength"), &RagdollControl::get_world_linear_strength);
	ClassDB::bind_method(
			D_METHOD("set_world_linear_damping_ratio", "ratio"), &RagdollControl::set_world_linear_damping_ratio);
	ClassDB::bind_method(D_METHOD("get_world_linear_damping_ratio"), &RagdollControl::get_world_linear_damping_ratio);
	ClassDB::bind_method(D_METHOD("set_world_max_force", "force"), &RagdollControl::set_world_max_force);
	ClassDB::bind_method(D_METHOD("get_world_max_force"), &RagdollControl::get_world_max_force);
	ClassDB::bind_method(D_METHOD("set_physics_blend", "blend"), &RagdollControl::set_physics_blend);
	ClassDB::bind_method(D_METHOD("get_physics_blend"), &RagdollControl::get_physics_blend);
	bind_properties();
}

void RagdollControl::bind_properties() {
	ADD_PROPERTY(PropertyInfo(Variant::PACKED_STRING_ARRAY, "limbs"), "set_limbs", "get_limbs");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "physics_blend", PROPERTY_HINT_RANGE, "0,1,0.01"), "set_physics_blend",
			"get_physics_blend");
	ADD_GROUP("Parent Space", "");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "actuation", PROPERTY_HINT_ENUM,
						 "Direct Set,Spring Torque,Angular Motor,Velocity Motor,Position Motor,Limp"),
			"set_actuation", "get_actuation");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "strength", PROPERTY_HINT_RANGE, "0,4,0.01"), "set_strength", "get_strength");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "parent_angular_strength", PROPERTY_HINT_RANGE,
						 "0,30,0.1,or_greater,suffix:Hz"),
			"set_parent_angular_strength", "get_parent_angular_strength");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "parent_angular_damping_ratio", PROPERTY_HINT_RANGE, "0,4,0.01,or_greater"),
			"set_parent_angular_damping_ratio", "get_parent_angular_damping_ratio");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "parent_max_torque", PROPERTY_HINT_RANGE, "0,1000,0.1,or_greater,suffix:Nm"),
			"set_parent_max_torque", "get_parent_max_torque");
	ADD_GROUP("World Space", "");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "world_angular_strength", PROPERTY_HINT_RANGE,
						 "0,30,0.1,or_greater,suffix:Hz"),
			"set_world_angular_strength", "get_world_angular_strength");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "world_angular_damping_ratio", PROPERTY_HINT_RANGE, "0,4,0.01,or_greater"),
			"set_world_angular_damping_ratio", "get_world_angular_damping_ratio");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "world_max_torque", PROPERTY_HINT_RANGE, "0,1000,0.1,or_greater,suffix:Nm"),
			"set_world_max_torque", "get_world_max_torque");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "world_linear_strength", PROPERTY_HINT_RANGE, "0,30,0.1,or_greater,suffix:Hz"),
			"set_world_linear_strength", "get_world_linear_strength");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "world_linear_damping_ratio", PROPERTY_HINT_RANGE, "0,4,0.01,or_greater"),
			"set_world_linear_damping_ratio", "get_world_linear_damping_ratio");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "world_max_force", PROPERTY_HINT_RANGE, "0,10000,1,or_greater,suffix:N"),
			"set_world_max_force", "get_world_max_force");
}

} // namespace godot
