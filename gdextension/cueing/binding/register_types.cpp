// SPDX-License-Identifier: MIT
#include "force_wheel.hpp"
#include "motion_cueing.hpp"
#include "platform_sender.hpp"
#include "seat_motion.hpp"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/defs.hpp>
#include <godot_cpp/godot.hpp>

using namespace godot;

namespace {

void initialize(ModuleInitializationLevel p_level) {
	if (p_level == MODULE_INITIALIZATION_LEVEL_SCENE) {
		GDREGISTER_CLASS(ForceWheel);
		GDREGISTER_CLASS(MotionCueing);
		GDREGISTER_CLASS(PlatformSender);
		GDREGISTER_CLASS(SeatMotion);
	}
}

void terminate(ModuleInitializationLevel /*p_level*/) {}

} // namespace

extern "C" GDExtensionBool GDE_EXPORT cueing_init(GDExtensionInterfaceGetProcAddress p_get_proc_address,
		GDExtensionClassLibraryPtr p_library, GDExtensionInitialization *r_initialization) {
	GDExtensionBinding::InitObject init(p_get_proc_address, p_library, r_initialization);
	init.register_initializer(initialize);
	init.register_terminator(terminate);
	init.set_minimum_library_initialization_level(MODULE_INITIALIZATION_LEVEL_SCENE);
	return init.init();
}
