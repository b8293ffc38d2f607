// SPDX-License-Identifier: MIT
#pragma once

// The steps of start-up, in the order in which they happen.

#include <godot_cpp/core/binding_tables.hpp>

#include <string>

namespace godot::internal {

/// Fetches the conversions between Variant and the builtin types.
void load_variant_conversions();
/// Fetches every function of the builtin types, and the utility functions. Returns what is missing.
std::vector<std::string> load_builtins();
/// Fetches every method of the engine classes, which must exist by now. Returns what is missing.
std::vector<std::string> load_class_methods();
/// Hands the class documentation to the editor.
void load_documentation();

} // namespace godot::internal
