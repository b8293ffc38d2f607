// SPDX-License-Identifier: MIT
#pragma once

#include "../src/private_file.hpp"

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/string.hpp>

namespace godot {

/// A small file that only its owner can read and one process has open. Documented in
/// doc_classes/PrivateFile.xml.
class PrivateFile : public RefCounted {
	GDCLASS(PrivateFile, RefCounted)

public:
	Error open(const String &p_path);
	PackedByteArray read() const;
	Error write(const PackedByteArray &p_bytes);
	Error remove();
	void close();

protected:
	static void _bind_methods();

private:
	host::PrivateFile _file;
};

} // namespace godot
