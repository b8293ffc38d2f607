// SPDX-License-Identifier: MIT
// In place of the generated list: what bindings that were made for another engine would expect.
#include <godot_cpp/core/expected_api.hpp>

namespace godot::internal {

const char *const expected_engine = "Another Engine v0.0";

static const ExpectedMethod methods[] = {
	{ "Node", "get_child", 12345 },
	{ "Node", "no_such_method", 1 },
};

const ExpectedMethod *const expected_methods = methods;
const size_t expected_method_count = 2;

} // namespace godot::internal
