// SPDX-License-Identifier: MIT
#include "ragdoll_limb.hpp"

namespace godot {

namespace {

ragdoll::Vec3 to_core_vector(const Vector3 &p_vector) {
	return { p_vector.x, p_vector.y, p_vector.z };
}

ragdoll::Quat to_core_rotation(const Quaternion &p_rotation) {
	return { p_rotation.x, p_rotation.y, p_rotation.z, p_rotation.w };
}

std::string to_text(const StringName &p_name) {
	return String(p_name).utf8().get_data();
}

} // namespace

template <class T>
void RagdollLimb::change(T &r_member, const T &p_value) {
	r_member = p_value;
	emit_changed();
}

void RagdollLimb::set_bone(const StringName &p_bone) {
	change(_bone, p_bone);
}

void RagdollLimb::set_parent_bone(const StringName &p_bone) {
	change(_parent_bone, p_bone);
}

void RagdollLimb::set_group(const StringName &p_group) {
	change(_group, p_group);
}

void RagdollLimb::set_type(Type p_type) {
	change(_type, p_type);
}

void RagdollLimb::set_position(const Vector3 &p_position) {
	change(_position, p_position);
}

void RagdollLimb::set_orientation(const Quaternion &p_orientation) {
	change(_orientation, p_orientation);
}

void RagdollLimb::set_radius(double p_radius) {
	change(_radius, p_radius);
}

void RagdollLimb::set_length(double p_length) {
	change(_length, p_length);
}

void RagdollLimb::set_size(const Vector3 &p_size) {
	change(_size, p_size);
}

void RagdollLimb::set_anchor(const Vector3 &p_anchor) {
	change(_anchor, p_anchor);
}

void RagdollLimb::set_rest_orientation(const Quaternion &p_orientation) {
	change(_rest_orientation, p_orientation);
}

void RagdollLimb::set_reset_orientation(const Quaternion &p_orientation) {
	change(_reset_orientation, p_orientation);
}

void RagdollLimb::set_mass_fraction(double p_fraction) {
	change(_mass_fraction, p_fraction);
}

void RagdollLimb::set_max_torque(double p_torque) {
	change(_max_torque, p_torque);
}

void RagdollLimb::set_contact_points(const PackedVector3Array &p_points) {
	change(_contact_points, p_points);
}

void RagdollLimb::set_contact_radius(double p_radius) {
	change(_contact_radius, p_radius);
}

void RagdollLimb::set_is_foot(bool p_is_foot) {
	change(_is_foot, p_is_foot);
}

void RagdollLimb::set_min_angles(const Vector3 &p_angles) {
	change(_min_angles, p_angles);
}

void RagdollLimb::set_max_angles(const Vector3 &p_angles) {
	change(_max_angles, p_angles);
}

ragdoll::Limb RagdollLimb::to_core() const {
	ragdoll::Limb limb;
	limb.bone = to_text(_bone);
	limb.parent_bone = to_text(_parent_bone);
	limb.group = to_text(_group);
	limb.type = ragdoll::Limb::Type(_type);
	limb.position = to_core_vector(_position);
	limb.orientation = to_core_rotation(_orientation);
	limb.radius = float(_radius);
	limb.length = float(_length);
	limb.size = to_core_vector(_size);
	limb.anchor = to_core_vector(_anchor);
	limb.rest_orientation = to_core_rotation(_rest_orientation);
	limb.reset_orientation = to_core_rotation(_reset_orientation);
	limb.mass_fraction = float(_mass_fraction);
	limb.max_torque = float(_max_torque);
	for (int64_t i = 0; i < _contact_points.size(); i++) {
		limb.contact_points.push_back(to_core_vector(_contact_points[i]));
	}
	limb.contact_radius = float(_contact_radius);
	limb.min_angles = to_core_vector(_min_angles);
	limb.max_angles = to_core_vector(_max_angles);
	return limb;
}

Vector3 RagdollLimb::get_inertia(double p_mass) const {
	const ragdoll::Vec3 inertia = ragdoll::shape_inertia(to_core(), float(p_mass));
	return Vector3(inertia.x, inertia.y, inertia.z);
}

Vector3 RagdollLimb::get_body_inertia(double p_mass) const {
	const ragdoll::Vec3 inertia = ragdoll::body_inertia(to_core(), float(p_mass));
	return Vector3(inertia.x, inertia.y, inertia.z);
}

Quaternion RagdollLimb::get_joint_axes() const {
	const ragdoll::Quat axes = ragdoll::joint_axes(to_core());
	return Quaternion(axes.x, axes.y, axes.z, axes.w);
}

String RagdollLimb::find_fault() const {
	return String::utf8(ragdoll::find_fault(to_core()).c_str());
}

void RagdollLimb::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_bone", "bone"), &RagdollLimb::set_bone);
	ClassDB::bind_method(D_METHOD("get_bone"), &RagdollLimb::get_bone);
	ClassDB::bind_method(D_METHOD("set_parent_bone", "bone"), &RagdollLimb::set_parent_bone);
	ClassDB::bind_method(D_METHOD("get_parent_bone"), &RagdollLimb::get_parent_bone);
	ClassDB::bind_method(D_METHOD("set_group", "group"), &RagdollLimb::set_group);
	ClassDB::bind_method(D_METHOD("get_group"), &RagdollLimb::get_group);
	ClassDB::bind_method(D_METHOD("set_type", "type"), &RagdollLimb::set_type);
	ClassDB::bind_method(D_METHOD("get_type"), &RagdollLimb::get_type);
	ClassDB::bind_method(D_METHOD("set_position", "position"), &RagdollLimb::set_position);
	ClassDB::bind_method(D_METHOD("get_position"), &RagdollLimb::get_position);
	ClassDB::bind_method(D_METHOD("set_orientation", "orientation"), &RagdollLimb::set_orientation);
	ClassDB::bind_method(D_METHOD("get_orientation"), &RagdollLimb::get_orientation);
	ClassDB::bind_method(D_METHOD("set_radius", "radius"), &RagdollLimb::set_radius);
	ClassDB::bind_method(D_METHOD("get_radius"), &RagdollLimb::get_radius);
	ClassDB::bind_method(D_METHOD("set_length", "length"), &RagdollLimb::set_length);
	ClassDB::bind_method(D_METHOD("get_length"), &RagdollLimb::get_length);
	ClassDB::bind_method(D_METHOD("set_size", "size"), &RagdollLimb::set_size);
	ClassDB::bind_method(D_METHOD("get_size"), &RagdollLimb::get_size);
	ClassDB::bind_method(D_METHOD("set_anchor", "anchor"), &RagdollLimb::set_anchor);
	ClassDB::bind_method(D_METHOD("get_anchor"), &RagdollLimb::get_anchor);
	ClassDB::bind_method(D_METHOD("set_rest_orientation", "orientation"), &RagdollLimb::set_rest_orientation);
	ClassDB::bind_method(D_METHOD("get_rest_orientation"), &RagdollLimb::get_rest_orientation);
	ClassDB::bind_method(D_METHOD("set_reset_orientation", "orientation"), &RagdollLimb::set_reset_orientation);
	ClassDB::bind_method(D_METHOD("get_reset_orientation"), &RagdollLimb::get_reset_orientation);
	ClassDB::bind_method(D_METHOD("set_mass_fraction", "fraction"), &RagdollLimb::set_mass_fraction);
	ClassDB::bind_method(D_METHOD("get_mass_fraction"), &RagdollLimb::get_mass_fraction);
	ClassDB::bind_method(D_METHOD("set_max_torque", "torque"), &RagdollLimb::set_max_torque);
	ClassDB::bind_method(D_METHOD("get_max_torque"), &RagdollLimb::get_max_torque);
	ClassDB::bind_method(D_METHOD("set_contact_points", "points"), &RagdollLimb::set_contact_points);
	ClassDB::bind_method(D_METHOD("get_contact_points"), &RagdollLimb::get_contact_points);
	ClassDB::bind_method(D_METHOD("set_contact_radius", "radius"), &RagdollLimb::set_contact_radius);
	ClassDB::bind_method(D_METHOD("get_contact_radius"), &RagdollLimb::get_contact_radius);
	ClassDB::bind_method(D_METHOD("set_is_foot", "is_foot"), &RagdollLimb::set_is_foot);
	ClassDB::bind_method(D_METHOD("get_is_foot"), &RagdollLimb::get_is_foot);
	ClassDB::bind_method(D_METHOD("set_min_angles", "angles"), &RagdollLimb::set_min_angles);
	ClassDB::bind_method(D_METHOD("get_min_angles"), &RagdollLimb::get_min_angles);
	ClassDB::bind_method(D_METHOD("set_max_angles", "angles"), &RagdollLimb::set_max_angles);
	ClassDB::bind_method(D_METHOD("get_max_angles"), &RagdollLimb::get_max_angles);
	ClassDB::bind_method(D_METHOD("get_inertia", "mass"), &RagdollLimb::get_inertia);
	ClassDB::bind_method(D_METHOD("get_body_inertia", "mass"), &RagdollLimb::get_body_inertia);
	ClassDB::bind_method(D_METHOD("get_joint_axes"), &RagdollLimb::get_joint_axes);
	ClassDB::bind_method(D_METHOD("find_fault"), &RagdollLimb::find_fault);
	bind_properties();
	BIND_ENUM_CONSTANT(PILL);
	BIND_ENUM_CONSTANT(BOX);
}

void RagdollLimb::bind_properties() {
	ADD_PROPERTY(PropertyInfo(Variant::STRING_NAME, "bone"), "set_bone", "get_bone");
	ADD_PROPERTY(PropertyInfo(Variant::STRING_NAME, "parent_bone"), "set_parent_bone", "get_parent_bone");
	ADD_PROPERTY(PropertyInfo(Variant::STRING_NAME, "group", PROPERTY_HINT_ENUM_SUGGESTION,
						 "trunk,head,left_arm,right_arm,left_leg,right_leg"),
			"set_group", "get_group");
	ADD_GROUP("Shape", "");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "type", PROPERTY_HINT_ENUM, "Pill,Box"), "set_type", "get_type");
	ADD_PROPERTY(
			PropertyInfo(Variant::VECTOR3, "position", PROPERTY_HINT_NONE, "suffix:m"), "set_position", "get_position");
	ADD_PROPERTY(PropertyInfo(Variant::QUATERNION, "orientation"), "set_orientation", "get_orientation");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "radius", PROPERTY_HINT_RANGE, "0.001,1,0.001,or_greater,suffix:m"),
			"set_radius", "get_radius");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "length", PROPERTY_HINT_RANGE, "0,2,0.001,or_greater,suffix:m"),
			"set_length", "get_length");
	ADD_PROPERTY(PropertyInfo(Variant::VECTOR3, "size", PROPERTY_HINT_NONE, "suffix:m"), "set_size", "get_size");
	ADD_GROUP("Joint", "");
	ADD_PROPERTY(PropertyInfo(Variant::VECTOR3, "anchor", PROPERTY_HINT_NONE, "suffix:m"), "set_anchor", "get_anchor");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "max_torque", PROPERTY_HINT_RANGE, "0,1000,0.1,or_greater,suffix:Nm"),
			"set_max_torque", "get_max_torque");
	ADD_PROPERTY(PropertyInfo(Variant::VECTOR3, "min_angles", PROPERTY_HINT_RANGE, "-180,180,0.1,radians_as_degrees"),
			"set_min_angles", "get_min_angles");
	ADD_PROPERTY(PropertyInfo(Variant::VECTOR3, "max_angles", PROPERTY_HINT_RANGE, "-180,180,0.1,radians_as_degrees"),
			"set_max_angles", "get_max_angles");
	ADD_GROUP("Body", "");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "mass_fraction", PROPERTY_HINT_RANGE, "0,1,0.0001"), "set_mass_fraction",
			"get_mass_fraction");
	ADD_GROUP("Pose", "");
	ADD_PROPERTY(PropertyInfo(Variant::QUATERNION, "rest_orientation"), "set_rest_orientation", "get_rest_orientation");
	ADD_PROPERTY(
			PropertyInfo(Variant::QUATERNION, "reset_orientation"), "set_reset_orientation", "get_reset_orientation");
	ADD_GROUP("Contacts", "");
	ADD_PROPERTY(PropertyInfo(Variant::PACKED_VECTOR3_ARRAY, "contact_points", PROPERTY_HINT_NONE, "suffix:m"),
			"set_contact_points", "get_contact_points");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "contact_radius", PROPERTY_HINT_RANGE, "0,0.5,0.001,or_greater,suffix:m"),
			"set_contact_radius", "get_contact_radius");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "is_foot"), "set_is_foot", "get_is_foot");
}

} // namespace godot
