// SPDX-License-Identifier: MIT
// RagdollMotor: what scripts and the editor see of it.
#include "ragdoll_motor.hpp"

namespace godot {

void RagdollMotor::set_root_mode(RootMode p_mode) {
	ERR_FAIL_COND_MSG(
			int(p_mode) < 0 || int(p_mode) >= ragdoll::ROOT_MODE_COUNT, "RagdollMotor: there is no such root mode.");
	_root_mode = p_mode;
	apply_settings();
}

void RagdollMotor::set_gain(double p_gain) {
	ERR_FAIL_COND_MSG(!is_amount(p_gain), "RagdollMotor: a gain is 0 or more.");
	_gain = p_gain;
	apply_settings();
}

void RagdollMotor::set_muscle_speed(double p_speed) {
	ERR_FAIL_COND_MSG(!is_amount(p_speed), "RagdollMotor: a muscle speed is 0 or more.");
	_muscle_speed = p_speed;
	apply_settings();
}

void RagdollMotor::set_root_force(double p_force) {
	ERR_FAIL_COND_MSG(!is_amount(p_force), "RagdollMotor: a force is 0 or more.");
	_root_force = p_force;
	apply_settings();
}

void RagdollMotor::set_root_torque(double p_torque) {
	ERR_FAIL_COND_MSG(!is_amount(p_torque), "RagdollMotor: a torque is 0 or more.");
	_root_torque = p_torque;
	apply_settings();
}

void RagdollMotor::set_residual_share(double p_share) {
	ERR_FAIL_COND_MSG(!is_amount(p_share), "RagdollMotor: a share of the weight is 0 or more.");
	_residual_share = p_share;
	apply_settings();
}

void RagdollMotor::set_standing_torque(double p_torque) {
	ERR_FAIL_COND_MSG(!is_amount(p_torque), "RagdollMotor: a torque is 0 or more.");
	_standing_torque = p_torque;
	apply_settings();
}

void RagdollMotor::set_inertia_scale(double p_scale) {
	ERR_FAIL_COND_MSG(!is_amount(p_scale) || p_scale < 0.01, "RagdollMotor: an inertia scale is 0.01 or more.");
	_inertia_scale = p_scale;
}

void RagdollMotor::set_arm_inertia_scale(double p_scale) {
	ERR_FAIL_COND_MSG(!is_amount(p_scale) || p_scale < 0.01, "RagdollMotor: an inertia scale is 0.01 or more.");
	_arm_inertia_scale = p_scale;
}

void RagdollMotor::set_sample_slots(const PackedInt32Array &p_slots) {
	_sample_slots = p_slots;
	resize_body_pose();
}

void RagdollMotor::set_measures_torque(bool p_enabled) {
	_measures_torque = p_enabled;
	apply_settings();
}

void RagdollMotor::set_measures_lag(bool p_enabled) {
	_measures_lag = p_enabled;
	apply_settings();
}

void RagdollMotor::set_ground_mask(int64_t p_mask) {
	_ground_mask = p_mask;
	apply_settings();
}

void RagdollMotor::set_max_energy(double p_energy) {
	ERR_FAIL_COND_MSG(!is_amount(p_energy), "RagdollMotor: an energy is 0 or more.");
	_max_energy = p_energy;
	apply_settings();
}

void RagdollMotor::bind_control() {
	ClassDB::bind_static_method(
			get_class_static(), D_METHOD("find_physics_problem"), &RagdollMotor::find_physics_problem);
	ClassDB::bind_method(D_METHOD("setup", "profile", "bodies", "centres", "space"), &RagdollMotor::setup);
	ClassDB::bind_method(D_METHOD("release"), &RagdollMotor::release);
	ClassDB::bind_method(D_METHOD("is_set_up"), &RagdollMotor::is_set_up);
	ClassDB::bind_method(D_METHOD("get_joints"), &RagdollMotor::get_joints);
	ClassDB::bind_method(D_METHOD("push_sample", "time_s", "rotations", "root", "rates"), &RagdollMotor::push_sample,
			DEFVAL(PackedFloat32Array()));
	ClassDB::bind_method(D_METHOD("clear_motion"), &RagdollMotor::clear_motion);
	ClassDB::bind_method(D_METHOD("snap_to", "time_s"), &RagdollMotor::snap_to);
	ClassDB::bind_method(D_METHOD("drive", "time_s", "delta_s"), &RagdollMotor::drive);
	ClassDB::bind_static_method(
			get_class_static(), D_METHOD("drive_all", "motors", "times_s", "delta_s"), &RagdollMotor::drive_all);
	ClassDB::bind_method(D_METHOD("is_stalled", "time_s"), &RagdollMotor::is_stalled);
	ClassDB::bind_method(D_METHOD("set_actuation", "mode", "group", "blend_s"), &RagdollMotor::set_actuation,
			DEFVAL(StringName()), DEFVAL(0.0));
	ClassDB::bind_method(D_METHOD("get_actuation", "group"), &RagdollMotor::get_actuation, DEFVAL(StringName()));
	ClassDB::bind_method(D_METHOD("set_group_strength", "strength", "group", "blend_s"),
			&RagdollMotor::set_group_strength, DEFVAL(StringName()), DEFVAL(0.0));
	ClassDB::bind_method(
			D_METHOD("get_group_strength", "group"), &RagdollMotor::get_group_strength, DEFVAL(StringName()));
	ClassDB::bind_method(D_METHOD("set_group_spring", "frequency", "damping_ratio", "group"),
			&RagdollMotor::set_group_spring, DEFVAL(StringName()));
}

void RagdollMotor::bind_measurement() {
	ClassDB::bind_method(D_METHOD("measure", "time_s"), &RagdollMotor::measure);
	ClassDB::bind_method(D_METHOD("get_body_pose"), &RagdollMotor::get_body_pose);
	ClassDB::bind_method(D_METHOD("get_tracking"), &RagdollMotor::get_tracking);
	ClassDB::bind_method(D_METHOD("clear_tracking"), &RagdollMotor::clear_tracking);
	ClassDB::bind_method(D_METHOD("get_limb_errors"), &RagdollMotor::get_limb_errors);
	ClassDB::bind_method(D_METHOD("get_limb_torques"), &RagdollMotor::get_limb_torques);
	ClassDB::bind_method(D_METHOD("get_limb_saturations"), &RagdollMotor::get_limb_saturations);
	ClassDB::bind_method(D_METHOD("set_frame", "frame"), &RagdollMotor::set_frame);
	ClassDB::bind_method(D_METHOD("get_frame"), &RagdollMotor::get_frame);
	ClassDB::bind_method(D_METHOD("get_root_target"), &RagdollMotor::get_root_target);
	ClassDB::bind_method(D_METHOD("get_tether"), &RagdollMotor::get_tether);
	ClassDB::bind_method(D_METHOD("get_balance"), &RagdollMotor::get_balance);
	ClassDB::bind_method(D_METHOD("is_flying"), &RagdollMotor::is_flying);
	ClassDB::bind_method(D_METHOD("save_state"), &RagdollMotor::save_state);
	ClassDB::bind_method(D_METHOD("restore_state", "bytes"), &RagdollMotor::restore_state);
	ClassDB::bind_method(D_METHOD("get_state_hash"), &RagdollMotor::get_state_hash);
}

void RagdollMotor::bind_properties() {
	ClassDB::bind_method(D_METHOD("set_root_mode", "mode"), &RagdollMotor::set_root_mode);
	ClassDB::bind_method(D_METHOD("get_root_mode"), &RagdollMotor::get_root_mode);
	ClassDB::bind_method(D_METHOD("set_gain", "gain"), &RagdollMotor::set_gain);
	ClassDB::bind_method(D_METHOD("get_gain"), &RagdollMotor::get_gain);
	ClassDB::bind_method(D_METHOD("set_muscle_speed", "speed"), &RagdollMotor::set_muscle_speed);
	ClassDB::bind_method(D_METHOD("get_muscle_speed"), &RagdollMotor::get_muscle_speed);
	ClassDB::bind_method(D_METHOD("set_root_force", "force"), &RagdollMotor::set_root_force);
	ClassDB::bind_method(D_METHOD("get_root_force"), &RagdollMotor::get_root_force);
	ClassDB::bind_method(D_METHOD("set_root_torque", "torque"), &RagdollMotor::set_root_torque);
	ClassDB::bind_method(D_METHOD("get_root_torque"), &RagdollMotor::get_root_torque);
	ClassDB::bind_method(D_METHOD("set_residual_share", "share"), &RagdollMotor::set_residual_share);
	ClassDB::bind_method(D_METHOD("get_residual_share"), &RagdollMotor::get_residual_share);
	ClassDB::bind_method(D_METHOD("set_standing_torque", "torque"), &RagdollMotor::set_standing_torque);
	ClassDB::bind_method(D_METHOD("get_standing_torque"), &RagdollMotor::get_standing_torque);
	ClassDB::bind_method(D_METHOD("set_inertia_scale", "scale"), &RagdollMotor::set_inertia_scale);
	ClassDB::bind_method(D_METHOD("get_inertia_scale"), &RagdollMotor::get_inertia_scale);
	ClassDB::bind_method(D_METHOD("set_arm_inertia_scale", "scale"), &RagdollMotor::set_arm_inertia_scale);
	ClassDB::bind_method(D_METHOD("get_arm_inertia_scale"), &RagdollMotor::get_arm_inertia_scale);
	ClassDB::bind_method(D_METHOD("set_self_collision", "enabled"), &RagdollMotor::set_self_collision);
	ClassDB::bind_method(D_METHOD("has_self_collision"), &RagdollMotor::has_self_collision);
	ClassDB::bind_method(D_METHOD("set_anatomical_limits", "enabled"), &RagdollMotor::set_anatomical_limits);
	ClassDB::bind_method(D_METHOD("has_anatomical_limits"), &RagdollMotor::has_anatomical_limits);
	ClassDB::bind_method(D_METHOD("set_sample_slots", "slots"), &RagdollMotor::set_sample_slots);
	ClassDB::bind_method(D_METHOD("get_sample_slots"), &RagdollMotor::get_sample_slots);
	ClassDB::bind_method(D_METHOD("set_measures_torque", "enabled"), &RagdollMotor::set_measures_torque);
	ClassDB::bind_method(D_METHOD("get_measures_torque"), &RagdollMotor::get_measures_torque);
	ClassDB::bind_method(D_METHOD("set_measures_lag", "enabled"), &RagdollMotor::set_measures_lag);
	ClassDB::bind_method(D_METHOD("get_measures_lag"), &RagdollMotor::get_measures_lag);
	ClassDB::bind_method(D_METHOD("set_ground_mask", "mask"), &RagdollMotor::set_ground_mask);
	ClassDB::bind_method(D_METHOD("get_ground_mask"), &RagdollMotor::get_ground_mask);
	ClassDB::bind_method(D_METHOD("set_max_energy", "energy"), &RagdollMotor::set_max_energy);
	ClassDB::bind_method(D_METHOD("get_max_energy"), &RagdollMotor::get_max_energy);
}

void RagdollMotor::_bind_methods() {
	bind_control();
	bind_measurement();
	bind_properties();
	bind_limb_control();
	ADD_PROPERTY(PropertyInfo(Variant::INT, "root_mode", PROPERTY_HINT_ENUM,
						 "Held,Soft,Lowest Foot,Contacts,Pendulum,Self Righting,Inertial,Grounded"),
			"set_root_mode", "get_root_mode");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "gain", PROPERTY_HINT_RANGE, "0,240,0.1,suffix:1/s"), "set_gain", "get_gain");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "muscle_speed", PROPERTY_HINT_RANGE, "0,60,0.1,suffix:rad/s"),
			"set_muscle_speed", "get_muscle_speed");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "root_force", PROPERTY_HINT_RANGE, "0,10000,10,suffix:N"),
			"set_root_force", "get_root_force");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "root_torque", PROPERTY_HINT_RANGE, "0,5000,10,suffix:Nm"),
			"set_root_torque", "get_root_torque");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "residual_share", PROPERTY_HINT_RANGE, "0,1,0.01"), "set_residual_share",
			"get_residual_share");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "standing_torque", PROPERTY_HINT_RANGE, "0,5000,10,suffix:Nm"),
			"set_standing_torque", "get_standing_torque");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "ground_mask", PROPERTY_HINT_LAYERS_3D_PHYSICS), "set_ground_mask",
			"get_ground_mask");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "max_energy", PROPERTY_HINT_RANGE, "1,1000,1,suffix:J/kg"),
			"set_max_energy", "get_max_energy");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "inertia_scale", PROPERTY_HINT_RANGE, "1,10,0.1"), "set_inertia_scale",
			"get_inertia_scale");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "arm_inertia_scale", PROPERTY_HINT_RANGE, "1,10,0.1"),
			"set_arm_inertia_scale", "get_arm_inertia_scale");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "self_collision"), "set_self_collision", "has_self_collision");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "anatomical_limits"), "set_anatomical_limits", "has_anatomical_limits");
	ADD_PROPERTY(PropertyInfo(Variant::PACKED_INT32_ARRAY, "sample_slots"), "set_sample_slots", "get_sample_slots");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "measures_torque"), "set_measures_torque", "get_measures_torque");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "measures_lag"), "set_measures_lag", "get_measures_lag");
	ADD_SIGNAL(MethodInfo("guard_acted", PropertyInfo(Variant::INT, "actions")));
	BIND_ENUM_CONSTANT(ROOT_HELD);
	BIND_ENUM_CONSTANT(ROOT_SOFT);
	BIND_ENUM_CONSTANT(ROOT_LOWEST_FOOT);
	BIND_ENUM_CONSTANT(ROOT_CONTACTS);
	BIND_ENUM_CONSTANT(ROOT_PENDULUM);
	BIND_ENUM_CONSTANT(ROOT_SELF_RIGHTING);
	BIND_ENUM_CONSTANT(ROOT_INERTIAL);
	BIND_ENUM_CONSTANT(ROOT_GROUNDED);
	BIND_ENUM_CONSTANT(BALANCE_STANDING);
	BIND_ENUM_CONSTANT(BALANCE_FALLING);
	BIND_ENUM_CONSTANT(BALANCE_TUCKING);
	BIND_ENUM_CONSTANT(BALANCE_ROLLING);
	BIND_ENUM_CONSTANT(BALANCE_RISING);
	BIND_ENUM_CONSTANT(DIRECT_SET);
	BIND_ENUM_CONSTANT(SPRING_TORQUE);
	BIND_ENUM_CONSTANT(ANGULAR_MOTOR);
	BIND_ENUM_CONSTANT(VELOCITY_MOTOR);
	BIND_ENUM_CONSTANT(POSITION_MOTOR);
	BIND_ENUM_CONSTANT(LIMP);
	BIND_ENUM_CONSTANT(GUARD_ENERGY);
	BIND_ENUM_CONSTANT(GUARD_SPEED);
	BIND_ENUM_CONSTANT(GUARD_GAP);
	BIND_ENUM_CONSTANT(GUARD_LOST);
}

} // namespace godot
