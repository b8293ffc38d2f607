// SPDX-License-Identifier: MIT
#include <godot_cpp/core/method_bind.hpp>

namespace godot::internal {

namespace {

constexpr int64_t MAX_ARGUMENTS = 32;

/// Whether a dynamic argument fits; `null` fits every object.
bool fits(const Variant &p_value, const PropertyInfo &p_property) {
	const Variant::Type type = p_value.get_type();
	return p_property.type == Variant::NIL || type == p_property.type ||
			Variant::can_convert_strict(type, p_property.type);
}

} // namespace

void BoundMethod::call_checked(Wrapped *p_self, const GDExtensionConstVariantPtr *p_arguments, int64_t p_count,
		GDExtensionVariantPtr r_result, GDExtensionCallError *r_error) const {
	const int64_t wanted = argument_count();
	const int64_t first_default = wanted - int64_t(defaults.size());
	if (p_count > wanted) {
		*r_error = { GDEXTENSION_CALL_ERROR_TOO_MANY_ARGUMENTS, 0, int32_t(wanted) };
		return;
	}
	if (p_count < first_default) {
		*r_error = { GDEXTENSION_CALL_ERROR_TOO_FEW_ARGUMENTS, 0, int32_t(first_default) };
		return;
	}
	const Variant *arguments[MAX_ARGUMENTS];
	for (int64_t i = 0; i < wanted; i++) {
		arguments[i] =
				i < p_count ? static_cast<const Variant *>(p_arguments[i]) : &defaults[std::size_t(i - first_default)];
		const PropertyInfo &property = properties[std::size_t(i) + 1];
		if (!fits(*arguments[i], property)) {
			*r_error = { GDEXTENSION_CALL_ERROR_INVALID_ARGUMENT, int32_t(i), int32_t(property.type) };
			return;
		}
	}
	Variant result;
	call_with_variants(p_self, arguments, result);
	if (has_result) {
		engine.variant_new_copy(r_result, result.opaque);
	}
	r_error->error = GDEXTENSION_CALL_OK;
}

std::string enum_class_name(const char *p_qualified_name) {
	std::string name(p_qualified_name);
	const std::size_t enum_start = name.rfind("::");
	if (enum_start == std::string::npos) {
		return name;
	}
	// Only the class counts: namespaces around it are C++'s own.
	const std::size_t class_end = name.rfind("::", enum_start - 1);
	const std::size_t class_start = class_end == std::string::npos || enum_start == 0 ? 0 : class_end + 2;
	return name.substr(class_start, enum_start - class_start) + "." + name.substr(enum_start + 2);
}

const char *enum_short_name(const char *p_qualified_name) {
	const std::string name(p_qualified_name);
	const std::size_t separator = name.rfind("::");
	return separator == std::string::npos ? p_qualified_name : p_qualified_name + separator + 2;
}

} // namespace godot::internal
