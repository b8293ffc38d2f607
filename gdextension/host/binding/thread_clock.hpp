// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>

namespace godot {

/// Measures how long a thread has worked. Documented in doc_classes/ThreadClock.xml.
class ThreadClock : public RefCounted {
	GDCLASS(ThreadClock, RefCounted)

public:
	static int64_t get_usec();
	static int64_t get_monotonic_usec();

protected:
	static void _bind_methods();
};

} // namespace godot
