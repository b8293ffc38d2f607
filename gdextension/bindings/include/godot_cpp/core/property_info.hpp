// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/variant/variant.hpp>

#include <vector>

namespace godot {

/// What the engine wants to know of a property, an argument or a result.
struct PropertyInfo {
	Variant::Type type = Variant::NIL;
	StringName name;
	StringName class_name;
	uint32_t hint = PROPERTY_HINT_NONE;
	String hint_string;
	uint32_t usage = PROPERTY_USAGE_DEFAULT;

	PropertyInfo() = default;
	PropertyInfo(Variant::Type p_type, const StringName &p_name, PropertyHint p_hint = PROPERTY_HINT_NONE,
			const String &p_hint_string = "", uint32_t p_usage = PROPERTY_USAGE_DEFAULT,
			const StringName &p_class_name = "") :
			type(p_type),
			name(p_name),
			class_name(p_class_name),
			hint(p_hint),
			hint_string(p_hint_string),
			usage(p_usage) {}

	/// For the engine, valid as long as this object.
	GDExtensionPropertyInfo raw() {
		return { GDExtensionVariantType(type), name.opaque, class_name.opaque, hint, hint_string.opaque, usage };
	}
};

/// A signal.
struct MethodInfo {
	StringName name;
	std::vector<PropertyInfo> arguments;

	MethodInfo() = default;
	template <class... Arguments>
	MethodInfo(const StringName &p_name, const Arguments &...p_arguments) :
			name(p_name), arguments{ PropertyInfo(p_arguments)... } {}
};

} // namespace godot
