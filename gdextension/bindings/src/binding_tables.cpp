// SPDX-License-Identifier: MIT
#include <godot_cpp/classes/wrapped.hpp>
#include <godot_cpp/core/startup.hpp>

namespace godot::internal {

namespace {

using Missing = std::vector<std::string>;

void load_life_cycle(const BuiltinTable &p_table) {
	for (BuiltinConstructor &constructor : p_table.constructors) {
		constructor.function = engine.variant_get_ptr_constructor(p_table.type, constructor.index);
	}
	if (p_table.destructor != nullptr) {
		*p_table.destructor = engine.variant_get_ptr_destructor(p_table.type);
	}
}

std::string with_hash(const std::string &p_name, GDExtensionInt p_hash) {
	return p_name + " (hash " + std::to_string(p_hash) + ")";
}

void load_members(const BuiltinTable &p_table, Missing &r_missing) {
	for (const BuiltinConstructor &constructor : p_table.constructors) {
		if (constructor.function == nullptr) {
			r_missing.push_back(std::string(p_table.name) + " constructor " + std::to_string(constructor.index));
		}
	}
	for (BuiltinMethod &method : p_table.methods) {
		const StringName name(method.name);
		method.function = engine.variant_get_ptr_builtin_method(p_table.type, name.opaque, method.hash);
		if (method.function == nullptr) {
			r_missing.push_back(with_hash(std::string(p_table.name) + "." + method.name, method.hash));
		}
	}
	for (BuiltinOperator &entry : p_table.operators) {
		entry.function = engine.variant_get_ptr_operator_evaluator(entry.name, p_table.type, entry.right);
		if (entry.function == nullptr) {
			r_missing.push_back(std::string(p_table.name) + " operator " + std::to_string(entry.name));
		}
	}
}

} // namespace

Missing load_builtins() {
	Missing missing;
	// First what names are made and freed with.
	for (const BuiltinTable *table : builtin_tables()) {
		load_life_cycle(*table);
	}
	for (const BuiltinTable *table : builtin_tables()) {
		load_members(*table, missing);
	}
	for (UtilityFunction &function : utility_functions()) {
		const StringName name(function.name);
		function.function = engine.variant_get_ptr_utility_function(name.opaque, function.hash);
		if (function.function == nullptr) {
			missing.push_back(with_hash(function.name, function.hash));
		}
	}
	return missing;
}

Missing load_class_methods() {
	Missing missing;
	for (EngineClass *engine_class : engine_classes()) {
		const StringName class_name(engine_class->name);
		for (MethodBind &method : engine_class->methods) {
			const StringName name(method.name);
			method.bind = engine.classdb_get_method_bind(class_name.opaque, name.opaque, method.hash);
			if (method.bind == nullptr) {
				missing.push_back(with_hash(std::string(engine_class->name) + "." + method.name, method.hash));
			}
		}
	}
	const StringName object("Object");
	const StringName is_class(object_is_class.name);
	object_is_class.bind = engine.classdb_get_method_bind(object.opaque, is_class.opaque, object_is_class.hash);
	return missing;
}

} // namespace godot::internal
