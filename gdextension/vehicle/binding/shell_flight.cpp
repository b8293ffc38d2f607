// SPDX-License-Identifier: MIT
#include "shell_flight.hpp"

namespace godot {

bool ShellFlight::set_drag(double p_drag_coefficient, double p_calibre, double p_mass) {
	return _take(vehicle::Drag::from_shape(p_drag_coefficient, p_calibre, p_mass));
}

bool ShellFlight::set_ballistic_coefficient(double p_pounds_per_square_inch) {
	return _take(vehicle::Drag::from_g7(p_pounds_per_square_inch));
}

bool ShellFlight::launch(const Vector3 &p_position, const Vector3 &p_velocity, double p_gravity) {
	return _flight.launch({ p_position.x, p_position.y, p_position.z }, { p_velocity.x, p_velocity.y, p_velocity.z },
			_drag, p_gravity);
}

Vector3 ShellFlight::get_position() const {
	const vehicle::Vec3d &place = _flight.position();
	return { real_t(place.x), real_t(place.y), real_t(place.z) };
}

Vector3 ShellFlight::get_velocity() const {
	const vehicle::Vec3d &speed = _flight.velocity();
	return { real_t(speed.x), real_t(speed.y), real_t(speed.z) };
}

bool ShellFlight::_take(const vehicle::Drag &p_drag) {
	ERR_FAIL_COND_V_MSG(!p_drag.is_valid(), false,
			"A shell's drag makes no sense: mass and calibre are above 0, the drag is finite and not below 0.");
	_drag = p_drag;
	return true;
}

void ShellFlight::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_drag", "drag_coefficient", "calibre", "mass"), &ShellFlight::set_drag);
	ClassDB::bind_method(
			D_METHOD("set_ballistic_coefficient", "pounds_per_square_inch"), &ShellFlight::set_ballistic_coefficient);
	ClassDB::bind_method(D_METHOD("launch", "position", "velocity", "gravity"), &ShellFlight::launch, DEFVAL(9.81));
	ClassDB::bind_method(D_METHOD("advance", "delta"), &ShellFlight::advance);
	ClassDB::bind_method(D_METHOD("get_position"), &ShellFlight::get_position);
	ClassDB::bind_method(D_METHOD("get_velocity"), &ShellFlight::get_velocity);
	ClassDB::bind_method(D_METHOD("get_age"), &ShellFlight::get_age);
}

} // namespace godot
