// SPDX-License-Identifier: MIT
#pragma once

#include <motion/motion_decoder.hpp>

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include <memory>

namespace godot {

/// Reads what a client's people do. Documented in doc_classes/MotionDecoder.xml.
class MotionDecoder : public RefCounted {
	GDCLASS(MotionDecoder, RefCounted)

public:
	enum Outcome {
		OK,
		OLD,
		UNKNOWN_BASE,
		BROKEN,
	};

	bool configure(const PackedInt32Array &p_parents, double p_max_error_deg);
	Outcome decode(const PackedByteArray &p_bytes);
	int64_t get_used() const { return _is_read ? int64_t(_core->used()) : 0; }
	int64_t get_held_usec(int64_t p_person) const;
	int64_t get_time_usec(int64_t p_person) const;
	int64_t get_sent_usec() const { return _is_read ? _core->packet().sent_usec() : 0; }
	PackedInt32Array get_people() const;
	int64_t get_sample(int64_t p_person) const;
	Vector3 get_root(int64_t p_person) const;
	PackedFloat32Array get_orientations(int64_t p_person) const;
	PackedByteArray get_ack() const;

protected:
	static void _bind_methods();

private:
	bool _has(int64_t p_person) const;
	const kinematics::PersonPose &_pose_of(int64_t p_person) const;

	std::unique_ptr<wire::MotionDecoder> _core;
	int _limb_count = 0;
	bool _is_read = false;
	// Where the person is who was asked for last: root and orientations are asked for one after the other.
	mutable kinematics::PersonPose _pose;
	mutable int64_t _posed = -1;
};

} // namespace godot

VARIANT_ENUM_CAST(MotionDecoder::Outcome);
