// SPDX-License-Identifier: MIT
#pragma once

// What the engine must know of the C++ types in a bound signature, and how values of them cross in
// both styles of call: by pointer (typed code) and by Variant.
#include <godot_cpp/classes/wrapped.hpp>

namespace godot::internal {

/// The name of a bound enum; null unless VARIANT_ENUM_CAST has named it.
template <class E>
struct EnumName {
	static constexpr const char *value = nullptr;
};

template <class T, class = void>
struct Traits;

template <class T>
struct Traits<T, std::enable_if_t<is_builtin_v<T>>> {
	static constexpr GDExtensionVariantType type = BuiltinType<T>::value;
	static const T &from_ptr(const void *p_value) { return *static_cast<const T *>(p_value); }
	static void to_ptr(const T &p_value, void *r_result) { *static_cast<T *>(r_result) = p_value; }
	static T from_variant(const Variant &p_value) { return p_value; }
};

template <>
struct Traits<Variant> {
	static constexpr GDExtensionVariantType type = GDEXTENSION_VARIANT_TYPE_NIL;
	static const Variant &from_ptr(const void *p_value) { return *static_cast<const Variant *>(p_value); }
	static void to_ptr(const Variant &p_value, void *r_result) { *static_cast<Variant *>(r_result) = p_value; }
	static const Variant &from_variant(const Variant &p_value) { return p_value; }
};

template <>
struct Traits<bool> {
	static constexpr GDExtensionVariantType type = GDEXTENSION_VARIANT_TYPE_BOOL;
	static bool from_ptr(const void *p_value) { return *static_cast<const uint8_t *>(p_value) != 0; }
	static void to_ptr(bool p_value, void *r_result) { *static_cast<uint8_t *>(r_result) = p_value ? 1 : 0; }
	static bool from_variant(const Variant &p_value) { return p_value; }
};

template <class T>
struct Traits<T, std::enable_if_t<std::is_integral_v<T> || std::is_enum_v<T>>> {
	static constexpr GDExtensionVariantType type = GDEXTENSION_VARIANT_TYPE_INT;
	static T from_ptr(const void *p_value) { return static_cast<T>(*static_cast<const int64_t *>(p_value)); }
	static void to_ptr(T p_value, void *r_result) { *static_cast<int64_t *>(r_result) = static_cast<int64_t>(p_value); }
	static T from_variant(const Variant &p_value) { return static_cast<T>(p_value.operator int64_t()); }
};

template <class T>
struct Traits<T, std::enable_if_t<std::is_floating_point_v<T>>> {
	static constexpr GDExtensionVariantType type = GDEXTENSION_VARIANT_TYPE_FLOAT;
	static T from_ptr(const void *p_value) { return static_cast<T>(*static_cast<const double *>(p_value)); }
	static void to_ptr(T p_value, void *r_result) { *static_cast<double *>(r_result) = static_cast<double>(p_value); }
	static T from_variant(const Variant &p_value) { return static_cast<T>(p_value.operator double()); }
};

// Not inline, because Object is incomplete here.
Wrapped *wrapped_from_variant(const Variant &p_value);

/// The object in a Variant, or null where it is of another class.
template <class T>
T *object_from_variant(const Variant &p_value) {
	return dynamic_cast<T *>(wrapped_from_variant(p_value));
}

template <class T>
struct Traits<T *, std::enable_if_t<std::is_base_of_v<Wrapped, T>>> {
	static constexpr GDExtensionVariantType type = GDEXTENSION_VARIANT_TYPE_OBJECT;
	static T *from_ptr(const void *p_value) { return wrap<T>(*static_cast<GDExtensionObjectPtr const *>(p_value)); }
	static void to_ptr(const T *p_value, void *r_result) {
		*static_cast<GDExtensionObjectPtr *>(r_result) = p_value != nullptr ? p_value->_owner : nullptr;
	}
	static T *from_variant(const Variant &p_value) { return object_from_variant<T>(p_value); }
};

template <class T>
struct Traits<Ref<T>> {
	static constexpr GDExtensionVariantType type = GDEXTENSION_VARIANT_TYPE_OBJECT;
	static Ref<T> from_ptr(const void *p_value) {
		return Ref<T>(p_value != nullptr ? wrap<T>(engine.ref_get_object(p_value)) : nullptr);
	}
	static void to_ptr(const Ref<T> &p_value, void *r_result) {
		engine.ref_set_object(r_result, p_value.is_valid() ? p_value->_owner : nullptr);
	}
	static Ref<T> from_variant(const Variant &p_value) { return Ref<T>(object_from_variant<T>(p_value)); }
};

} // namespace godot::internal
