// SPDX-License-Identifier: MIT
#include <godot_cpp/core/error_macros.hpp>
#include <godot_cpp/core/expected_api.hpp>

#include <string>

namespace godot::internal {

const char *running_engine() {
	GDExtensionGodotVersion2 version = {};
	engine.get_godot_version2(&version);
	return version.string;
}

bool check_expected_api() {
	bool complete = true;
	for (size_t i = 0; i < expected_method_count; i++) {
		const ExpectedMethod &expected = expected_methods[i];
		const StringName class_name(expected.class_name);
		const StringName method(expected.method);
		if (engine.classdb_get_method_bind(class_name.opaque, method.opaque, expected.hash) == nullptr) {
			const std::string message = std::string("This extension does not fit ") + running_engine() +
					": it expects " + expected.class_name + "." + expected.method + " as in " + expected_engine +
					". Build it again from this engine's API dump.";
			print_error("Method not found.", message.c_str(), __func__, __FILE__, __LINE__);
			complete = false;
		}
	}
	return complete;
}

} // namespace godot::internal
