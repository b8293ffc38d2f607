// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>

namespace godot::internal {

/// A method that the engine must have, with the very signature that its hash stands for.
struct ExpectedMethod {
	const char *class_name;
	const char *method;
	int64_t hash;
};

// Generated: see generator/checklist.py.
extern const char *const expected_engine;
extern const ExpectedMethod *const expected_methods;
extern const size_t expected_method_count;

/// Whether the engine has every expected method; prints what it lacks.
bool check_expected_api();

/// The running engine's full name and version.
const char *running_engine();

} // namespace godot::internal
