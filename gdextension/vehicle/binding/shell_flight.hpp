// SPDX-License-Identifier: MIT
#pragma once

#include <ballistics.hpp>

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/vector3.hpp>

namespace godot {

/// A shell in flight. Documented in doc_classes/ShellFlight.xml.
class ShellFlight : public RefCounted {
	GDCLASS(ShellFlight, RefCounted)

public:
	bool set_drag(double p_drag_coefficient, double p_calibre, double p_mass);
	bool set_ballistic_coefficient(double p_pounds_per_square_inch);
	bool launch(const Vector3 &p_position, const Vector3 &p_velocity, double p_gravity);
	bool advance(double p_delta) { return _flight.advance(p_delta); }
	Vector3 get_position() const;
	Vector3 get_velocity() const;
	double get_age() const { return _flight.age(); }

protected:
	static void _bind_methods();

private:
	bool _take(const vehicle::Drag &p_drag);

	vehicle::ShellFlight _flight;
	vehicle::Drag _drag;
};

} // namespace godot
