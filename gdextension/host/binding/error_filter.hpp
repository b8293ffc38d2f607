// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/string.hpp>

namespace godot {

/// Leaves single messages out of standard error. Documented in doc_classes/ErrorFilter.xml.
class ErrorFilter : public RefCounted {
	GDCLASS(ErrorFilter, RefCounted)

public:
	static void leave_out(const String &p_pattern);
	/// Gives standard error back as it was: the library is about to be unloaded.
	static void close();

protected:
	static void _bind_methods();
};

} // namespace godot
