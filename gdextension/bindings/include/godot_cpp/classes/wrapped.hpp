// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/variant/variant.hpp>

#include <tuple>

namespace godot {

class Wrapped;

namespace internal {

extern GDExtensionClassLibraryPtr library;

/// An interned name that is never freed: it must outlive the destructors of static objects.
const StringName &permanent_name(const char *p_name);

/// Announces an engine class, before the engine's functions are known.
void add_engine_class(const char *p_name, const GDExtensionInstanceBindingCallbacks *p_callbacks);

template <class T>
struct EngineClass {
	EngineClass() { add_engine_class(T::class_name_cstr(), T::callbacks()); }
};

} // namespace internal

/// The C++ half of an engine object. It holds the engine's pointer and nothing else.
class Wrapped {
public:
	virtual ~Wrapped() = default;
	Wrapped(const Wrapped &) = delete;
	Wrapped &operator=(const Wrapped &) = delete;

	/// The name of an extension's own class; null for one of the engine's.
	virtual const StringName *_extension_class() const { return nullptr; }
	virtual const GDExtensionInstanceBindingCallbacks *_callbacks() const { return nullptr; }
	void _notificationv(int32_t, bool) {}

	/// Tells the engine that this is the C++ half of the object that it constructed.
	void _attach();

	GDExtensionObjectPtr _owner = nullptr; // Public as in godot-cpp.

protected:
	explicit Wrapped(const StringName &p_engine_class) :
			_owner(internal::engine.classdb_construct_object2(p_engine_class.opaque)) {}
	explicit Wrapped(GDExtensionObjectPtr p_owner) : _owner(p_owner) {}
};

namespace internal {

/// The C++ half of an engine object, made if there is none yet.
Wrapped *find_or_wrap(GDExtensionObjectPtr p_object, const GDExtensionInstanceBindingCallbacks *p_fallback);

template <class T>
T *wrap(GDExtensionObjectPtr p_object) {
	return p_object != nullptr ? static_cast<T *>(find_or_wrap(p_object, T::callbacks())) : nullptr;
}

template <class T>
T *singleton(const char *p_name) {
	return wrap<T>(engine.global_get_singleton(permanent_name(p_name).opaque));
}

/// A method of the engine; null (after an error message) where the engine lacks it.
GDExtensionMethodBindPtr method_bind(const char *p_class, const char *p_method, int64_t p_hash);

Variant varcall(
		GDExtensionMethodBindPtr p_method, GDExtensionObjectPtr p_object, const Variant **p_arguments, int64_t p_count);

template <class T>
struct PtrResult<T *> {
	GDExtensionObjectPtr object = nullptr;
	void *get() { return &object; }
	T *take() { return wrap<T>(object); }
};
template <class T>
struct PtrResult<Ref<T>> {
	GDExtensionObjectPtr object = nullptr;
	void *get() { return &object; }
	Ref<T> take() { return Ref<T>::adopt(wrap<T>(object)); } // The engine hands over one reference.
};

template <class R, class... Arguments>
R ptrcall(GDExtensionMethodBindPtr p_method, GDExtensionObjectPtr p_object, const Arguments &...p_arguments) {
	if (p_method == nullptr) {
		return R(); // Reported when it was looked up.
	}
	return with_addresses(
			[&](const void **p_addresses) -> R {
				if constexpr (std::is_void_v<R>) {
					engine.object_method_bind_ptrcall(p_method, p_object, p_addresses, nullptr);
				} else {
					PtrResult<R> result;
					engine.object_method_bind_ptrcall(p_method, p_object, p_addresses, result.get());
					return result.take();
				}
			},
			PtrArgument<Arguments>(p_arguments)...);
}

} // namespace internal

} // namespace godot

#include <godot_cpp/core/type_traits.hpp>
#include <godot_cpp/core/virtual_call.hpp>

// The part that every engine class has in common.
#define GDENGINE_CLASS(m_class, m_parent) \
public: \
	static const char *class_name_cstr() { \
		return #m_class; \
	} \
	static const ::godot::StringName &get_class_static() { \
		static const ::godot::StringName &name = ::godot::internal::permanent_name(#m_class); \
		return name; \
	} \
	static const GDExtensionInstanceBindingCallbacks *callbacks() { \
		static const GDExtensionInstanceBindingCallbacks table = { \
			[](void *, void *p_object) -> void * { return static_cast<::godot::Wrapped *>(new m_class(p_object)); }, \
			[](void *, void *, void *p_binding) { delete static_cast<::godot::Wrapped *>(p_binding); }, \
			[](void *, void *, GDExtensionBool) -> GDExtensionBool { return true; }, \
		}; \
		return &table; \
	} \
	const GDExtensionInstanceBindingCallbacks *_callbacks() const override { \
		return callbacks(); \
	} \
	m_class() : m_class(get_class_static()) {} \
	explicit m_class(GDExtensionObjectPtr p_owner) : m_parent(p_owner) {} \
	static auto _get_notification() { \
		return static_cast<void (::godot::Wrapped::*)(int)>(&m_class::_notification); \
	} \
	static void initialize_class() {} \
	static void _bind_methods() {} \
\
protected: \
	explicit m_class(const ::godot::StringName &p_engine_class) : m_parent(p_engine_class) {} \
	void _notification(int) {} \
\
private:
