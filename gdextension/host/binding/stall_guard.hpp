// SPDX-License-Identifier: MIT
#pragma once

#include "../src/stall_guard.hpp"

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>

#include <string>
#include <vector>

namespace godot {

/// Replaces this program where its main loop stands still. Documented in
/// doc_classes/StallGuard.xml.
class StallGuard : public RefCounted {
	GDCLASS(StallGuard, RefCounted)

public:
	~StallGuard() override;

	bool start(double p_patience_s, const PackedStringArray &p_command);
	void beat();
	void hold();
	void stop();
	static Error replace(const PackedStringArray &p_command);

protected:
	static void _bind_methods();

private:
	host::StallGuard _guard;
};

} // namespace godot
