// SPDX-License-Identifier: MIT
#include "force_wheel.hpp"

#include <godot_cpp/core/error_macros.hpp>

namespace godot {

PackedStringArray ForceWheel::list_devices() {
	PackedStringArray lines;
	for (const cueing::ForceDeviceInfo &device : cueing::list_force_devices()) {
		std::string line = device.path + " " + device.name + ":";
		for (const cueing::ForceKind kind : cueing::ALL_FORCE_KINDS) {
			line += device.can[std::size_t(kind)] ? std::string(" ") + cueing::force_name(kind) : "";
		}
		line += device.error.empty() ? "" : " (" + device.error + ")";
		lines.push_back(String::utf8(line.c_str()));
	}
	return lines;
}

void ForceWheel::open(const String &p_path) {
	_core.open(p_path.utf8().get_data());
}

bool ForceWheel::can(Force p_force) const {
	ERR_FAIL_COND_V_MSG(p_force < FORCE_CONSTANT || p_force > FORCE_PERIODIC, false, "There is no such force.");
	return _core.report().can[std::size_t(p_force)];
}

String ForceWheel::get_trouble() const {
	return String::utf8(_core.report().trouble.c_str());
}

void ForceWheel::set_spring(double p_strength, double p_centre, double p_dead_band) {
	_forces.spring = p_strength;
	_forces.spring_centre = p_centre;
	_forces.spring_dead_band = p_dead_band;
}

void ForceWheel::set_periodic(double p_strength, double p_frequency) {
	_forces.periodic = p_strength;
	_forces.periodic_hz = p_frequency;
}

void ForceWheel::_bind_methods() {
	ClassDB::bind_static_method("ForceWheel", D_METHOD("list_devices"), &ForceWheel::list_devices);
	ClassDB::bind_method(D_METHOD("open", "path"), &ForceWheel::open);
	ClassDB::bind_method(D_METHOD("close"), &ForceWheel::close);
	ClassDB::bind_method(D_METHOD("is_open"), &ForceWheel::is_open);
	ClassDB::bind_method(D_METHOD("can", "force"), &ForceWheel::can);
	ClassDB::bind_method(D_METHOD("get_trouble"), &ForceWheel::get_trouble);
	ClassDB::bind_method(D_METHOD("set_gain", "gain"), &ForceWheel::set_gain);
	ClassDB::bind_method(D_METHOD("set_constant", "level"), &ForceWheel::set_constant);
	ClassDB::bind_method(D_METHOD("set_spring", "strength", "centre", "dead_band"), &ForceWheel::set_spring);
	ClassDB::bind_method(D_METHOD("set_damper", "strength"), &ForceWheel::set_damper);
	ClassDB::bind_method(D_METHOD("set_periodic", "strength", "frequency"), &ForceWheel::set_periodic);
	ClassDB::bind_method(D_METHOD("apply"), &ForceWheel::apply);
	BIND_ENUM_CONSTANT(FORCE_CONSTANT);
	BIND_ENUM_CONSTANT(FORCE_SPRING);
	BIND_ENUM_CONSTANT(FORCE_DAMPER);
	BIND_ENUM_CONSTANT(FORCE_PERIODIC);
}

} // namespace godot
