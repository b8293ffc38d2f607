// SPDX-License-Identifier: MIT
#include "ragdoll_limb.hpp"

#include "convert.hpp"

#include <algorithm>
#include <cmath>

namespace godot {

namespace {

bool is_rotation(const Quaternion &p_value) {
	const float square = p_value.x * p_value.x + p_value.y * p_value.y + p_value.z * p_value.z + p_value.w * p_value.w;
	return std::abs(std::sqrt(square) - 1.0f) < 0.01f; // NaN is not below.
}

bool is_place(const Vector3 &p_value) {
	return to_core(p_value).length() < 100.0f;
}

} // namespace

ragdoll::LimbShape RagdollLimb::get_core_shape() const {
	ragdoll::LimbShape shape;
	shape.type = type == BOX ? ragdoll::LimbShape::Type::BOX : ragdoll::LimbShape::Type::PILL;
	shape.radius = float(radius);
	shape.length = float(length);
	shape.size = to_core(size);
	return shape;
}

Vector3 RagdollLimb::get_inertia(double p_mass) const {
	return from_core(get_core_shape().inertia(float(p_mass)));
}

String RagdollLimb::find_fault() const {
	if (bone == StringName()) {
		return "it names no bone";
	}
	const String name(bone);
	if (!is_place(position) || !is_place(anchor)) {
		return name + "'s position or anchor is no place in a figure";
	}
	if (!is_rotation(orientation)) {
		return name + "'s orientation is not a rotation (its norm is not 1)";
	}
	if (!is_rotation(rest_orientation) || !is_rotation(reset_orientation)) {
		return name + "'s rest_orientation or reset_orientation is not a rotation (its norm is not 1)";
	}
	if (!(mass_fraction > 0.0 && mass_fraction <= 1.0)) {
		return name + "'s mass_fraction is " + String::num(mass_fraction) + " instead of above 0 and at most 1";
	}
	if (!(max_torque >= 0.0 && max_torque < 1e6)) {
		return name + "'s max_torque is " + String::num(max_torque) + " instead of 0 or more";
	}
	if (group == StringName()) {
		return name + " is in no strength group";
	}
	if (!(contact_radius >= 0.0 && contact_radius < 2.0)) {
		return name + "'s contact_radius is no size of a limb";
	}
	const int64_t points = contact_points.size();
	for (int64_t i = 0; i < points; i++) {
		if (!is_place(contact_points[i])) {
			return name + " has a contact point that is no place in a figure";
		}
	}
	const bool ordered = min_angles.x <= max_angles.x && min_angles.y <= max_angles.y && min_angles.z <= max_angles.z;
	if (!ordered || !is_place(min_angles) || !is_place(max_angles)) {
		return name + "'s min_angles must not be above its max_angles";
	}
	const std::string fault = get_core_shape().find_fault();
	return fault.empty() ? String() : name + "'s " + String(fault.c_str());
}

void RagdollLimb::bind_frames() {
	ClassDB::bind_method(D_METHOD("set_bone", "bone"), &RagdollLimb::set_bone);
	ClassDB::bind_method(D_METHOD("get_bone"), &RagdollLimb::get_bone);
	ADD_PROPERTY(PropertyInfo(Variant::STRING_NAME, "bone"), "set_bone", "get_bone");
	ClassDB::bind_method(D_METHOD("set_parent_bone", "parent_bone"), &RagdollLimb::set_parent_bone);
	ClassDB::bind_method(D_METHOD("get_parent_bone"), &RagdollLimb::get_parent_bone);
	ADD_PROPERTY(PropertyInfo(Variant::STRING_NAME, "parent_bone"), "set_parent_bone", "get_parent_bone");
	ClassDB::bind_method(D_METHOD("set_group", "group"), &RagdollLimb::set_group);
	ClassDB::bind_method(D_METHOD("get_group"), &RagdollLimb::get_group);
	ADD_PROPERTY(PropertyInfo(Variant::STRING_NAME, "group"), "set_group", "get_group");
	ClassDB::bind_method(D_METHOD("set_type", "type"), &RagdollLimb::set_type);
	ClassDB::bind_method(D_METHOD("get_type"), &RagdollLimb::get_type);
	ADD_PROPERTY(PropertyInfo(Variant::INT, "type", PROPERTY_HINT_ENUM, "Pill,Box"), "set_type", "get_type");
	ClassDB::bind_method(D_METHOD("set_position", "position"), &RagdollLimb::set_position);
	ClassDB::bind_method(D_METHOD("get_position"), &RagdollLimb::get_position);
	ADD_PROPERTY(
			PropertyInfo(Variant::VECTOR3, "position", PROPERTY_HINT_NONE, "suffix:m"), "set_position", "get_position");
	ClassDB::bind_method(D_METHOD("set_orientation", "orientation"), &RagdollLimb::set_orientation);
	ClassDB::bind_method(D_METHOD("get_orientation"), &RagdollLimb::get_orientation);
	ADD_PROPERTY(PropertyInfo(Variant::QUATERNION, "orientation"), "set_orientation", "get_orientation");
	ClassDB::bind_method(D_METHOD("set_radius", "radius"), &RagdollLimb::set_radius);
	ClassDB::bind_method(D_METHOD("get_radius"), &RagdollLimb::get_radius);
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "radius", PROPERTY_HINT_RANGE, "0,1,0.001,suffix:m"), "set_radius",
			"get_radius");
	ClassDB::bind_method(D_METHOD("set_length", "length"), &RagdollLimb::set_length);
	ClassDB::bind_method(D_METHOD("get_length"), &RagdollLimb::get_length);
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "length", PROPERTY_HINT_RANGE, "0,2,0.001,suffix:m"), "set_length",
			"get_length");
	ClassDB::bind_method(D_METHOD("set_size", "size"), &RagdollLimb::set_size);
	ClassDB::bind_method(D_METHOD("get_size"), &RagdollLimb::get_size);
	ADD_PROPERTY(PropertyInfo(Variant::VECTOR3, "size", PROPERTY_HINT_NONE, "suffix:m"), "set_size", "get_size");
	ClassDB::bind_method(D_METHOD("set_anchor", "anchor"), &RagdollLimb::set_anchor);
	ClassDB::bind_method(D_METHOD("get_anchor"), &RagdollLimb::get_anchor);
	ADD_PROPERTY(PropertyInfo(Variant::VECTOR3, "anchor", PROPERTY_HINT_NONE, "suffix:m"), "set_anchor", "get_anchor");
	ClassDB::bind_method(D_METHOD("set_rest_orientation", "rest_orientation"), &RagdollLimb::set_rest_orientation);
	ClassDB::bind_method(D_METHOD("get_rest_orientation"), &RagdollLimb::get_rest_orientation);
	ADD_PROPERTY(PropertyInfo(Variant::QUATERNION, "rest_orientation"), "set_rest_orientation", "get_rest_orientation");
	ClassDB::bind_method(D_METHOD("set_reset_orientation", "reset_orientation"), &RagdollLimb::set_reset_orientation);
	ClassDB::bind_method(D_METHOD("get_reset_orientation"), &RagdollLimb::get_reset_orientation);
	ADD_PROPERTY(
			PropertyInfo(Variant::QUATERNION, "reset_orientation"), "set_reset_orientation", "get_reset_orientation");
}

void RagdollLimb::bind_motor() {
	ClassDB::bind_method(D_METHOD("set_mass_fraction", "mass_fraction"), &RagdollLimb::set_mass_fraction);
	ClassDB::bind_method(D_METHOD("get_mass_fraction"), &RagdollLimb::get_mass_fraction);
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "mass_fraction", PROPERTY_HINT_RANGE, "0,1,0.0001"), "set_mass_fraction",
			"get_mass_fraction");
	ClassDB::bind_method(D_METHOD("set_max_torque", "max_torque"), &RagdollLimb::set_max_torque);
	ClassDB::bind_method(D_METHOD("get_max_torque"), &RagdollLimb::get_max_torque);
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "max_torque", PROPERTY_HINT_RANGE, "0,2000,1,suffix:Nm"),
			"set_max_torque", "get_max_torque");
	ClassDB::bind_method(D_METHOD("set_min_angles", "min_angles"), &RagdollLimb::set_min_angles);
	ClassDB::bind_method(D_METHOD("get_min_angles"), &RagdollLimb::get_min_angles);
	ADD_PROPERTY(PropertyInfo(Variant::VECTOR3, "min_angles", PROPERTY_HINT_NONE, "radians_as_degrees"),
			"set_min_angles", "get_min_angles");
	ClassDB::bind_method(D_METHOD("set_max_angles", "max_angles"), &RagdollLimb::set_max_angles);
	ClassDB::bind_method(D_METHOD("get_max_angles"), &RagdollLimb::get_max_angles);
	ADD_PROPERTY(PropertyInfo(Variant::VECTOR3, "max_angles", PROPERTY_HINT_NONE, "radians_as_degrees"),
			"set_max_angles", "get_max_angles");
	ClassDB::bind_method(D_METHOD("set_contact_points", "contact_points"), &RagdollLimb::set_contact_points);
	ClassDB::bind_method(D_METHOD("get_contact_points"), &RagdollLimb::get_contact_points);
	ADD_PROPERTY(
			PropertyInfo(Variant::PACKED_VECTOR3_ARRAY, "contact_points"), "set_contact_points", "get_contact_points");
	ClassDB::bind_method(D_METHOD("set_contact_radius", "contact_radius"), &RagdollLimb::set_contact_radius);
	ClassDB::bind_method(D_METHOD("get_contact_radius"), &RagdollLimb::get_contact_radius);
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "contact_radius", PROPERTY_HINT_RANGE, "0,1,0.001,suffix:m"),
			"set_contact_radius", "get_contact_radius");
	ClassDB::bind_method(D_METHOD("set_foot", "foot"), &RagdollLimb::set_foot);
	ClassDB::bind_method(D_METHOD("is_foot"), &RagdollLimb::is_foot);
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "foot"), "set_foot", "is_foot");
}

void RagdollLimb::_bind_methods() {
	bind_frames();
	bind_motor();
	ClassDB::bind_method(D_METHOD("get_inertia", "mass"), &RagdollLimb::get_inertia);
	ClassDB::bind_method(D_METHOD("find_fault"), &RagdollLimb::find_fault);
	BIND_ENUM_CONSTANT(PILL);
	BIND_ENUM_CONSTANT(BOX);
}

} // namespace godot
