// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>

namespace godot {

/// Whether the system wants the program to end, or to read its configuration again. Documented in
/// doc_classes/StopSignal.xml.
class StopSignal : public RefCounted {
	GDCLASS(StopSignal, RefCounted)

public:
	bool watch();
	bool is_raised() const;
	bool watch_reload();
	bool take_reload();
	/// Lets no signal lead into this library any more: it is about to be unloaded.
	static void forget();

protected:
	static void _bind_methods();
};

} // namespace godot
