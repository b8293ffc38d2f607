// SPDX-License-Identifier: MIT
#include "vehicle_wheel.hpp"

namespace godot {

template <class T>
void VehicleWheel::change(T &r_member, const T &p_value) {
	r_member = p_value;
	emit_changed();
}

void VehicleWheel::set_position(const Vector3 &p_position) {
	change(_position, p_position);
}

void VehicleWheel::set_radius(double p_radius) {
	change(_radius, p_radius);
}

void VehicleWheel::set_mass(double p_mass) {
	change(_mass, p_mass);
}

void VehicleWheel::set_stiffness(double p_stiffness) {
	change(_stiffness, p_stiffness);
}

void VehicleWheel::set_damping(double p_damping) {
	change(_damping, p_damping);
}

void VehicleWheel::set_sag(double p_sag) {
	change(_sag, p_sag);
}

void VehicleWheel::set_travel_up(double p_travel) {
	change(_travel_up, p_travel);
}

void VehicleWheel::set_travel_down(double p_travel) {
	change(_travel_down, p_travel);
}

void VehicleWheel::set_grip(double p_grip) {
	change(_grip, p_grip);
}

void VehicleWheel::set_side_grip(double p_grip) {
	change(_side_grip, p_grip);
}

void VehicleWheel::set_rays(int64_t p_rays) {
	change(_rays, p_rays);
}

void VehicleWheel::set_is_driven(bool p_driven) {
	change(_is_driven, p_driven);
}

void VehicleWheel::set_is_steered(bool p_steered) {
	change(_is_steered, p_steered);
}

void VehicleWheel::set_is_parked(bool p_parked) {
	change(_is_parked, p_parked);
}

void VehicleWheel::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_position", "position"), &VehicleWheel::set_position);
	ClassDB::bind_method(D_METHOD("get_position"), &VehicleWheel::get_position);
	ClassDB::bind_method(D_METHOD("set_radius", "radius"), &VehicleWheel::set_radius);
	ClassDB::bind_method(D_METHOD("get_radius"), &VehicleWheel::get_radius);
	ClassDB::bind_method(D_METHOD("set_mass", "mass"), &VehicleWheel::set_mass);
	ClassDB::bind_method(D_METHOD("get_mass"), &VehicleWheel::get_mass);
	ClassDB::bind_method(D_METHOD("set_stiffness", "stiffness"), &VehicleWheel::set_stiffness);
	ClassDB::bind_method(D_METHOD("get_stiffness"), &VehicleWheel::get_stiffness);
	ClassDB::bind_method(D_METHOD("set_damping", "damping"), &VehicleWheel::set_damping);
	ClassDB::bind_method(D_METHOD("get_damping"), &VehicleWheel::get_damping);
	ClassDB::bind_method(D_METHOD("set_sag", "sag"), &VehicleWheel::set_sag);
	ClassDB::bind_method(D_METHOD("get_sag"), &VehicleWheel::get_sag);
	ClassDB::bind_method(D_METHOD("set_travel_up", "travel"), &VehicleWheel::set_travel_up);
	ClassDB::bind_method(D_METHOD("get_travel_up"), &VehicleWheel::get_travel_up);
	ClassDB::bind_method(D_METHOD("set_travel_down", "travel"), &VehicleWheel::set_travel_down);
	ClassDB::bind_method(D_METHOD("get_travel_down"), &VehicleWheel::get_travel_down);
	ClassDB::bind_method(D_METHOD("set_grip", "grip"), &VehicleWheel::set_grip);
	ClassDB::bind_method(D_METHOD("get_grip"), &VehicleWheel::get_grip);
	ClassDB::bind_method(D_METHOD("set_side_grip", "grip"), &VehicleWheel::set_side_grip);
	ClassDB::bind_method(D_METHOD("get_side_grip"), &VehicleWheel::get_side_grip);
	ClassDB::bind_method(D_METHOD("set_rays", "rays"), &VehicleWheel::set_rays);
	ClassDB::bind_method(D_METHOD("get_rays"), &VehicleWheel::get_rays);
	ClassDB::bind_method(D_METHOD("set_is_driven", "driven"), &VehicleWheel::set_is_driven);
	ClassDB::bind_method(D_METHOD("get_is_driven"), &VehicleWheel::get_is_driven);
	ClassDB::bind_method(D_METHOD("set_is_steered", "steered"), &VehicleWheel::set_is_steered);
	ClassDB::bind_method(D_METHOD("get_is_steered"), &VehicleWheel::get_is_steered);
	ClassDB::bind_method(D_METHOD("set_is_parked", "parked"), &VehicleWheel::set_is_parked);
	ClassDB::bind_method(D_METHOD("get_is_parked"), &VehicleWheel::get_is_parked);
	ADD_PROPERTY(
			PropertyInfo(Variant::VECTOR3, "position", PROPERTY_HINT_NONE, "suffix:m"), "set_position", "get_position");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "radius", PROPERTY_HINT_NONE, "suffix:m"), "set_radius", "get_radius");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "mass", PROPERTY_HINT_NONE, "suffix:kg"), "set_mass", "get_mass");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "stiffness", PROPERTY_HINT_NONE, "suffix:N/m"), "set_stiffness",
			"get_stiffness");
	ADD_PROPERTY(
			PropertyInfo(Variant::FLOAT, "damping", PROPERTY_HINT_NONE, "suffix:N s/m"), "set_damping", "get_damping");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "sag", PROPERTY_HINT_NONE, "suffix:m"), "set_sag", "get_sag");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "travel_up", PROPERTY_HINT_NONE, "suffix:m"), "set_travel_up",
			"get_travel_up");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "travel_down", PROPERTY_HINT_NONE, "suffix:m"), "set_travel_down",
			"get_travel_down");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "grip", PROPERTY_HINT_NONE, ""), "set_grip", "get_grip");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "side_grip", PROPERTY_HINT_NONE, ""), "set_side_grip", "get_side_grip");
	ADD_PROPERTY(PropertyInfo(Variant::INT, "rays", PROPERTY_HINT_RANGE, "1,5"), "set_rays", "get_rays");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "is_driven"), "set_is_driven", "get_is_driven");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "is_steered"), "set_is_steered", "get_is_steered");
	ADD_PROPERTY(PropertyInfo(Variant::BOOL, "is_parked"), "set_is_parked", "get_is_parked");
}

} // namespace godot
