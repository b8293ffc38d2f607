// SPDX-License-Identifier: MIT
#pragma once

#include "driven_ragdoll.hpp"
#include "motor_settings.hpp"
#include "physics_check.hpp"
#include "ragdoll_control_profile.hpp"
#include "ragdoll_profile.hpp"
#include "ragdoll_report.hpp"
#include "sample_slots.hpp"
#include "saved_ragdoll.hpp"

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_float64_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <memory>
#include <vector>

namespace godot {

/// Makes the bodies of a ragdoll follow live motion. Documented in doc_classes/RagdollMotor.xml.
class RagdollMotor : public Node {
	GDCLASS(RagdollMotor, Node)

public:
	enum RootMode {
		ROOT_HELD,
		ROOT_SOFT,
		ROOT_LOWEST_FOOT,
		ROOT_CONTACTS,
		ROOT_PENDULUM,
		ROOT_SELF_RIGHTING,
		ROOT_INERTIAL,
		ROOT_GROUNDED,
	};

	/// What a GROUNDED body is doing about its balance.
	enum BalancePhase {
		BALANCE_STANDING,
		BALANCE_FALLING,
		BALANCE_TUCKING,
		BALANCE_ROLLING,
		BALANCE_RISING,
	};
	enum Actuation {
		DIRECT_SET,
		SPRING_TORQUE,
		ANGULAR_MOTOR,
		VELOCITY_MOTOR,
		POSITION_MOTOR,
		LIMP,
	};

	/// What the guard against explosions had to do; flags.
	enum GuardAction {
		GUARD_ENERGY = 1,
		GUARD_SPEED = 2,
		GUARD_GAP = 4,
		GUARD_LOST = 8,
	};

	static String find_physics_problem() { return godot::find_physics_problem(); }
	PackedStringArray _get_configuration_warnings() const override;

	// What it is made of.
	bool setup(const Ref<RagdollProfile> &p_profile, const TypedArray<RID> &p_bodies,
			const PackedVector3Array &p_centres, const RID &p_space);
	void release();
	bool is_set_up() const { return _ragdoll != nullptr; }
	TypedArray<RID> get_joints() const { return _ragdoll ? _ragdoll->get_joints() : TypedArray<RID>(); }

	// Motion.
	bool push_sample(double p_time_s, const PackedFloat32Array &p_rotations, const Vector3 &p_root,
			const PackedFloat32Array &p_rates);
	void clear_motion();
	bool snap_to(double p_time_s);
	bool drive(double p_time_s, double p_delta_s);
	static int64_t drive_all(
			const TypedArray<RagdollMotor> &p_motors, const PackedFloat64Array &p_times_s, double p_delta_s);
	bool is_stalled(double p_time_s) const;

	// Modes.
	void set_actuation(Actuation p_mode, const StringName &p_group, double p_blend_s);
	Actuation get_actuation(const StringName &p_group) const;
	void set_group_strength(double p_strength, const StringName &p_group, double p_blend_s);
	double get_group_strength(const StringName &p_group) const;
	void set_group_spring(double p_frequency, double p_damping_ratio, const StringName &p_group);

	// Controls and hits.
	int64_t hit(const Vector3 &p_impulse, const Vector3 &p_position, double p_strength, double p_blend_s,
			const StringName &p_group);
	bool set_limb_control(const Ref<RagdollControl> &p_control, double p_blend_s);
	bool apply_control_profile(const Ref<RagdollControlProfile> &p_profile, double p_blend_s);
	bool invoke_control_profile(const StringName &p_name, double p_blend_s);
	StringName get_control_profile() const { return _control_profile; }
	void set_control_profiles(const TypedArray<RagdollControlProfile> &p_profiles) { _control_profiles = p_profiles; }
	TypedArray<RagdollControlProfile> get_control_profiles() const { return _control_profiles; }

	// Measurement.
	void measure(double p_time_s);
	PackedFloat32Array get_body_pose() const { return _slots.get_pose(); }
	Dictionary get_tracking() const { return report().get_tracking(); }
	void clear_tracking();
	PackedFloat32Array get_limb_errors();
	PackedFloat32Array get_limb_clearances() const;
	PackedFloat32Array get_limb_torques() const { return report().get_limb_torques(); }
	PackedFloat32Array get_limb_saturations() const { return report().get_limb_saturations(); }
	void set_frame(const Transform3D &p_frame);
	Transform3D get_frame() const { return report().get_frame(); }
	Vector3 get_root_target() const { return report().get_root_target(); }
	Vector3 get_tether() const { return report().get_tether(); }
	Dictionary get_balance() const { return report().get_balance(); }
	bool is_flying() const { return report().is_flying(); }

	// State.
	PackedByteArray save_state() { return _ragdoll ? save_ragdoll(*_ragdoll) : PackedByteArray(); }
	bool restore_state(const PackedByteArray &p_bytes);
	int64_t get_state_hash() { return int64_t(_ragdoll ? hash_ragdoll(*_ragdoll) : ragdoll::StateHash().get()); }

	// Properties.
	void set_root_mode(RootMode p_mode);
	RootMode get_root_mode() const { return RootMode(_settings.root_mode); }
	void set_gain(double p_gain) { change_amount(_settings.gain, p_gain, "a gain"); }
	double get_gain() const { return _settings.gain; }
	void set_muscle_speed(double p_speed) { change_amount(_settings.muscle_speed, p_speed, "a muscle speed"); }
	double get_muscle_speed() const { return _settings.muscle_speed; }
	void set_root_force(double p_force) { change_amount(_settings.root_force, p_force, "a force"); }
	double get_root_force() const { return _settings.root_force; }
	void set_residual_share(double p_share) {
		change_amount(_settings.residual_share, p_share, "a share of the weight");
	}
	double get_residual_share() const { return _settings.residual_share; }
	void set_standing_torque(double p_torque) { change_amount(_settings.standing_torque, p_torque, "a torque"); }
	double get_standing_torque() const { return _settings.standing_torque; }
	void set_leg_push(double p_push) { change_amount(_settings.leg_push, p_push, "a length"); }
	double get_leg_push() const { return _settings.leg_push; }
	void set_root_torque(double p_torque) { change_amount(_settings.root_torque, p_torque, "a torque"); }
	double get_root_torque() const { return _settings.root_torque; }
	void set_inertia_scale(double p_scale) { change_scale(_settings.inertia_scale, p_scale); }
	double get_inertia_scale() const { return _settings.inertia_scale; }
	void set_arm_inertia_scale(double p_scale) { change_scale(_settings.arm_inertia_scale, p_scale); }
	double get_arm_inertia_scale() const { return _settings.arm_inertia_scale; }
	void set_self_overlap(double p_overlap) { change_amount(_settings.self_overlap, p_overlap, "an overlap"); }
	double get_self_overlap() const { return _settings.self_overlap; }
	void set_self_collision(bool p_enabled) { _settings.self_collision = p_enabled; }
	bool has_self_collision() const { return _settings.self_collision; }
	void set_anatomical_limits(bool p_enabled) { _settings.anatomical_limits = p_enabled; }
	bool has_anatomical_limits() const { return _settings.anatomical_limits; }
	void set_sample_slots(const PackedInt32Array &p_slots) { _slots.set_slots(p_slots); }
	PackedInt32Array get_sample_slots() const { return _slots.get_slots(); }
	void set_measures_torque(bool p_enabled) { change(_settings.measures_torque, p_enabled); }
	bool get_measures_torque() const { return _settings.measures_torque; }
	void set_measures_lag(bool p_enabled) { change(_settings.measures_lag, p_enabled); }
	bool get_measures_lag() const { return _settings.measures_lag; }
	void set_ground_mask(int64_t p_mask) { change(_settings.ground_mask, p_mask); }
	int64_t get_ground_mask() const { return _settings.ground_mask; }
	void set_max_energy(double p_energy) { change_amount(_settings.max_energy, p_energy, "an energy"); }
	double get_max_energy() const { return _settings.max_energy; }

protected:
	static void _bind_methods();

private:
	static void bind_constants();
	static void bind_properties();
	static void bind_control();
	static void bind_measurement();
	static void bind_limb_control();

	RagdollReport report() const { return RagdollReport(_ragdoll.get()); }
	bool is_ready() const { return _ragdoll && _ragdoll->has_motion(); }
	/// Sets a property that is an amount, 0 or more.
	void change_amount(double &r_setting, double p_value, const char *p_what);
	/// Sets a property that the next setup() takes.
	void change_scale(double &r_setting, double p_value);
	template <typename T>
	void change(T &r_setting, T p_value) {
		r_setting = p_value;
		apply_settings();
	}
	void apply_settings();

	MotorSettings _settings;
	TypedArray<RagdollControlProfile> _control_profiles;
	StringName _control_profile; // Applied last.
	SampleSlots _slots;
	std::unique_ptr<DrivenRagdoll> _ragdoll; // Null unless it is set up.
	std::vector<ragdoll::Quat> _shown; // By the limbs' physics blend; kept, so that a tick allocates nothing.
};

} // namespace godot

VARIANT_ENUM_CAST(RagdollMotor::RootMode);
VARIANT_ENUM_CAST(RagdollMotor::BalancePhase);
VARIANT_ENUM_CAST(RagdollMotor::Actuation);
VARIANT_ENUM_CAST(RagdollMotor::GuardAction);
