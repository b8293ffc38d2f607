// SPDX-License-Identifier: MIT
#include <godot_cpp/core/class_db.hpp>

#include <cstring>
#include <unordered_map>

namespace godot {

namespace internal {

namespace {

/// Equal names share their data in the engine, so that its address stands for the name. Whoever
/// looks a name up must keep it alive: another text could get the address of a freed one.
struct NameHash {
	std::size_t operator()(const StringName &p_name) const {
		std::size_t address = 0;
		std::memcpy(&address, p_name.opaque, sizeof(address));
		return address;
	}
};

/// A registered class.
struct ClassRecord {
	const StringName *name = nullptr;
	const ClassRecord *parent = nullptr; // Null where the parent is an engine class.
	std::vector<std::unique_ptr<BoundMethod>> methods;
	std::unordered_map<StringName, std::unique_ptr<VirtualMethod>, NameHash> virtuals;
};

/// In order of registration, parents before children.
std::vector<std::unique_ptr<ClassRecord>> records;

ClassRecord *find_record(const StringName &p_class) {
	for (const std::unique_ptr<ClassRecord> &record : records) {
		if (*record->name == p_class) {
			return record.get();
		}
	}
	return nullptr;
}

void *get_virtual(void *p_record, GDExtensionConstStringNamePtr p_name, uint32_t) {
	const StringName &name = *static_cast<const StringName *>(p_name);
	for (const ClassRecord *record = static_cast<ClassRecord *>(p_record); record; record = record->parent) {
		const auto found = record->virtuals.find(name);
		if (found != record->virtuals.end()) {
			return found->second.get();
		}
	}
	return nullptr;
}

void call_virtual(void *p_self, GDExtensionConstStringNamePtr, void *p_method,
		const GDExtensionConstTypePtr *p_arguments, GDExtensionTypePtr r_result) {
	static_cast<const VirtualMethod *>(p_method)->call(static_cast<Wrapped *>(p_self), p_arguments, r_result);
}

void call_method(void *p_method, void *p_self, const GDExtensionConstVariantPtr *p_arguments, GDExtensionInt p_count,
		GDExtensionVariantPtr r_result, GDExtensionCallError *r_error) {
	const BoundMethod *method = static_cast<const BoundMethod *>(p_method);
	method->call_checked(static_cast<Wrapped *>(p_self), p_arguments, p_count, r_result, r_error);
}

void ptrcall_method(
		void *p_method, void *p_self, const GDExtensionConstTypePtr *p_arguments, GDExtensionTypePtr r_result) {
	const BoundMethod *method = static_cast<const BoundMethod *>(p_method);
	method->call_with_pointers(static_cast<Wrapped *>(p_self), p_arguments, r_result);
}

void free_instance(void *, void *p_self) {
	delete static_cast<Wrapped *>(p_self);
}

} // namespace

void register_class(const ClassDescription &p_description) {
	auto record = std::make_unique<ClassRecord>();
	record->name = &p_description.name;
	record->parent = find_record(p_description.parent);
	GDExtensionClassCreationInfo5 info = {};
	info.is_virtual = p_description.is_virtual;
	info.is_abstract = p_description.create == nullptr;
	info.is_exposed = p_description.is_exposed;
	info.is_runtime = p_description.is_runtime;
	info.create_instance_func = p_description.create;
	info.free_instance_func = free_instance;
	info.notification_func = p_description.notify;
	info.get_virtual_call_data_func = get_virtual;
	info.call_virtual_with_data_func = call_virtual;
	info.class_userdata = record.get();
	engine.classdb_register_extension_class5(library, p_description.name.opaque, p_description.parent.opaque, &info);
	records.push_back(std::move(record));
	p_description.bind_members();
}

void unregister_classes() {
	while (!records.empty()) {
		engine.classdb_unregister_extension_class(library, records.back()->name->opaque);
		records.pop_back();
	}
}

void add_method(const StringName &p_class, std::unique_ptr<BoundMethod> p_method) {
	ClassRecord *record = find_record(p_class);
	ERR_FAIL_NULL_MSG(record, "A method was bound to a class that is not being registered.");
	BoundMethod &method = *p_method;
	const std::size_t count = std::size_t(method.argument_count());
	for (std::size_t i = 0; i < count && i < method.definition.arguments.size(); i++) {
		method.properties[i + 1].name = method.definition.arguments[i];
	}
	std::vector<GDExtensionPropertyInfo> properties;
	properties.reserve(method.properties.size());
	for (PropertyInfo &property : method.properties) {
		properties.push_back(property.raw());
	}
	std::vector<GDExtensionVariantPtr> defaults;
	defaults.reserve(method.defaults.size());
	for (Variant &value : method.defaults) {
		defaults.push_back(value.opaque);
	}
	GDExtensionClassMethodInfo info = {};
	info.name = method.definition.name.opaque;
	info.method_userdata = &method;
	info.call_func = call_method;
	info.ptrcall_func = ptrcall_method;
	info.method_flags = method.flags;
	info.has_return_value = method.has_result;
	info.return_value_info = properties.data();
	info.return_value_metadata = method.metadata[0];
	info.argument_count = uint32_t(count);
	info.arguments_info = properties.data() + 1;
	info.arguments_metadata = method.metadata.data() + 1;
	info.default_argument_count = uint32_t(defaults.size());
	info.default_arguments = defaults.data();
	engine.classdb_register_extension_class_method(library, p_class.opaque, &info);
	record->methods.push_back(std::move(p_method));
}

void add_virtual_method(const StringName &p_class, const char *p_name, std::unique_ptr<VirtualMethod> p_method) {
	ClassRecord *record = find_record(p_class);
	ERR_FAIL_NULL_MSG(record, "A virtual was bound to a class that is not being registered.");
	record->virtuals[StringName(p_name)] = std::move(p_method);
}

} // namespace internal

void ClassDB::add_property(const StringName &p_class, const PropertyInfo &p_property, const StringName &p_setter,
		const StringName &p_getter, int p_index) {
	PropertyInfo property = p_property;
	const GDExtensionPropertyInfo info = property.raw();
	internal::engine.classdb_register_extension_class_property_indexed(
			internal::library, p_class.opaque, &info, p_setter.opaque, p_getter.opaque, p_index);
}

void ClassDB::add_property_group(const StringName &p_class, const String &p_name, const String &p_prefix) {
	internal::engine.classdb_register_extension_class_property_group(
			internal::library, p_class.opaque, p_name.opaque, p_prefix.opaque);
}

void ClassDB::add_property_subgroup(const StringName &p_class, const String &p_name, const String &p_prefix) {
	internal::engine.classdb_register_extension_class_property_subgroup(
			internal::library, p_class.opaque, p_name.opaque, p_prefix.opaque);
}

void ClassDB::add_signal(const StringName &p_class, const MethodInfo &p_signal) {
	std::vector<PropertyInfo> arguments = p_signal.arguments;
	std::vector<GDExtensionPropertyInfo> infos;
	infos.reserve(arguments.size());
	for (PropertyInfo &argument : arguments) {
		infos.push_back(argument.raw());
	}
	internal::engine.classdb_register_extension_class_signal(
			internal::library, p_class.opaque, p_signal.name.opaque, infos.data(), int64_t(infos.size()));
}

void ClassDB::bind_integer_constant(const StringName &p_class, const StringName &p_enum, const StringName &p_name,
		int64_t p_value, bool p_is_bitfield) {
	internal::engine.classdb_register_extension_class_integer_constant(
			internal::library, p_class.opaque, p_enum.opaque, p_name.opaque, p_value, p_is_bitfield);
}

} // namespace godot
