// SPDX-License-Identifier: MIT
#pragma once

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/typed_array.hpp>

namespace godot {

/// Writes MVN's network stream. Documented in doc_classes/MvnEncoder.xml.
class MvnEncoder : public RefCounted {
	GDCLASS(MvnEncoder, RefCounted)

public:
	static TypedArray<PackedByteArray> encode(const Dictionary &p_sample, int64_t p_most_bytes);
	static PackedStringArray get_segment_names();

protected:
	static void _bind_methods();
};

} // namespace godot
