// SPDX-License-Identifier: MIT
#include "drivetrain.hpp"

namespace godot {

void VehicleDrivetrain::set_engine(const PackedVector2Array &p_curve, double p_idle_rpm, double p_max_rpm,
		double p_inertia, double p_friction, double p_response) {
	vehicle::EngineSettings settings;
	for (const Vector2 &point : p_curve) {
		settings.curve.push_back({ point.x, point.y });
	}
	settings.idle_rpm = float(p_idle_rpm);
	settings.max_rpm = float(p_max_rpm);
	settings.inertia = float(p_inertia);
	settings.friction = float(p_friction);
	settings.response = float(p_response);
	_engine.settings = settings;
	_engine.reset();
}

void VehicleDrivetrain::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_engine", "curve", "idle_rpm", "max_rpm", "inertia", "friction", "response"),
			&VehicleDrivetrain::set_engine);
	ClassDB::bind_method(D_METHOD("get_rpm"), &VehicleDrivetrain::get_rpm);
	ClassDB::bind_method(D_METHOD("get_load"), &VehicleDrivetrain::get_load);
	ClassDB::bind_method(D_METHOD("set_running", "running"), &VehicleDrivetrain::set_running);
	ClassDB::bind_method(D_METHOD("is_running"), &VehicleDrivetrain::is_running);
}

} // namespace godot
