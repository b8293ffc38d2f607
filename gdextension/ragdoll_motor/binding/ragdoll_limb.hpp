// SPDX-License-Identifier: MIT
#pragma once

#include <body/limb.hpp>

#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

namespace godot {

/// One limb of a RagdollProfile. Documented in doc_classes/RagdollLimb.xml.
class RagdollLimb : public Resource {
	GDCLASS(RagdollLimb, Resource)

public:
	enum Type : int {
		PILL = ragdoll::Limb::PILL,
		BOX = ragdoll::Limb::BOX,
	};

	void set_bone(const StringName &p_bone);
	StringName get_bone() const { return _bone; }
	void set_parent_bone(const StringName &p_bone);
	StringName get_parent_bone() const { return _parent_bone; }
	void set_group(const StringName &p_group);
	StringName get_group() const { return _group; }
	void set_type(Type p_type);
	Type get_type() const { return _type; }
	void set_position(const Vector3 &p_position);
	Vector3 get_position() const { return _position; }
	void set_orientation(const Quaternion &p_orientation);
	Quaternion get_orientation() const { return _orientation; }
	void set_radius(double p_radius);
	double get_radius() const { return _radius; }
	void set_length(double p_length);
	double get_length() const { return _length; }
	void set_size(const Vector3 &p_size);
	Vector3 get_size() const { return _size; }
	void set_anchor(const Vector3 &p_anchor);
	Vector3 get_anchor() const { return _anchor; }
	void set_rest_orientation(const Quaternion &p_orientation);
	Quaternion get_rest_orientation() const { return _rest_orientation; }
	void set_reset_orientation(const Quaternion &p_orientation);
	Quaternion get_reset_orientation() const { return _reset_orientation; }
	void set_mass_fraction(double p_fraction);
	double get_mass_fraction() const { return _mass_fraction; }
	void set_max_torque(double p_torque);
	double get_max_torque() const { return _max_torque; }
	void set_contact_points(const PackedVector3Array &p_points);
	PackedVector3Array get_contact_points() const { return _contact_points; }
	void set_contact_radius(double p_radius);
	double get_contact_radius() const { return _contact_radius; }
	void set_is_foot(bool p_is_foot);
	bool get_is_foot() const { return _is_foot; }
	void set_min_angles(const Vector3 &p_angles);
	Vector3 get_min_angles() const { return _min_angles; }
	void set_max_angles(const Vector3 &p_angles);
	Vector3 get_max_angles() const { return _max_angles; }

	Vector3 get_inertia(double p_mass) const;
	Vector3 get_body_inertia(double p_mass) const;
	Quaternion get_joint_axes() const;
	String find_fault() const;

	/// The limb without the engine's types.
	ragdoll::Limb to_core() const;

protected:
	static void _bind_methods();

private:
	static void bind_properties();
	static constexpr double HALF_CIRCLE = 3.14159265358979;

	template <class T>
	void change(T &r_member, const T &p_value);

	StringName _bone;
	StringName _parent_bone;
	StringName _group;
	Type _type = PILL;
	Vector3 _position;
	Quaternion _orientation;
	double _radius = 0.05;
	double _length = 0.1;
	Vector3 _size = Vector3(0.1, 0.1, 0.1);
	Vector3 _anchor;
	Quaternion _rest_orientation;
	Quaternion _reset_orientation;
	double _mass_fraction = 0.0;
	double _max_torque = 100.0;
	PackedVector3Array _contact_points;
	double _contact_radius = 0.0;
	bool _is_foot = false;
	Vector3 _min_angles = Vector3(-HALF_CIRCLE, -HALF_CIRCLE, -HALF_CIRCLE);
	Vector3 _max_angles = Vector3(HALF_CIRCLE, HALF_CIRCLE, HALF_CIRCLE);
};

} // namespace godot

VARIANT_ENUM_CAST(RagdollLimb::Type);
