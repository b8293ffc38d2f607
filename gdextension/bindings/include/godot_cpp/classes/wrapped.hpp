// SPDX-License-Identifier: MIT
#pragma once

// The C++ side of an engine object, and the macros that make a class one.

#include <godot_cpp/core/binding_tables.hpp>
#include <godot_cpp/core/enum_info.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <type_traits>

namespace godot {

/// The C++ half of an object: it knows the engine's half, and nothing else.
///
/// Objects of engine classes get theirs when C++ meets them first; the engine deletes it together
/// with the object. Objects of an extension's classes have theirs from the start.
class Wrapped {
public:
	GDExtensionObjectPtr _owner = nullptr;

	Wrapped(const Wrapped &) = delete;
	Wrapped &operator=(const Wrapped &) = delete;
	virtual ~Wrapped() = default;

	void _notify(int, bool) {}
	void _notification(int) {}
	static void (Wrapped::*_get_notification())(int) { return &Wrapped::_notification; }

protected:
	/// Makes a new object of an engine class: the base of an extension's class that is being made.
	explicit Wrapped(const internal::EngineClass &p_class);
	/// Wraps an object that exists.
	explicit Wrapped(GDExtensionObjectPtr p_object) : _owner(p_object) {}

	template <class Class, class Base>
	static void register_virtuals() {}
};

namespace internal {

using Notification = void (Wrapped::*)(int);

extern GDExtensionClassLibraryPtr library;

/// Storage of a class name, without a destructor that would run after the engine's end.
class PermanentName {
public:
	explicit PermanentName(const char *p_name) { engine.string_name_new_with_latin1_chars(bytes, p_name, true); }
	const StringName &get() const { return *reinterpret_cast<const StringName *>(bytes); }

private:
	alignas(StringName) uint8_t bytes[sizeof(StringName)] = {};
};

inline GDExtensionConstObjectPtr owner(const Wrapped *p_object) {
	return p_object == nullptr ? nullptr : p_object->_owner;
}

/// The wrapper of an object, made for the nearest class of the bindings where there is none yet.
Wrapped *wrap_object(GDExtensionObjectPtr p_object, const EngineClass &p_fallback);

template <class T>
T *wrap(GDExtensionObjectPtr p_object) {
	return p_object == nullptr ? nullptr : static_cast<T *>(wrap_object(p_object, T::engine_class()));
}

/// The object in a Variant, or null.
Object *object_of_variant(const void *p_variant);

void destroy(Wrapped *p_object);

/// Lets the engine's virtual call a function of an extension's class.
template <class Class, class Function>
void add_virtual(const char *p_name, Function p_function);

template <class T>
T *singleton(const char *p_name) {
	const PermanentName name(p_name);
	return wrap<T>(engine.global_get_singleton(name.get().opaque));
}

/// How the engine makes and deletes wrappers of its own classes.
template <class T>
const GDExtensionInstanceBindingCallbacks *wrapper_callbacks() {
	static const GDExtensionInstanceBindingCallbacks callbacks = {
		[](void *, void *p_object) -> void * { return static_cast<Wrapped *>(new T(p_object)); },
		[](void *, void *, void *p_wrapper) { delete static_cast<Wrapped *>(p_wrapper); },
		[](void *, void *, GDExtensionBool) -> GDExtensionBool { return true; },
	};
	return &callbacks;
}

/// Gives the constructor of Wrapped which extension class is being made (null for engine classes),
/// so that the object is whole before the class's own constructor runs.
class ConstructionBase {
public:
	explicit ConstructionBase(const StringName *p_extension_class);
	/// Notifies a new object that it is complete.
	static void notify_created(Wrapped *p_object);
};

template <class T>
class Construction : ConstructionBase {
public:
	Construction() : ConstructionBase(extension_class()) {}

	T *operator<<(T *p_object) const {
		if constexpr (std::is_base_of_v<Wrapped, T>) {
			notify_created(p_object);
		}
		return p_object;
	}

private:
	static const StringName *extension_class() {
		if constexpr (std::is_base_of_v<Wrapped, T>) {
			return T::_is_extension_class ? &T::get_class_static() : nullptr;
		} else {
			return nullptr;
		}
	}
};

} // namespace internal

} // namespace godot

/// In a generated engine class.
#define GODOT_ENGINE_CLASS(m_class, m_parent) \
public: \
	static constexpr bool _is_extension_class = false; \
	static ::godot::internal::EngineClass &engine_class(); \
	static const ::godot::StringName &get_class_static() { \
		static const ::godot::internal::PermanentName name(#m_class); \
		return name.get(); \
	} \
	m_class() : m_class(engine_class()) {} \
	explicit m_class(GDExtensionObjectPtr p_object) : m_parent(p_object) {} \
	static void initialize_class() {} \
	static void _bind_methods() {} \
\
protected: \
	explicit m_class(const ::godot::internal::EngineClass &p_class) : m_parent(p_class) {} \
\
private:

/// At the top of every class of an extension.
#define GDCLASS(m_class, m_parent) \
public: \
	static constexpr bool _is_extension_class = true; \
	static const ::godot::StringName &get_class_static() { \
		static const ::godot::internal::PermanentName name(#m_class); \
		return name.get(); \
	} \
	static const ::godot::StringName &get_parent_class_static() { \
		return m_parent::get_class_static(); \
	} \
	static void initialize_class() { \
		if (&m_class::_bind_methods != &m_parent::_bind_methods) { \
			m_class::_bind_methods(); \
		} \
		m_parent::register_virtuals<m_class, m_parent>(); \
	} \
	static ::godot::internal::Notification _get_notification() { \
		return static_cast<::godot::internal::Notification>(&m_class::_notification); \
	} \
	/* Each class of the line hears of a notification once: parents first, or last on the way out. */ \
	void _notify(int p_what, bool p_reversed) { \
		if (!p_reversed) { \
			m_parent::_notify(p_what, p_reversed); \
		} \
		if (_get_notification() != m_parent::_get_notification()) { \
			m_class::_notification(p_what); \
		} \
		if (p_reversed) { \
			m_parent::_notify(p_what, p_reversed); \
		} \
	} \
	friend class ::godot::ClassDB; \
\
private:
