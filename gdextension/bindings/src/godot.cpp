// SPDX-License-Identifier: MIT
#include <godot_cpp/core/startup.hpp>
#include <godot_cpp/godot.hpp>

#include <cstdio>

namespace godot {

namespace internal {

namespace {

struct Xml {
	const char *text;
	std::size_t size;
};

// Filled by static objects, before there is an engine to ask for anything.
std::vector<Xml> &documentation() {
	static std::vector<Xml> files;
	return files;
}

GDExtensionBinding::Callback initializer = nullptr;
GDExtensionBinding::Callback terminator = nullptr;
bool is_running = false;
/// Whether a headless editor has found the extension by itself: it may quit before it can know our classes.
bool is_late = false;

/// What a method without arguments of an engine's singleton gives; null where it is not there.
Variant ask(const char *p_singleton, const char *p_method) {
	const GDExtensionObjectPtr object = engine.global_get_singleton(StringName(p_singleton).opaque);
	if (object == nullptr) {
		return Variant();
	}
	Variant self;
	make_variant(GDEXTENSION_VARIANT_TYPE_OBJECT, &self, &object);
	Variant answer;
	GDExtensionCallError error = {};
	const StringName method(p_method);
	engine.variant_call(&self, method.opaque, nullptr, 0, &answer, &error);
	return error.error == GDEXTENSION_CALL_OK ? answer : Variant();
}

/// Whether the editor has no window and began before it had the extension: the first `--import` of a project.
bool comes_late() {
	return ask("Engine", "get_main_loop").booleanize() &&
			ask("DisplayServer", "get_name") == Variant(String("headless"));
}

/// The editor describes the classes of extensions in a call that it defers, and quits without waiting for it: the
/// call then finds the help deleted and crashes (godotengine/godot#111048). It finds no classes to describe, as
/// this comes first and every node is gone by now.
void shut_down() {
	if (is_running && is_late) {
		unregister_classes();
	}
}

/// One error that says what does not fit together, and what to do.
void report(const std::vector<std::string> &p_missing) {
	GDExtensionGodotVersion2 version = {};
	engine.get_godot_version2(&version);
	std::string message = "The engine, Godot " + std::string(version.string) + ", lacks ";
	constexpr std::size_t SHOWN = 10;
	for (std::size_t i = 0; i < p_missing.size() && i < SHOWN; i++) {
		message += (i == 0 ? "" : ", ") + p_missing[i];
	}
	if (p_missing.size() > SHOWN) {
		message += " and " + std::to_string(p_missing.size() - SHOWN) + " more";
	}
	message += ". The extension was built for " + std::string(generated_for) +
			" and is not started: dump the API of this engine and build the extension again.";
	engine.print_error("Extension and engine do not fit.", "init", "godot_cpp", 0, true);
	engine.print_error(message.c_str(), "init", "godot_cpp", 0, true);
}

void initialize(void *, GDExtensionInitializationLevel p_level) {
	if (p_level == GDEXTENSION_INITIALIZATION_SCENE) {
		const std::vector<std::string> missing = load_class_methods();
		is_running = missing.empty();
		if (!is_running) {
			report(missing);
		}
	}
	if (!is_running) {
		return;
	}
	if (initializer != nullptr) {
		initializer(ModuleInitializationLevel(p_level));
	}
	if (p_level == GDEXTENSION_INITIALIZATION_EDITOR) {
		is_late = comes_late();
		if (!is_late) {
			load_documentation();
		}
	}
}

void deinitialize(void *, GDExtensionInitializationLevel p_level) {
	if (!is_running) {
		return;
	}
	if (terminator != nullptr) {
		terminator(ModuleInitializationLevel(p_level));
	}
	if (p_level == GDEXTENSION_INITIALIZATION_SCENE) {
		unregister_classes();
		is_running = false;
	}
}

} // namespace

Documentation::Documentation(const char *p_xml, std::size_t p_size) {
	documentation().push_back({ p_xml, p_size });
}

void load_documentation() {
	for (const Xml &file : documentation()) {
		engine.editor_help_load_xml_from_utf8_chars_and_len(file.text, int64_t(file.size));
	}
}

} // namespace internal

GDExtensionBinding::InitObject::InitObject(GDExtensionInterfaceGetProcAddress p_get_proc_address,
		GDExtensionClassLibraryPtr p_library, GDExtensionInitialization *r_initialization) :
		get_proc_address(p_get_proc_address), initialization(r_initialization) {
	internal::library = p_library;
}

void GDExtensionBinding::InitObject::register_initializer(Callback p_initializer) const {
	internal::initializer = p_initializer;
}

void GDExtensionBinding::InitObject::register_terminator(Callback p_terminator) const {
	internal::terminator = p_terminator;
}

void GDExtensionBinding::InitObject::set_minimum_library_initialization_level(ModuleInitializationLevel p_level) const {
	if (p_level < MODULE_INITIALIZATION_LEVEL_SCENE) {
		std::fputs("These bindings start at the level SCENE: see gdextension/bindings/README.md.\n", stderr);
	}
}

GDExtensionBool GDExtensionBinding::InitObject::init() const {
	const char *missing_function = internal::engine.load(get_proc_address);
	if (missing_function != nullptr) {
		std::fprintf(stderr,
				"ERROR: The engine's extension interface lacks %s. The extension was built for %s and is not "
				"started: it needs that version or a newer one.\n",
				missing_function, internal::generated_for);
		return false;
	}
	const std::vector<std::string> missing = internal::load_builtins();
	if (!missing.empty()) {
		internal::report(missing);
		return false;
	}
	internal::load_variant_conversions();
	GDExtensionMainLoopCallbacks callbacks = {};
	callbacks.shutdown_func = internal::shut_down;
	internal::engine.register_main_loop_callbacks(internal::library, &callbacks);
	initialization->minimum_initialization_level = GDEXTENSION_INITIALIZATION_SCENE;
	initialization->initialize = internal::initialize;
	initialization->deinitialize = internal::deinitialize;
	return true;
}

} // namespace godot
