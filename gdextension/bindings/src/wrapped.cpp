// SPDX-License-Identifier: MIT
#include "internal.hpp"

#include <godot_cpp/classes/object.hpp>
#include <godot_cpp/core/expected_api.hpp>

#include <string>
#include <unordered_map>
#include <vector>

namespace godot {

namespace internal {

namespace {

struct PendingClass {
	const char *name;
	const GDExtensionInstanceBindingCallbacks *callbacks;
};

// Inside of functions, because static initializers of other files fill them.
std::vector<PendingClass> &pending_classes() {
	static std::vector<PendingClass> classes;
	return classes;
}

std::unordered_map<uint64_t, const GDExtensionInstanceBindingCallbacks *> &wrappers() {
	static std::unordered_map<uint64_t, const GDExtensionInstanceBindingCallbacks *> table;
	return table;
}

} // namespace

const StringName &permanent_name(const char *p_name) {
	return *new StringName(p_name);
}

void add_engine_class(const char *p_name, const GDExtensionInstanceBindingCallbacks *p_callbacks) {
	pending_classes().push_back({ p_name, p_callbacks });
}

void activate_engine_classes() {
	for (const PendingClass &pending : pending_classes()) {
		wrappers()[key_of(permanent_name(pending.name))] = pending.callbacks;
	}
}

Wrapped *find_or_wrap(GDExtensionObjectPtr p_object, const GDExtensionInstanceBindingCallbacks *p_fallback) {
	if (void *binding = engine.object_get_instance_binding(p_object, library, nullptr)) {
		return static_cast<Wrapped *>(binding);
	}
	// Wrap by the object's own class, so that casts down from a parent find it.
	const GDExtensionInstanceBindingCallbacks *callbacks = p_fallback;
	StringName name;
	if (engine.object_get_class_name(p_object, library, name.opaque) != 0) {
		const auto found = wrappers().find(key_of(name));
		if (found != wrappers().end()) {
			callbacks = found->second;
		}
	}
	return static_cast<Wrapped *>(engine.object_get_instance_binding(p_object, library, callbacks));
}

Wrapped *wrapped_from_variant(const Variant &p_value) {
	return p_value.operator Object *();
}

GDExtensionMethodBindPtr method_bind(const char *p_class, const char *p_method, int64_t p_hash) {
	const StringName class_name(p_class);
	const StringName method(p_method);
	GDExtensionMethodBindPtr found = engine.classdb_get_method_bind(class_name.opaque, method.opaque, p_hash);
	if (found == nullptr) {
		const std::string message = std::string(p_class) + "." + p_method + " is not in " + running_engine() +
				" with the signature that the extension was built for.";
		print_error("Method not found.", message.c_str(), __func__, __FILE__, __LINE__);
	}
	return found;
}

Variant varcall(GDExtensionMethodBindPtr p_method, GDExtensionObjectPtr p_object, const Variant **p_arguments,
		int64_t p_count) {
	Variant result;
	if (p_method == nullptr) {
		return result;
	}
	GDExtensionCallError error = {};
	engine.object_method_bind_call(p_method, p_object,
			reinterpret_cast<const GDExtensionConstVariantPtr *>(p_arguments), p_count, result.opaque, &error);
	if (error.error != GDEXTENSION_CALL_OK) {
		print_error("Call failed.", "The engine refused the arguments of a call.", __func__, __FILE__, __LINE__);
	}
	return result;
}

void print_error(
		const char *p_condition, const char *p_message, const char *p_function, const char *p_file, int p_line) {
	if (p_message[0] == '\0') {
		engine.print_error(p_condition, p_function, p_file, p_line, 0);
	} else {
		engine.print_error_with_message(p_condition, p_message, p_function, p_file, p_line, 0);
	}
}

} // namespace internal

void Wrapped::_attach() {
	if (const StringName *name = _extension_class()) {
		internal::engine.object_set_instance(_owner, name->opaque, this);
	}
	internal::engine.object_set_instance_binding(_owner, internal::library, this, _callbacks());
}

} // namespace godot
