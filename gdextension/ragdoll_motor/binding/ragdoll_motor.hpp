// SPDX-License-Identifier: MIT
#pragma once

#include "ground_rays.hpp"
#include "obstacle_sweep.hpp"
#include "physics_check.hpp"
#include "ragdoll_bodies.hpp"
#include "ragdoll_control_profile.hpp"
#include "ragdoll_plan.hpp"
#include "ragdoll_profile.hpp"
#include <driver.hpp>

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
	bool is_set_up() const { return _driver != nullptr; }
	TypedArray<RID> get_joints() const;

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
	PackedFloat32Array get_body_pose() const { return _body_pose; }
	Dictionary get_tracking() const;
	void clear_tracking();
	PackedFloat32Array get_limb_errors();
	PackedFloat32Array get_limb_torques() const;
	PackedFloat32Array get_limb_saturations() const;
	void set_frame(const Transform3D &p_frame);
	Transform3D get_frame() const;
	Vector3 get_root_target() const;
	Vector3 get_tether() const;
	Dictionary get_balance() const;
	bool is_flying() const;

	// State.
	PackedByteArray save_state();
	bool restore_state(const PackedByteArray &p_bytes);
	int64_t get_state_hash();

	// Properties.
	void set_root_mode(RootMode p_mode);
	RootMode get_root_mode() const { return _root_mode; }
	void set_gain(double p_gain);
	double get_gain() const { return _gain; }
	void set_muscle_speed(double p_speed);
	double get_muscle_speed() const { return _muscle_speed; }
	void set_root_force(double p_force);
	double get_root_force() const { return _root_force; }
	void set_residual_share(double p_share);
	double get_residual_share() const { return _residual_share; }
	void set_standing_torque(double p_torque);
	double get_standing_torque() const { return _standing_torque; }
	void set_root_torque(double p_torque);
	double get_root_torque() const { return _root_torque; }
	void set_inertia_scale(double p_scale);
	double get_inertia_scale() const { return _inertia_scale; }
	void set_arm_inertia_scale(double p_scale);
	double get_arm_inertia_scale() const { return _arm_inertia_scale; }
	void set_self_collision(bool p_enabled) { _self_collision = p_enabled; }
	bool has_self_collision() const { return _self_collision; }
	void set_anatomical_limits(bool p_enabled) { _anatomical_limits = p_enabled; }
	bool has_anatomical_limits() const { return _anatomical_limits; }
	void set_sample_slots(const PackedInt32Array &p_slots);
	PackedInt32Array get_sample_slots() const { return _sample_slots; }
	void set_measures_torque(bool p_enabled);
	bool get_measures_torque() const { return _measures_torque; }
	void set_measures_lag(bool p_enabled);
	bool get_measures_lag() const { return _measures_lag; }
	void set_ground_mask(int64_t p_mask);
	int64_t get_ground_mask() const { return _ground_mask; }
	void set_max_energy(double p_energy);
	double get_max_energy() const { return _max_energy; }

protected:
	static void _bind_methods();

private:
	static void bind_properties();
	static void bind_control();
	static void bind_measurement();
	static void bind_limb_control();

	/// Reads the bodies, unless what was read last is still true.
	bool read_bodies();
	bool is_state_current() const;
	void note_body_pose();
	void resize_body_pose();
	void look_at_ground();
	/// Whether a number can be a force, a gain, a strength: 0 or more, and finite as the core has it.
	static bool is_amount(double p_value) { return p_value >= 0.0 && p_value <= 1e30; }
	bool is_ready() const { return _driver && !_driver->get_stream().is_empty(); }
	void make_driver();
	void apply_settings();
	void report(std::uint32_t p_guarded);

	RootMode _root_mode = ROOT_SOFT;
	double _gain = 50.0;
	double _muscle_speed = 8.0;
	double _root_force = 2000.0;
	double _residual_share = 0.06;
	double _standing_torque = 240.0;
	double _root_torque = 800.0;
	double _inertia_scale = 6.0;
	double _arm_inertia_scale = 2.5;
	double _max_energy = 60.0;
	int64_t _ground_mask = 5; // World and props, not people.
	bool _self_collision = false;
	bool _anatomical_limits = false;
	bool _measures_torque = false;
	bool _measures_lag = false;
	PackedInt32Array _sample_slots;

	TypedArray<RagdollControlProfile> _control_profiles;
	StringName _control_profile; // Applied last.

	RagdollPlan _plan;
	std::unique_ptr<ragdoll::Driver> _driver;
	// After the driver: the bodies refer to its rig.
	std::unique_ptr<RagdollBodies> _bodies;

	GroundRays _ground;
	ObstacleSweep _obstacles;

	// Kept between ticks, so that a tick allocates nothing.
	ragdoll::RigState _state;
	/// When the state was read: number of the physics frame, and whether before its step.
	bool _is_state_read = false;
	bool _is_read_in_step = false;
	uint64_t _read_frame = 0;
	PackedFloat32Array _body_pose;
	std::vector<float> _targets;
	std::vector<ragdoll::Quat> _shown; // Orientations, by the limbs' physics blend.
};

} // namespace godot

VARIANT_ENUM_CAST(RagdollMotor::RootMode);
VARIANT_ENUM_CAST(RagdollMotor::BalancePhase);
VARIANT_ENUM_CAST(RagdollMotor::Actuation);
VARIANT_ENUM_CAST(RagdollMotor::GuardAction);
