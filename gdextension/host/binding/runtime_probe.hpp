// SPDX-License-Identifier: MIT
#pragma once

#include "../src/runtime_probe.hpp"

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/string.hpp>

namespace godot {

/// Asks an OpenXR runtime for a headset, in a process of its own. Documented in
/// doc_classes/RuntimeProbe.xml.
class RuntimeProbe : public RefCounted {
	GDCLASS(RuntimeProbe, RefCounted)

public:
	enum Answer {
		NONE,
		PENDING,
		READY,
		NO_LIBRARY,
		NO_SERVICE,
		NO_HEADSET,
		STALLED,
	};

	bool start(const String &p_library, double p_patience_s);
	Answer poll();

protected:
	static void _bind_methods();

private:
	host::RuntimeProbe _probe;
};

} // namespace godot

VARIANT_ENUM_CAST(godot::RuntimeProbe::Answer);
