// SPDX-License-Identifier: MIT
#include "ragdoll_motor.hpp"

#include "limb_settings.hpp"

#include <convert.hpp>

#include <cmath>

namespace godot {

namespace {

constexpr double MIN_STEP = 1e-5;
constexpr double MAX_STEP = 1.0;

bool is_amount(double p_value) {
	return LimbSettings::is_amount(p_value);
}

} // namespace

PackedStringArray RagdollMotor::_get_configuration_warnings() const {
	PackedStringArray warnings;
	const String problem = find_physics_problem();
	if (!problem.is_empty()) {
		warnings.push_back(problem);
	}
	return warnings;
}

bool RagdollMotor::setup(const Ref<RagdollProfile> &p_profile, const TypedArray<RID> &p_bodies,
		const PackedVector3Array &p_centres, const RID &p_space) {
	const String fault = RagdollPlan::find_fault(p_profile, p_bodies, p_centres, p_space);
	ERR_FAIL_COND_V_MSG(!fault.is_empty(), false, "RagdollMotor: " + fault + ".");
	const String problem = find_physics_problem();
	static bool is_reported = false;
	if (!problem.is_empty() && !is_reported) {
		is_reported = true; // Once is enough: it is the project's.
		WARN_PRINT(problem);
	}
	release();
	_control_profile = StringName();
	_ragdoll = std::make_unique<DrivenRagdoll>(
			this, RagdollPlan(p_profile, p_bodies, p_centres, _settings.anatomical_limits), _settings, p_space);
	_slots.set_limbs(_ragdoll->get_plan().get_reset_pose());
	_shown.reserve(_ragdoll->get_plan().get_bones().size());
	return true;
}

void RagdollMotor::release() {
	if (_ragdoll) {
		_ragdoll->leave_ground();
		_ragdoll.reset();
	}
}

bool RagdollMotor::push_sample(double p_time_s, const PackedFloat32Array &p_rotations, const Vector3 &p_root,
		const PackedFloat32Array &p_rates) {
	const float *targets = _ragdoll ? _slots.find_targets(p_rotations, p_rates) : nullptr;
	return targets != nullptr &&
			_ragdoll->get_driver().push(
					p_time_s, targets, to_core(p_root), p_rates.is_empty() ? nullptr : p_rates.ptr());
}

void RagdollMotor::clear_motion() {
	if (_ragdoll) {
		_ragdoll->get_driver().clear_motion();
	}
}

bool RagdollMotor::snap_to(double p_time_s) {
	ERR_FAIL_COND_V_MSG(!std::isfinite(p_time_s), false, "RagdollMotor: the time is not finite.");
	if (!is_ready()) {
		return false;
	}
	_ragdoll->snap_to(p_time_s);
	return true;
}

bool RagdollMotor::drive(double p_time_s, double p_delta_s) {
	// Written so that NaN fails too; a step that is next to nothing would divide by zero.
	ERR_FAIL_COND_V_MSG(!(p_delta_s >= MIN_STEP && p_delta_s <= MAX_STEP), false,
			"RagdollMotor: the time step must be above zero (0.00001 s or more) and 1 s at most.");
	ERR_FAIL_COND_V_MSG(!std::isfinite(p_time_s), false, "RagdollMotor: the time is not finite.");
	std::uint32_t guarded = ragdoll::GUARD_NOTHING;
	if (!is_ready() || !_ragdoll->drive(p_time_s, float(p_delta_s), guarded)) {
		return false;
	}
	if (guarded != ragdoll::GUARD_NOTHING) {
		// Last of all: whoever listens may release or free this node.
		emit_signal("guard_acted", int64_t(guarded));
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

bool RagdollMotor::is_stalled(double p_time_s) const {
	return !_ragdoll || _ragdoll->get_driver().get_stream().is_stalled(p_time_s);
}

void RagdollMotor::set_actuation(Actuation p_mode, const StringName &p_group, double p_blend_s) {
	ERR_FAIL_COND_MSG(!_ragdoll, "RagdollMotor: set_actuation() comes after setup().");
	LimbSettings(*_ragdoll).set_actuation(int(p_mode), p_group, p_blend_s);
}

RagdollMotor::Actuation RagdollMotor::get_actuation(const StringName &p_group) const {
	return _ragdoll ? Actuation(LimbSettings(*_ragdoll).get_actuation(p_group)) : VELOCITY_MOTOR;
}

void RagdollMotor::set_group_strength(double p_strength, const StringName &p_group, double p_blend_s) {
	ERR_FAIL_COND_MSG(!_ragdoll, "RagdollMotor: set_group_strength() comes after setup().");
	LimbSettings(*_ragdoll).set_strength(p_strength, p_group, p_blend_s);
}

double RagdollMotor::get_group_strength(const StringName &p_group) const {
	return _ragdoll ? LimbSettings(*_ragdoll).get_strength(p_group) : 0.0;
}

void RagdollMotor::set_group_spring(double p_frequency, double p_damping_ratio, const StringName &p_group) {
	ERR_FAIL_COND_MSG(!_ragdoll, "RagdollMotor: set_group_spring() comes after setup().");
	LimbSettings(*_ragdoll).set_spring(p_frequency, p_damping_ratio, p_group);
}

bool RagdollMotor::set_limb_control(const Ref<RagdollControl> &p_control, double p_blend_s) {
	ERR_FAIL_COND_V_MSG(!_ragdoll, false, "RagdollMotor: set_limb_control() comes after setup().");
	return LimbSettings(*_ragdoll).set_control(p_control, p_blend_s);
}

bool RagdollMotor::apply_control_profile(const Ref<RagdollControlProfile> &p_profile, double p_blend_s) {
	ERR_FAIL_COND_V_MSG(!_ragdoll, false, "RagdollMotor: apply_control_profile() comes after setup().");
	if (!LimbSettings(*_ragdoll).apply_profile(p_profile, p_blend_s)) {
		return false;
	}
	_control_profile = p_profile->get_profile_name();
	return true;
}

bool RagdollMotor::invoke_control_profile(const StringName &p_name, double p_blend_s) {
	for (int64_t i = 0; i < _control_profiles.size(); i++) {
		const Ref<RagdollControlProfile> profile = _control_profiles[i];
		if (profile.is_valid() && profile->get_profile_name() == p_name) {
			return apply_control_profile(profile, p_blend_s);
		}
	}
	ERR_FAIL_V_MSG(false, "RagdollMotor: control_profiles has none of the name " + String(p_name) + ".");
}

int64_t RagdollMotor::hit(const Vector3 &p_impulse, const Vector3 &p_position, double p_strength, double p_blend_s,
		const StringName &p_group) {
	int group = -1;
	ERR_FAIL_COND_V_MSG(!_ragdoll, -1, "RagdollMotor: hit() comes after setup().");
	ERR_FAIL_COND_V_MSG(!p_impulse.is_finite() || !p_position.is_finite(), -1,
			"RagdollMotor: the impulse and the position of a hit are finite.");
	ERR_FAIL_COND_V_MSG(!(p_strength >= 0.0 && p_strength <= 1.0), -1, "RagdollMotor: what a hit leaves is 0 to 1.");
	ERR_FAIL_COND_V_MSG(!is_amount(p_blend_s), -1, "RagdollMotor: a blend takes 0 s or more.");
	ERR_FAIL_COND_V_MSG(!_ragdoll->get_plan().find_group(p_group, group), -1,
			"RagdollMotor: the profile has no group " + String(p_group) + ".");
	return _ragdoll->hit(p_impulse, p_position, float(p_strength), float(p_blend_s), group);
}

void RagdollMotor::measure(double p_time_s) {
	if (is_ready() && _ragdoll->read_if_old()) {
		_ragdoll->get_driver().measure(p_time_s, _ragdoll->get_state());
		ragdoll::Vec3 centre;
		_ragdoll->get_driver().blend_shown(_ragdoll->get_state(), _shown, centre);
		_slots.note_pose(_shown, centre);
	}
}

void RagdollMotor::clear_tracking() {
	if (_ragdoll) {
		_ragdoll->get_driver().clear_measures();
	}
}

PackedFloat32Array RagdollMotor::get_limb_errors() {
	return _ragdoll ? to_packed(_ragdoll->get_driver().find_errors(_ragdoll->get_state())) : PackedFloat32Array();
}

PackedFloat32Array RagdollMotor::get_limb_clearances() const {
	return _ragdoll ? to_packed(_ragdoll->get_driver().get_clearance().find_turns()) : PackedFloat32Array();
}

void RagdollMotor::set_frame(const Transform3D &p_frame) {
	ERR_FAIL_COND_MSG(!_ragdoll, "RagdollMotor: call setup() first.");
	ERR_FAIL_COND_MSG(!p_frame.is_finite(), "RagdollMotor: a frame is finite.");
	_ragdoll->get_driver().set_frame(to_core(p_frame.basis), to_core(p_frame.origin));
}

bool RagdollMotor::restore_state(const PackedByteArray &p_bytes) {
	ERR_FAIL_COND_V_MSG(!_ragdoll, false, "RagdollMotor: restore_state() comes after setup().");
	const bool is_restored = restore_ragdoll(p_bytes, *_ragdoll);
	if (is_restored) {
		_settings.root_mode = _ragdoll->get_driver().root_mode;
	}
	return is_restored;
}

void RagdollMotor::apply_settings() {
	if (_ragdoll) {
		_ragdoll->apply(_settings);
	}
}

void RagdollMotor::change_scale(double &r_setting, double p_value) {
	ERR_FAIL_COND_MSG(!is_amount(p_value) || p_value < 0.01, "RagdollMotor: an inertia scale is 0.01 or more.");
	r_setting = p_value;
}

void RagdollMotor::change_amount(double &r_setting, double p_value, const char *p_what) {
	ERR_FAIL_COND_MSG(!is_amount(p_value), "RagdollMotor: " + String(p_what) + " is 0 or more.");
	change(r_setting, p_value);
}

void RagdollMotor::set_root_mode(RootMode p_mode) {
	ERR_FAIL_COND_MSG(
			int(p_mode) < 0 || int(p_mode) >= ragdoll::ROOT_MODE_COUNT, "RagdollMotor: there is no such root mode.");
	change(_settings.root_mode, ragdoll::RootMode(p_mode));
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
	ClassDB::bind_method(D_METHOD("get_limb_clearances"), &RagdollMotor::get_limb_clearances);
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
	ClassDB::bind_method(D_METHOD("set_leg_push", "push"), &RagdollMotor::set_leg_push);
	ClassDB::bind_method(D_METHOD("get_leg_push"), &RagdollMotor::get_leg_push);
	ClassDB::bind_method(D_METHOD("set_inertia_scale", "scale"), &RagdollMotor::set_inertia_scale);
	ClassDB::bind_method(D_METHOD("get_inertia_scale"), &RagdollMotor::get_inertia_scale);
	ClassDB::bind_method(D_METHOD("set_arm_inertia_scale", "scale"), &RagdollMotor::set_arm_inertia_scale);
	ClassDB::bind_method(D_METHOD("get_arm_inertia_scale"), &RagdollMotor::get_arm_inertia_scale);
	ClassDB::bind_method(D_METHOD("set_self_overlap", "overlap"), &RagdollMotor::set_self_overlap);
	ClassDB::bind_method(D_METHOD("get_self_overlap"), &RagdollMotor::get_self_overlap);
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

void RagdollMotor::bind_limb_control() {
	ClassDB::bind_method(D_METHOD("hit", "impulse", "position", "strength", "blend_s", "group"), &RagdollMotor::hit,
			DEFVAL(0.05), DEFVAL(0.5), DEFVAL(StringName()));
	ClassDB::bind_method(
			D_METHOD("set_limb_control", "control", "blend_s"), &RagdollMotor::set_limb_control, DEFVAL(0.0));
	ClassDB::bind_method(D_METHOD("apply_control_profile", "profile", "blend_s"), &RagdollMotor::apply_control_profile,
			DEFVAL(-1.0));
	ClassDB::bind_method(
			D_METHOD("invoke_control_profile", "name", "blend_s"), &RagdollMotor::invoke_control_profile, DEFVAL(-1.0));
	ClassDB::bind_method(D_METHOD("get_control_profile"), &RagdollMotor::get_control_profile);
	ClassDB::bind_method(D_METHOD("set_control_profiles", "profiles"), &RagdollMotor::set_control_profiles);
	ClassDB::bind_method(D_METHOD("get_control_profiles"), &RagdollMotor::get_control_profiles);
	// 24 is an object, 17 a resource type: how the engine writes the elements of an array.
	ADD_PROPERTY(
			PropertyInfo(Variant::ARRAY, "control_profiles", PROPERTY_HINT_ARRAY_TYPE, "24/17:RagdollControlProfile"),
			"set_control_profiles", "get_control_profiles");
}

void RagdollMotor::bind_constants() {
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
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "leg_push", PROPERTY_HINT_RANGE, "0,0.2,0.001,suffix:m"), "set_leg_push",
			"get_leg_push");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "ground_mask", PROPERTY_HINT_LAYERS_3D_PHYSICS), "set_ground_mask",
			"get_ground_mask");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "max_energy", PROPERTY_HINT_RANGE, "1,1000,1,suffix:J/kg"),
			"set_max_energy", "get_max_energy");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "inertia_scale", PROPERTY_HINT_RANGE, "1,10,0.1"), "set_inertia_scale",
			"get_inertia_scale");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "arm_inertia_scale", PROPERTY_HINT_RANGE, "1,10,0.1"),
			"set_arm_inertia_scale", "get_arm_inertia_scale");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "self_overlap", PROPERTY_HINT_RANGE, "0,1,0.001,suffix:m"),
			"set_self_overlap", "get_self_overlap");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "self_collision"), "set_self_collision", "has_self_collision");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "anatomical_limits"), "set_anatomical_limits", "has_anatomical_limits");
	ADD_PROPERTY(PropertyInfo(Variant::PACKED_INT32_ARRAY, "sample_slots"), "set_sample_slots", "get_sample_slots");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "measures_torque"), "set_measures_torque", "get_measures_torque");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "measures_lag"), "set_measures_lag", "get_measures_lag");
	ADD_SIGNAL(MethodInfo("guard_acted", PropertyInfo(Variant::INT, "actions")));
	bind_constants();
}

} // namespace godot
