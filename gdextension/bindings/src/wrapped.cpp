// SPDX-License-Identifier: MIT
#include <godot_cpp/classes/object.hpp>
#include <godot_cpp/core/memory.hpp>

#include <mutex>
#include <string>
#include <unordered_map>

namespace godot {

namespace internal {

GDExtensionClassLibraryPtr library = nullptr;

namespace {

// Which extension class the next Wrapped constructor of this thread is for.
thread_local const StringName *under_construction = nullptr;

// Objects of the extension's classes are deleted by free_instance instead.
const GDExtensionInstanceBindingCallbacks extension_callbacks = {
	[](void *, void *) -> void * { return nullptr; },
	[](void *, void *, void *) {},
	[](void *, void *, GDExtensionBool) -> GDExtensionBool { return true; },
};

/// The deepest class of the bindings that an object belongs to. Engine classes need not be public,
/// nor in the build profile: only the object itself knows what it is.
const EngineClass *nearest_class(GDExtensionObjectPtr p_object, const EngineClass &p_fallback) {
	const EngineClass *nearest = &p_fallback;
	for (const EngineClass *candidate : engine_classes()) {
		const String name(candidate->name);
		const void *arguments[] = { &name };
		GDExtensionBool is_class = false;
		object_is_class.ptrcall(p_object, arguments, &is_class);
		if (is_class != 0) {
			nearest = candidate; // Parents come first in the list: the last one is the deepest.
		}
	}
	return nearest;
}

const EngineClass *class_of(GDExtensionObjectPtr p_object, const EngineClass &p_fallback) {
	static std::mutex mutex;
	static std::unordered_map<std::string, const EngineClass *> known;
	StringName name;
	if (engine.object_get_class_name(p_object, library, name.opaque) == 0) {
		return &p_fallback;
	}
	const std::string key = String(name).utf8().get_data();
	const std::lock_guard<std::mutex> lock(mutex);
	const auto found = known.find(key);
	if (found != known.end()) {
		return found->second;
	}
	const EngineClass *nearest = nearest_class(p_object, p_fallback);
	known[key] = nearest;
	return nearest;
}

} // namespace

Wrapped *wrap_object(GDExtensionObjectPtr p_object, const EngineClass &p_fallback) {
	void *wrapper = engine.object_get_instance_binding(p_object, library, nullptr);
	if (wrapper == nullptr) {
		const EngineClass *engine_class = class_of(p_object, p_fallback);
		wrapper = engine.object_get_instance_binding(p_object, library, engine_class->callbacks);
	}
	return static_cast<Wrapped *>(wrapper);
}

void destroy(Wrapped *p_object) {
	engine.object_destroy(p_object->_owner);
}

ConstructionBase::ConstructionBase(const StringName *p_extension_class) {
	under_construction = p_extension_class;
}

void ConstructionBase::notify_created(Wrapped *p_object) {
	static_cast<Object *>(p_object)->notification(Object::NOTIFICATION_POSTINITIALIZE, false);
}

} // namespace internal

Wrapped::Wrapped(const internal::EngineClass &p_class) {
	const StringName engine_class(p_class.name);
	_owner = internal::engine.classdb_construct_object2(engine_class.opaque);
	const GDExtensionInstanceBindingCallbacks *callbacks = p_class.callbacks;
	const StringName *extension_class = std::exchange(internal::under_construction, nullptr);
	if (extension_class != nullptr) {
		internal::engine.object_set_instance(_owner, extension_class->opaque, this);
		callbacks = &internal::extension_callbacks;
	}
	internal::engine.object_set_instance_binding(_owner, internal::library, this, callbacks);
}

} // namespace godot
