// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/classes/resource.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/vector3.hpp>

namespace godot {

/// A wheel of a vehicle, or a sphere that stands for a part of a track. Documented in doc_classes/VehicleWheel.xml.
class VehicleWheel : public Resource {
	GDCLASS(VehicleWheel, Resource)

public:
	void set_position(const Vector3 &p_position);
	Vector3 get_position() const { return _position; }
	void set_radius(double p_radius);
	double get_radius() const { return _radius; }
	void set_mass(double p_mass);
	double get_mass() const { return _mass; }
	void set_stiffness(double p_stiffness);
	double get_stiffness() const { return _stiffness; }
	void set_damping(double p_damping);
	double get_damping() const { return _damping; }
	void set_sag(double p_sag);
	double get_sag() const { return _sag; }
	void set_travel_up(double p_travel);
	double get_travel_up() const { return _travel_up; }
	void set_travel_down(double p_travel);
	double get_travel_down() const { return _travel_down; }
	void set_grip(double p_grip);
	double get_grip() const { return _grip; }
	void set_side_grip(double p_grip);
	double get_side_grip() const { return _side_grip; }
	void set_rays(int64_t p_rays);
	int64_t get_rays() const { return _rays; }
	void set_is_driven(bool p_driven);
	bool get_is_driven() const { return _is_driven; }
	void set_is_steered(bool p_steered);
	bool get_is_steered() const { return _is_steered; }
	void set_is_parked(bool p_parked);
	bool get_is_parked() const { return _is_parked; }

protected:
	static void _bind_methods();

private:
	template <class T>
	void change(T &r_member, const T &p_value);

	Vector3 _position;
	double _radius = 0.5;
	double _mass = 50.0;
	double _stiffness = 60e3;
	double _damping = 6e3;
	double _sag = 0.1;
	double _travel_up = 0.15;
	double _travel_down = 0.15;
	double _grip = 0.9;
	double _side_grip = 0.9;
	int64_t _rays = 1;
	bool _is_driven = true;
	bool _is_steered = false;
	bool _is_parked = true;
};

} // namespace godot
