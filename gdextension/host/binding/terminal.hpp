// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/string.hpp>

namespace godot {

/// Standard input without waiting, key by key where it is a terminal. Documented in
/// doc_classes/Terminal.xml.
class Terminal : public RefCounted {
	GDCLASS(Terminal, RefCounted)

public:
	~Terminal() override;

	bool open();
	PackedByteArray read();
	bool is_at_end() const;
	void write(const String &p_text);
	void close();

protected:
	static void _bind_methods();

private:
	bool _is_raw = false;
	bool _has_ended = false;
};

} // namespace godot
