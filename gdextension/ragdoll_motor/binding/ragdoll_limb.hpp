// SPDX-License-Identifier: MIT
#pragma once

#include "../src/limb_shape.hpp"

#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>

namespace godot {

/// One limb of a RagdollProfile. Documented in doc_classes/RagdollLimb.xml.
class RagdollLimb : public Resource {
	GDCLASS(RagdollLimb, Resource)

public:
	enum Type {
		PILL,
		BOX,
	};

	void set_bone(const StringName &p_bone) { bone = p_bone; }
	StringName get_bone() const { return bone; }
	void set_parent_bone(const StringName &p_parent_bone) { parent_bone = p_parent_bone; }
	StringName get_parent_bone() const { return parent_bone; }
	void set_group(const StringName &p_group) { group = p_group; }
	StringName get_group() const { return group; }
	void set_type(Type p_type) { type = p_type; }
	Type get_type() const { return type; }
	void set_position(const Vector3 &p_position) { position = p_position; }
	Vector3 get_position() const { return position; }
	void set_orientation(const Quaternion &p_orientation) { orientation = p_orientation; }
	Quaternion get_orientation() const { return orientation; }
	void set_radius(double p_radius) { radius = p_radius; }
	double get_radius() const { return radius; }
	void set_length(double p_length) { length = p_length; }
	double get_length() const { return length; }
	void set_size(const Vector3 &p_size) { size = p_size; }
	Vector3 get_size() const { return size; }
	void set_anchor(const Vector3 &p_anchor) { anchor = p_anchor; }
	Vector3 get_anchor() const { return anchor; }
	void set_rest_orientation(const Quaternion &p_rest_orientation) { rest_orientation = p_rest_orientation; }
	Quaternion get_rest_orientation() const { return rest_orientation; }
	void set_reset_orientation(const Quaternion &p_reset_orientation) { reset_orientation = p_reset_orientation; }
	Quaternion get_reset_orientation() const { return reset_orientation; }
	void set_mass_fraction(double p_mass_fraction) { mass_fraction = p_mass_fraction; }
	double get_mass_fraction() const { return mass_fraction; }
	void set_max_torque(double p_max_torque) { max_torque = p_max_torque; }
	double get_max_torque() const { return max_torque; }
	void set_min_angles(const Vector3 &p_min_angles) { min_angles = p_min_angles; }
	Vector3 get_min_angles() const { return min_angles; }
	void set_max_angles(const Vector3 &p_max_angles) { max_angles = p_max_angles; }
	Vector3 get_max_angles() const { return max_angles; }
	void set_contact_points(const PackedVector3Array &p_contact_points) { contact_points = p_contact_points; }
	PackedVector3Array get_contact_points() const { return contact_points; }
	void set_contact_radius(double p_contact_radius) { contact_radius = p_contact_radius; }
	double get_contact_radius() const { return contact_radius; }
	void set_foot(bool p_foot) { foot = p_foot; }
	bool is_foot() const { return foot; }

	/// Moments of inertia about the centre in the shape's own axes, kg m^2, for a mass in kg.
	Vector3 get_inertia(double p_mass) const;
	/// Why this cannot be a limb, or an empty text if it can.
	String find_fault() const;

protected:
	static void _bind_methods();

private:
	static void bind_frames();
	static void bind_motor();
	ragdoll::LimbShape get_core_shape() const;

	StringName bone;
	StringName parent_bone;
	StringName group = StringName("body");
	Type type = PILL;
	Vector3 position;
	Quaternion orientation;
	double radius = 0.05;
	double length = 0.1;
	Vector3 size{ 0.1f, 0.1f, 0.1f };
	Vector3 anchor;
	Quaternion rest_orientation;
	Quaternion reset_orientation;
	double mass_fraction = 0.0;
	double max_torque = 0.0;
	Vector3 min_angles;
	Vector3 max_angles;
	PackedVector3Array contact_points;
	double contact_radius = 0.0;
	bool foot = false;
};

} // namespace godot

VARIANT_ENUM_CAST(RagdollLimb::Type);
