// SPDX-License-Identifier: MIT
#pragma once

#include <control/limb_control.hpp>

#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>

namespace godot {

/// How some limbs of a ragdoll are controlled. Documented in doc_classes/RagdollControl.xml.
class RagdollControl : public Resource {
	GDCLASS(RagdollControl, Resource)

public:
	void set_limbs(const PackedStringArray &p_limbs);
	PackedStringArray get_limbs() const { return _limbs; }
	void set_actuation(int64_t p_actuation);
	int64_t get_actuation() const { return _actuation; }
	void set_strength(double p_value) { change(_strength, p_value); }
	double get_strength() const { return _strength; }
	void set_parent_angular_strength(double p_value) { change(_parent_angular_strength, p_value); }
	double get_parent_angular_strength() const { return _parent_angular_strength; }
	void set_parent_angular_damping_ratio(double p_value) { change(_parent_angular_damping_ratio, p_value); }
	double get_parent_angular_damping_ratio() const { return _parent_angular_damping_ratio; }
	void set_parent_max_torque(double p_value) { change(_parent_max_torque, p_value); }
	double get_parent_max_torque() const { return _parent_max_torque; }
	void set_world_angular_strength(double p_value) { change(_world_angular_strength, p_value); }
	double get_world_angular_strength() const { return _world_angular_strength; }
	void set_world_angular_damping_ratio(double p_value) { change(_world_angular_damping_ratio, p_value); }
	double get_world_angular_damping_ratio() const { return _world_angular_damping_ratio; }
	void set_world_max_torque(double p_value) { change(_world_max_torque, p_value); }
	double get_world_max_torque() const { return _world_max_torque; }
	void set_world_linear_strength(double p_value) { change(_world_linear_strength, p_value); }
	double get_world_linear_strength() const { return _world_linear_strength; }
	void set_world_linear_damping_ratio(double p_value) { change(_world_linear_damping_ratio, p_value); }
	double get_world_linear_damping_ratio() const { return _world_linear_damping_ratio; }
	void set_world_max_force(double p_value) { change(_world_max_force, p_value); }
	double get_world_max_force() const { return _world_max_force; }
	void set_physics_blend(double p_blend);
	double get_physics_blend() const { return _physics_blend; }

	/// The same without the engine's types.
	ragdoll::LimbControl to_core() const;

protected:
	static void _bind_methods();

private:
	static void bind_properties();
	void change(double &r_member, double p_value);

	PackedStringArray _limbs;
	int64_t _actuation = int64_t(ragdoll::Actuation::VELOCITY_MOTOR);
	double _strength = 1.0;
	double _parent_angular_strength = 0.0;
	double _parent_angular_damping_ratio = 1.0;
	double _parent_max_torque = 0.0;
	double _world_angular_strength = 0.0;
	double _world_angular_damping_ratio = 1.0;
	double _world_max_torque = 0.0;
	double _world_linear_strength = 0.0;
	double _world_linear_damping_ratio = 1.0;
	double _world_max_force = 0.0;
	double _physics_blend = 1.0;
};

} // namespace godot
