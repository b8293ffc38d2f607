// SPDX-License-Identifier: MIT
#include "internal.hpp"

#include <godot_cpp/core/expected_api.hpp>
#include <godot_cpp/godot.hpp>

#include <cstdio>

namespace godot {

namespace internal {

GDExtensionClassLibraryPtr library = nullptr;

namespace {

struct State {
	GDExtensionBinding::Callback initializer = nullptr;
	GDExtensionBinding::Callback terminator = nullptr;
	bool usable = false; // Whether the engine has what the bindings were generated for.
};

State state;

void initialize_level(void *, GDExtensionInitializationLevel p_level) {
	if (p_level == GDEXTENSION_INITIALIZATION_SCENE) {
		// Only now are all engine classes there to be checked.
		state.usable = check_expected_api();
		activate_engine_classes();
	}
	if (!state.usable) {
		return; // Without its classes the extension does nothing, rather than crash half way.
	}
	if (p_level == GDEXTENSION_INITIALIZATION_EDITOR) {
		load_documentation();
	}
	if (state.initializer != nullptr) {
		state.initializer(static_cast<ModuleInitializationLevel>(p_level));
	}
}

void terminate_level(void *, GDExtensionInitializationLevel p_level) {
	if (!state.usable) {
		return;
	}
	if (state.terminator != nullptr) {
		state.terminator(static_cast<ModuleInitializationLevel>(p_level));
	}
	if (p_level == GDEXTENSION_INITIALIZATION_SCENE) {
		unregister_classes();
		state.usable = false;
	}
}

} // namespace

} // namespace internal

GDExtensionBinding::InitObject::InitObject(GDExtensionInterfaceGetProcAddress p_get_proc_address,
		GDExtensionClassLibraryPtr p_library, GDExtensionInitialization *r_initialization) :
		initialization(r_initialization), missing_function(internal::engine.load(p_get_proc_address)) {
	internal::library = p_library;
}

void GDExtensionBinding::InitObject::register_initializer(Callback p_callback) const {
	internal::state.initializer = p_callback;
}

void GDExtensionBinding::InitObject::register_terminator(Callback p_callback) const {
	internal::state.terminator = p_callback;
}

void GDExtensionBinding::InitObject::set_minimum_library_initialization_level(ModuleInitializationLevel p_level) const {
	initialization->minimum_initialization_level = static_cast<GDExtensionInitializationLevel>(p_level);
}

GDExtensionBool GDExtensionBinding::InitObject::init() const {
	if (missing_function != nullptr) {
		// The engine's own means of printing may be what is missing.
		std::fprintf(stderr, "ERROR: This extension was built for %s; the running engine lacks %s().\n",
				internal::expected_engine, missing_function);
		return 0;
	}
	initialization->initialize = internal::initialize_level;
	initialization->deinitialize = internal::terminate_level;
	return 1;
}

} // namespace godot
