// SPDX-License-Identifier: MIT
#include "body_probe.hpp"
#include "math_probe.hpp"
#include "node_probe.hpp"
#include "value_probe.hpp"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/defs.hpp>
#include <godot_cpp/godot.hpp>
#include <godot_cpp/variant/utility_functions.hpp>

using namespace godot;

namespace {

void initialize(ModuleInitializationLevel p_level) {
	if (p_level != MODULE_INITIALIZATION_LEVEL_SCENE) {
		return;
	}
	GDREGISTER_CLASS(probe::ValueProbe);
	GDREGISTER_CLASS(probe::MathProbe);
	GDREGISTER_CLASS(probe::NodeProbe);
	GDREGISTER_CLASS(probe::LoudNodeProbe);
	GDREGISTER_CLASS(probe::ResourceProbe);
	GDREGISTER_ABSTRACT_CLASS(probe::AbstractProbe);
	GDREGISTER_CLASS(probe::ConcreteProbe);
	GDREGISTER_CLASS(probe::BodyProbe);
	UtilityFunctions::print("binding_probe: ", 8, " classes");
}

void terminate(ModuleInitializationLevel) {}

} // namespace

extern "C" GDExtensionBool GDE_EXPORT binding_probe_init(GDExtensionInterfaceGetProcAddress p_get_proc_address,
		GDExtensionClassLibraryPtr p_library, GDExtensionInitialization *r_initialization) {
	GDExtensionBinding::InitObject init(p_get_proc_address, p_library, r_initialization);
	init.register_initializer(initialize);
	init.register_terminator(terminate);
	init.set_minimum_library_initialization_level(MODULE_INITIALIZATION_LEVEL_SCENE);
	return init.init();
}
