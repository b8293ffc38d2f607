// SPDX-License-Identifier: MIT
#pragma once

#include <coding/pose_codings.hpp>

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>

namespace godot {

/// Codings of single poses. Documented in doc_classes/PoseCodec.xml.
class PoseCodec : public RefCounted {
	GDCLASS(PoseCodec, RefCounted)

public:
	enum Coding : int {
		FLOATS = int(wire::PoseCoding::FLOATS),
		THESIS_12 = int(wire::PoseCoding::THESIS_12),
		THESIS_4 = int(wire::PoseCoding::THESIS_4),
		SMALLEST_3 = int(wire::PoseCoding::SMALLEST_3),
	};
	enum {
		MAX_LIMBS = 32,
	};

	static PackedByteArray encode(const PackedFloat32Array &p_orientations, Coding p_coding, int p_bits);
	static PackedFloat32Array decode(const PackedByteArray &p_bytes, Coding p_coding, int p_bits);

protected:
	static void _bind_methods();
};

} // namespace godot

VARIANT_ENUM_CAST(PoseCodec::Coding);
