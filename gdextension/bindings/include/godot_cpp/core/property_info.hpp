// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/classes/global_constants.hpp>
#include <godot_cpp/classes/wrapped.hpp>

#include <vector>

namespace godot {

/// Describes a property, an argument or a result to the engine.
struct PropertyInfo {
	Variant::Type type = Variant::NIL;
	StringName name;
	StringName class_name;
	uint32_t hint = PROPERTY_HINT_NONE;
	String hint_string;
	uint32_t usage = PROPERTY_USAGE_DEFAULT;

	PropertyInfo() = default;
	PropertyInfo(Variant::Type p_type, const StringName &p_name, uint32_t p_hint = PROPERTY_HINT_NONE,
			const String &p_hint_string = String(), uint32_t p_usage = PROPERTY_USAGE_DEFAULT,
			const StringName &p_class_name = StringName()) :
			type(p_type),
			name(p_name),
			class_name(p_class_name),
			hint(p_hint),
			hint_string(p_hint_string),
			usage(p_usage) {}

	/// The engine's own notation; it points into this object.
	GDExtensionPropertyInfo to_engine() const;
};

/// Describes a signal.
struct MethodInfo {
	StringName name;
	std::vector<PropertyInfo> arguments;

	template <class... Arguments>
	explicit MethodInfo(const StringName &p_name, const Arguments &...p_arguments) :
			name(p_name), arguments{ p_arguments... } {}
};

namespace internal {

/// "ns::Class::Enum" -> "Class.Enum", as the engine names it; "Enum" of a name without a class.
String enum_class_name(const char *p_qualified_name);
/// "ns::Class::VALUE" -> "VALUE".
const char *last_part(const char *p_qualified_name);
String type_name(Variant::Type p_type);

template <class T>
struct TypedArrayElement {
	static constexpr bool is_typed = false;
};
template <class T>
struct TypedArrayElement<TypedArray<T>> {
	static constexpr bool is_typed = true;
	using Type = T;
};

/// Describes an argument or a result of the type T.
template <class T>
PropertyInfo describe_type() {
	PropertyInfo info;
	if constexpr (std::is_pointer_v<T>) {
		info.type = Variant::OBJECT;
		info.class_name = std::remove_cv_t<std::remove_pointer_t<T>>::get_class_static();
	} else if constexpr (HasPtr<T>::value && !is_builtin_v<T>) { // Ref<...>
		info.type = Variant::OBJECT;
		info.class_name = std::remove_pointer_t<decltype(std::declval<T>().ptr())>::get_class_static();
	} else {
		info.type = static_cast<Variant::Type>(Traits<T>::type);
	}
	if constexpr (std::is_same_v<T, Variant>) {
		info.usage |= PROPERTY_USAGE_NIL_IS_VARIANT;
	} else if constexpr (std::is_enum_v<T>) {
		if (EnumName<T>::value != nullptr) {
			info.usage |= PROPERTY_USAGE_CLASS_IS_ENUM;
			info.class_name = enum_class_name(EnumName<T>::value);
		}
	} else if constexpr (TypedArrayElement<T>::is_typed) {
		const PropertyInfo element = describe_type<typename TypedArrayElement<T>::Type>();
		info.hint = PROPERTY_HINT_ARRAY_TYPE;
		info.hint_string = element.type == Variant::OBJECT ? String(element.class_name) : type_name(element.type);
	}
	return info;
}

} // namespace internal

} // namespace godot
