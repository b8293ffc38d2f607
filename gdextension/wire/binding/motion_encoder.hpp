// SPDX-License-Identifier: MIT
#pragma once

#include <motion/motion_encoder.hpp>

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include <memory>

namespace godot {

/// Codes what a client's people do. Documented in doc_classes/MotionEncoder.xml.
class MotionEncoder : public RefCounted {
	GDCLASS(MotionEncoder, RefCounted)

public:
	bool configure(const PackedInt32Array &p_parents, double p_max_error_deg, int64_t p_first);
	void begin(int64_t p_time_usec, int64_t p_held_usec, int64_t p_sent_usec);
	bool put(int64_t p_person, int64_t p_sample, int64_t p_time_usec, const Vector3 &p_root,
			const PackedFloat32Array &p_orientations);
	PackedByteArray finish();
	bool take_ack(const PackedByteArray &p_bytes);

protected:
	static void _bind_methods();

private:
	std::unique_ptr<wire::MotionEncoder> _core;
	int _limb_count = 0;
};

} // namespace godot
