// SPDX-License-Identifier: MIT
#include "error_filter.hpp"
#include "private_file.hpp"
#include "runtime_probe.hpp"
#include "stall_guard.hpp"
#include "stop_signal.hpp"
#include "terminal.hpp"
#include "thread_clock.hpp"

#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/core/defs.hpp>
#include <godot_cpp/godot.hpp>

using namespace godot;

namespace {

void initialize(ModuleInitializationLevel p_level) {
	if (p_level == MODULE_INITIALIZATION_LEVEL_SCENE) {
		GDREGISTER_CLASS(ErrorFilter);
		GDREGISTER_CLASS(PrivateFile);
		GDREGISTER_CLASS(RuntimeProbe);
		GDREGISTER_CLASS(StallGuard);
		GDREGISTER_CLASS(StopSignal);
		GDREGISTER_CLASS(Terminal);
		GDREGISTER_CLASS(ThreadClock);
	}
}

void terminate(ModuleInitializationLevel p_level) {
	if (p_level == MODULE_INITIALIZATION_LEVEL_SCENE) {
		ErrorFilter::close();
		StopSignal::forget();
	}
}

} // namespace

extern "C" GDExtensionBool GDE_EXPORT host_init(GDExtensionInterfaceGetProcAddress p_get_proc_address,
		GDExtensionClassLibraryPtr p_library, GDExtensionInitialization *r_initialization) {
	GDExtensionBinding::InitObject init(p_get_proc_address, p_library, r_initialization);
	init.register_initializer(initialize);
	init.register_terminator(terminate);
	init.set_minimum_library_initialization_level(MODULE_INITIALIZATION_LEVEL_SCENE);
	return init.init();
}
