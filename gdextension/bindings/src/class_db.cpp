// SPDX-License-Identifier: MIT
#include "internal.hpp"

#include <godot_cpp/core/class_db.hpp>

#include <array>
#include <string>
#include <unordered_map>

namespace godot {

namespace internal {

namespace {

constexpr int64_t MAX_ARGUMENTS = 32;

struct ExtensionClass {
	const StringName *name = nullptr;
	const ExtensionClass *parent = nullptr; // Null where the parent is one of the engine's.
	std::vector<std::unique_ptr<MethodBind>> methods;
	std::unordered_map<uint64_t, std::unique_ptr<VirtualCall>> virtuals;
};

// Unordered maps keep the addresses of their elements, which the engine holds.
std::unordered_map<uint64_t, ExtensionClass> &classes() {
	static std::unordered_map<uint64_t, ExtensionClass> table;
	return table;
}

std::vector<const StringName *> &registration_order() {
	static std::vector<const StringName *> names;
	return names;
}

bool fits(const Variant &p_value, Variant::Type p_type) {
	const Variant::Type type = p_value.get_type();
	return p_type == Variant::NIL || type == p_type ||
			engine.variant_can_convert_strict(
					static_cast<GDExtensionVariantType>(type), static_cast<GDExtensionVariantType>(p_type)) != 0;
}

/// Completes the arguments with defaults; false, with the error set, where they don't fit.
bool collect_arguments(const MethodBind &p_method, const GDExtensionConstVariantPtr *p_arguments, int64_t p_count,
		std::array<const Variant *, MAX_ARGUMENTS> &r_arguments, GDExtensionCallError &r_error) {
	const auto wanted = static_cast<int64_t>(p_method.arguments.size());
	const int64_t required = wanted - static_cast<int64_t>(p_method.defaults.size());
	if (p_count > wanted) {
		r_error = { GDEXTENSION_CALL_ERROR_TOO_MANY_ARGUMENTS, 0, static_cast<int32_t>(wanted) };
		return false;
	}
	if (p_count < required) {
		r_error = { GDEXTENSION_CALL_ERROR_TOO_FEW_ARGUMENTS, 0, static_cast<int32_t>(required) };
		return false;
	}
	for (int64_t i = 0; i < wanted; i++) {
		const auto index = static_cast<size_t>(i);
		r_arguments[index] = i < p_count ? static_cast<const Variant *>(p_arguments[i])
										 : &p_method.defaults[static_cast<size_t>(i - required)];
		const Variant::Type type = p_method.arguments[index].type;
		if (!fits(*r_arguments[index], type)) {
			r_error = { GDEXTENSION_CALL_ERROR_INVALID_ARGUMENT, static_cast<int32_t>(i), static_cast<int32_t>(type) };
			return false;
		}
	}
	return true;
}

void call_by_variant(void *p_method, GDExtensionClassInstancePtr p_self, const GDExtensionConstVariantPtr *p_arguments,
		GDExtensionInt p_count, GDExtensionVariantPtr r_result, GDExtensionCallError *r_error) {
	const auto &method = *static_cast<const MethodBind *>(p_method);
	std::array<const Variant *, MAX_ARGUMENTS> arguments = {};
	if (!collect_arguments(method, p_arguments, p_count, arguments, *r_error)) {
		return;
	}
	Variant result;
	method.call_variant(p_self, arguments.data(), result);
	if (method.has_result) {
		engine.variant_new_copy(r_result, result.opaque);
	}
	r_error->error = GDEXTENSION_CALL_OK;
}

void call_by_pointer(void *p_method, GDExtensionClassInstancePtr p_self, const GDExtensionConstTypePtr *p_arguments,
		GDExtensionTypePtr r_result) {
	static_cast<const MethodBind *>(p_method)->call_ptr(p_self, p_arguments, r_result);
}

void free_instance(void *, GDExtensionClassInstancePtr p_self) {
	delete static_cast<Wrapped *>(p_self);
}

void *find_virtual(void *p_class, GDExtensionConstStringNamePtr p_name, uint32_t) {
	const uint64_t key = key_of(p_name);
	for (const auto *link = static_cast<const ExtensionClass *>(p_class); link != nullptr; link = link->parent) {
		const auto found = link->virtuals.find(key);
		if (found != link->virtuals.end()) {
			return found->second.get();
		}
	}
	return nullptr;
}

void call_virtual(GDExtensionClassInstancePtr p_self, GDExtensionConstStringNamePtr, void *p_call,
		const GDExtensionConstTypePtr *p_arguments, GDExtensionTypePtr r_result) {
	static_cast<VirtualCall *>(p_call)->call(static_cast<Wrapped *>(p_self), p_arguments, r_result);
}

uint32_t flags_of(const MethodBind &p_method) {
	uint32_t flags = GDEXTENSION_METHOD_FLAG_NORMAL;
	if (p_method.is_const) {
		flags |= GDEXTENSION_METHOD_FLAG_CONST;
	}
	if (p_method.is_static) {
		flags |= GDEXTENSION_METHOD_FLAG_STATIC;
	}
	return flags;
}

} // namespace

void add_virtual(const StringName &p_class, const char *p_name, VirtualCall *p_call) {
	// The key stands for an interned name, so the name must live on: release templates would
	// otherwise free it, and intern it anew under another key.
	classes()[key_of(p_class)].virtuals[key_of(permanent_name(p_name))].reset(p_call);
}

void add_method(const StringName &p_class, std::unique_ptr<MethodBind> p_method) {
	MethodBind &method = *p_method;
	ERR_FAIL_COND_MSG(method.arguments.size() > MAX_ARGUMENTS || method.defaults.size() > method.arguments.size() ||
					method.definition.arguments.size() != method.arguments.size(),
			String(p_class) + "." + String(method.definition.name) +
					": D_METHOD must name every argument, and there can't be more defaults than arguments.");
	std::vector<GDExtensionPropertyInfo> arguments;
	arguments.reserve(method.arguments.size());
	for (size_t i = 0; i < method.arguments.size(); i++) {
		method.arguments[i].name = method.definition.arguments[i];
		arguments.push_back(method.arguments[i].to_engine());
	}
	std::vector<GDExtensionClassMethodArgumentMetadata> metadata(
			method.arguments.size(), GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE);
	std::vector<GDExtensionVariantPtr> defaults;
	defaults.reserve(method.defaults.size());
	for (Variant &value : method.defaults) {
		defaults.push_back(value.opaque);
	}
	GDExtensionPropertyInfo result = method.result.to_engine();
	GDExtensionClassMethodInfo info = {};
	info.name = method.definition.name.opaque;
	info.method_userdata = &method;
	info.call_func = call_by_variant;
	info.ptrcall_func = call_by_pointer;
	info.method_flags = flags_of(method);
	info.has_return_value = method.has_result ? 1 : 0;
	info.return_value_info = &result;
	info.return_value_metadata = GDEXTENSION_METHOD_ARGUMENT_METADATA_NONE;
	info.argument_count = static_cast<uint32_t>(arguments.size());
	info.arguments_info = arguments.data();
	info.arguments_metadata = metadata.data();
	info.default_argument_count = static_cast<uint32_t>(defaults.size());
	info.default_arguments = defaults.data();
	engine.classdb_register_extension_class_method(library, p_class.opaque, &info);
	classes()[key_of(p_class)].methods.push_back(std::move(p_method));
}

void register_class(const ClassInfo &p_info) {
	const auto parent = classes().find(key_of(*p_info.parent));
	const ExtensionClass *parent_class = parent != classes().end() ? &parent->second : nullptr;
	ExtensionClass &registered = classes()[key_of(*p_info.name)];
	registered.name = p_info.name;
	registered.parent = parent_class;
	GDExtensionClassCreationInfo5 info = {};
	info.is_virtual = p_info.is_virtual ? 1 : 0;
	info.is_abstract = p_info.is_abstract ? 1 : 0;
	info.is_exposed = 1;
	info.create_instance_func = p_info.create;
	info.free_instance_func = free_instance;
	info.notification_func = p_info.notification;
	info.get_virtual_call_data_func = find_virtual;
	info.call_virtual_with_data_func = call_virtual;
	info.class_userdata = &registered;
	engine.classdb_register_extension_class5(library, p_info.name->opaque, p_info.parent->opaque, &info);
	registration_order().push_back(p_info.name);
	p_info.initialize();
}

void unregister_classes() {
	std::vector<const StringName *> &names = registration_order();
	for (auto name = names.rbegin(); name != names.rend(); ++name) {
		engine.classdb_unregister_extension_class(library, (*name)->opaque);
	}
	names.clear();
	classes().clear();
}

String enum_class_name(const char *p_qualified_name) {
	const std::string name(p_qualified_name);
	const size_t last = name.rfind("::");
	if (last == std::string::npos) {
		return String(p_qualified_name);
	}
	const size_t previous = name.rfind("::", last - 1);
	const size_t start = previous == std::string::npos ? 0 : previous + 2;
	return String((name.substr(start, last - start) + "." + name.substr(last + 2)).c_str());
}

const char *last_part(const char *p_qualified_name) {
	const char *colon = std::strrchr(p_qualified_name, ':');
	return colon != nullptr ? colon + 1 : p_qualified_name;
}

String type_name(Variant::Type p_type) {
	String result;
	engine.variant_get_type_name(static_cast<GDExtensionVariantType>(p_type), result.opaque);
	return result;
}

} // namespace internal

GDExtensionPropertyInfo PropertyInfo::to_engine() const {
	GDExtensionPropertyInfo info = {};
	info.type = static_cast<GDExtensionVariantType>(type);
	info.name = const_cast<uint8_t *>(name.opaque);
	info.class_name = const_cast<uint8_t *>(class_name.opaque);
	info.hint = hint;
	info.hint_string = const_cast<uint8_t *>(hint_string.opaque);
	info.usage = usage;
	return info;
}

void ClassDB::add_property(const StringName &p_class, const PropertyInfo &p_property, const StringName &p_setter,
		const StringName &p_getter) {
	const GDExtensionPropertyInfo info = p_property.to_engine();
	internal::engine.classdb_register_extension_class_property(
			internal::library, p_class.opaque, &info, p_setter.opaque, p_getter.opaque);
}

void ClassDB::add_signal(const StringName &p_class, const MethodInfo &p_signal) {
	std::vector<GDExtensionPropertyInfo> arguments;
	arguments.reserve(p_signal.arguments.size());
	for (const PropertyInfo &argument : p_signal.arguments) {
		arguments.push_back(argument.to_engine());
	}
	internal::engine.classdb_register_extension_class_signal(internal::library, p_class.opaque, p_signal.name.opaque,
			arguments.data(), static_cast<GDExtensionInt>(arguments.size()));
}

void ClassDB::bind_integer_constant(
		const StringName &p_class, const StringName &p_enum, const StringName &p_name, int64_t p_value) {
	internal::engine.classdb_register_extension_class_integer_constant(
			internal::library, p_class.opaque, p_enum.opaque, p_name.opaque, p_value, 0);
}

} // namespace godot
