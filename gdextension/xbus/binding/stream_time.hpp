// SPDX-License-Identifier: MIT
#pragma once

#include <stream_time.hpp>

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>

namespace godot {

/// When the samples of a stream were measured. Documented in doc_classes/StreamTime.xml.
class StreamTime : public RefCounted {
	GDCLASS(StreamTime, RefCounted)

public:
	int64_t at(int64_t p_source_usec, int64_t p_counter, int64_t p_arrival_usec);

protected:
	static void _bind_methods();

private:
	clocks::StreamTime _time;
};

} // namespace godot
