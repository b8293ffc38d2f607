// SPDX-License-Identifier: MIT
#pragma once

// How the C++ types of bound signatures look from the engine, and how their values cross over:
// by pointer (typed calls, virtuals) or in a Variant (dynamic calls).

#include <godot_cpp/classes/wrapped.hpp>
#include <godot_cpp/core/enum_info.hpp>
#include <godot_cpp/core/property_info.hpp>

#include <string>

namespace godot {

/// The type of a parameter or result, without reference and const.
template <class T, class = void>
struct TypeInfo;

namespace internal {

/// `game::Motor::Mode` -> `Motor.Mode`; `Error` -> `Error`.
std::string enum_class_name(const char *p_qualified_name);
/// `game::Motor::Mode` -> `Mode`.
const char *enum_short_name(const char *p_qualified_name);

template <class T>
constexpr GDExtensionClassMethodArgumentMetadata number_metadata() {
	if constexpr (std::is_same_v<T, float>) {
		return GDEXTENSION_METHOD_ARGUMENT_METADATA_REAL_IS_FLOAT;
	} else if constexpr (std::is_same_v<T, double>) {
		return GDEXTENSION_METHOD_ARGUMENT_METADATA_REAL_IS_DOUBLE;
	} else if constexpr (std::is_integral_v<T> && !std::is_same_v<T, bool>) {
		constexpr int first = std::is_signed_v<T> ? GDEXTENSION_METHOD_ARGUMENT_METADATA_INT_IS_INT8
												  : GDEXTENSION_METHOD_ARGUMENT_METADATA_INT_IS_UINT8;
		constexpr int size = sizeof(T) == 1 ? 0 : sizeof(T) == 2 ? 1 : sizeof(T) == 4 ? 2 : 3;
		return GDExtensionClassMethodArgumentMetadata(first + size);
	} else {
		return GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE;
	}
}

} // namespace internal

/// Builtin types cross as they are.
template <class T>
struct TypeInfo<T, std::enable_if_t<is_builtin_v<T>>> {
	static constexpr GDExtensionVariantType type = BuiltinType<T>::type;
	static constexpr GDExtensionClassMethodArgumentMetadata metadata = GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE;
	static StringName class_name() { return StringName(); }
	static PropertyInfo property() { return PropertyInfo(Variant::Type(type), ""); }
	static const T &from_pointer(const void *p_value) { return *static_cast<const T *>(p_value); }
	static void to_pointer(const T &p_value, void *r_value) { *static_cast<T *>(r_value) = p_value; }
	static T from_variant(const Variant &p_value) { return p_value.operator T(); }
};

template <>
struct TypeInfo<Variant> {
	static constexpr GDExtensionVariantType type = GDEXTENSION_VARIANT_TYPE_NIL;
	static constexpr GDExtensionClassMethodArgumentMetadata metadata = GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE;
	static StringName class_name() { return StringName(); }
	static PropertyInfo property() {
		const uint32_t usage = PROPERTY_USAGE_DEFAULT | PROPERTY_USAGE_NIL_IS_VARIANT;
		return PropertyInfo(Variant::NIL, "", PROPERTY_HINT_NONE, "", usage);
	}
	static const Variant &from_pointer(const void *p_value) { return *static_cast<const Variant *>(p_value); }
	static void to_pointer(const Variant &p_value, void *r_value) { *static_cast<Variant *>(r_value) = p_value; }
	static const Variant &from_variant(const Variant &p_value) { return p_value; }
};

/// Numbers cross as the widest of their kind.
template <class T>
struct TypeInfo<T, std::enable_if_t<std::is_arithmetic_v<T>>> {
	static constexpr bool is_bool = std::is_same_v<T, bool>;
	static constexpr bool is_real = std::is_floating_point_v<T>;
	using Wide = std::conditional_t<is_bool, GDExtensionBool, std::conditional_t<is_real, double, int64_t>>;
	static constexpr GDExtensionVariantType type = is_bool ? GDEXTENSION_VARIANT_TYPE_BOOL
			: is_real									   ? GDEXTENSION_VARIANT_TYPE_FLOAT
														   : GDEXTENSION_VARIANT_TYPE_INT;
	static constexpr GDExtensionClassMethodArgumentMetadata metadata = internal::number_metadata<T>();
	static StringName class_name() { return StringName(); }
	static PropertyInfo property() { return PropertyInfo(Variant::Type(type), ""); }
	static T from_pointer(const void *p_value) { return static_cast<T>(*static_cast<const Wide *>(p_value)); }
	static void to_pointer(T p_value, void *r_value) { *static_cast<Wide *>(r_value) = static_cast<Wide>(p_value); }
	static T from_variant(const Variant &p_value) {
		using Source = std::conditional_t<is_bool, bool, Wide>;
		return static_cast<T>(p_value.operator Source());
	}
};

/// Enums cross as integers that know their name.
template <class T>
struct TypeInfo<T, std::enable_if_t<std::is_enum_v<T>>> {
	static constexpr GDExtensionVariantType type = GDEXTENSION_VARIANT_TYPE_INT;
	static constexpr GDExtensionClassMethodArgumentMetadata metadata = GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE;
	static StringName class_name() { return internal::enum_class_name(EnumInfo<T>::name).c_str(); }
	static PropertyInfo property() {
		const uint32_t kind =
				EnumInfo<T>::is_bitfield ? PROPERTY_USAGE_CLASS_IS_BITFIELD : PROPERTY_USAGE_CLASS_IS_ENUM;
		const uint32_t usage = PROPERTY_USAGE_DEFAULT | kind;
		return PropertyInfo(Variant::INT, "", PROPERTY_HINT_NONE, "", usage, class_name());
	}
	static T from_pointer(const void *p_value) { return T(*static_cast<const int64_t *>(p_value)); }
	static void to_pointer(T p_value, void *r_value) { *static_cast<int64_t *>(r_value) = int64_t(p_value); }
	static T from_variant(const Variant &p_value) { return T(p_value.operator int64_t()); }
};

template <class T>
struct TypeInfo<BitField<T>> : TypeInfo<T> {
	static BitField<T> from_pointer(const void *p_value) { return *static_cast<const int64_t *>(p_value); }
	static void to_pointer(BitField<T> p_value, void *r_value) { *static_cast<int64_t *>(r_value) = p_value; }
	static BitField<T> from_variant(const Variant &p_value) { return p_value.operator int64_t(); }
};

/// Objects cross as the engine's pointer. An object of another class arrives as null.
template <class T>
struct TypeInfo<T *, std::enable_if_t<std::is_base_of_v<Wrapped, T>>> {
	static constexpr GDExtensionVariantType type = GDEXTENSION_VARIANT_TYPE_OBJECT;
	static constexpr GDExtensionClassMethodArgumentMetadata metadata = GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE;
	static StringName class_name() { return T::get_class_static(); }
	static PropertyInfo property() {
		return PropertyInfo(Variant::OBJECT, "", PROPERTY_HINT_NONE, "", PROPERTY_USAGE_DEFAULT, class_name());
	}
	static T *from_pointer(const void *p_value) {
		return internal::wrap<std::remove_const_t<T>>(*static_cast<GDExtensionObjectPtr const *>(p_value));
	}
	static void to_pointer(const T *p_value, void *r_value) {
		*static_cast<GDExtensionObjectPtr *>(r_value) = const_cast<GDExtensionObjectPtr>(internal::owner(p_value));
	}
	static T *from_variant(const Variant &p_value) {
		return dynamic_cast<T *>(internal::object_of_variant(p_value.opaque));
	}
};

/// Pointers to memory and to native structures cross as they are, in virtuals alone.
template <class T>
struct TypeInfo<T *, std::enable_if_t<std::is_void_v<T> || (std::is_class_v<T> && !std::is_base_of_v<Wrapped, T>)>> {
	static T *from_pointer(const void *p_value) { return *static_cast<T *const *>(p_value); }
};

/// References cross in the engine's own holder.
template <class T>
struct TypeInfo<Ref<T>> : TypeInfo<T *> {
	static Ref<T> from_pointer(const void *p_value) {
		GDExtensionConstRefPtr reference = const_cast<GDExtensionConstRefPtr>(p_value);
		return Ref<T>(reference == nullptr ? nullptr : internal::wrap<T>(internal::engine.ref_get_object(reference)));
	}
	static void to_pointer(const Ref<T> &p_value, void *r_value) {
		GDExtensionConstObjectPtr object = internal::owner(p_value.ptr());
		internal::engine.ref_set_object(r_value, const_cast<GDExtensionObjectPtr>(object));
	}
	static Ref<T> from_variant(const Variant &p_value) { return Ref<T>(TypeInfo<T *>::from_variant(p_value)); }
};

} // namespace godot
