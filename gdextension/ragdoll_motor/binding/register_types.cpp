// SPDX-License-Identifier: MIT
#include "ragdoll_control.hpp"
#include "ragdoll_control_profile.hpp"
#include "ragdoll_limb.hpp"
#include "ragdoll_motor.hpp"
#include "ragdoll_profile.hpp"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/defs.hpp>
#include <godot_cpp/godot.hpp>

using namespace godot;

namespace {

void initialize(ModuleInitializationLevel p_level) {
	if (p_level == MODULE_INITIALIZATION_LEVEL_SCENE) {
		GDREGISTER_CLASS(RagdollLimb);
		GDREGISTER_CLASS(RagdollProfile);
		GDREGISTER_CLASS(RagdollControl);
		GDREGISTER_CLASS(RagdollControlProfile);
		GDREGISTER_CLASS(RagdollMotor);
	}
}

void terminate(ModuleInitializationLevel) {}

} // namespace

extern "C" GDExtensionBool GDE_EXPORT ragdoll_motor_init(GDExtensionInterfaceGetProcAddress p_get_proc_address,
		GDExtensionClassLibraryPtr p_library, GDExtensionInitialization *r_initialization) {
	GDExtensionBinding::InitObject init(p_get_proc_address, p_library, r_initialization);
	init.register_initializer(initialize);
	init.register_terminator(terminate);
	init.set_minimum_library_initialization_level(MODULE_INITIALIZATION_LEVEL_SCENE);
	return init.init();
}
