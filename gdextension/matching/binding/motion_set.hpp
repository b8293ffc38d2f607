// SPDX-License-Identifier: MIT
#pragma once

#include <clip_builder.hpp>
#include <motion_set.hpp>

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_string_array.hpp>
#include <godot_cpp/variant/packed_vector3_array.hpp>
#include <godot_cpp/variant/string.hpp>

#include <memory>
#include <vector>

namespace godot {

/// Recorded motion that walkers are made of. Documented in doc_classes/MotionSet.xml.
class MotionSet : public RefCounted {
	GDCLASS(MotionSet, RefCounted)

public:
	String load_file(const String &p_path);
	String load_bytes(const PackedByteArray &p_bytes);
	PackedByteArray to_bytes() const;
	void begin_body(const PackedVector3Array &p_hip_joints, double p_thigh, double p_shank, double p_ankle_height,
			double p_foot);
	String add_clip(const String &p_name, int64_t p_stance, const PackedVector3Array &p_hips,
			const PackedFloat32Array &p_orientations, int64_t p_first, int64_t p_end);
	String add_clip_of(const Ref<MotionSet> &p_other, int64_t p_clip);
	int64_t get_clip_count() const;
	String get_clip_name(int64_t p_clip) const;
	int64_t get_clip_stance(int64_t p_clip) const;
	int64_t get_clip_frame_count(int64_t p_clip) const;
	double get_clip_speed(int64_t p_clip) const;
	double get_clip_travel(int64_t p_clip) const;
	double get_clip_contact_share(int64_t p_clip) const;
	int64_t get_frame_count() const;
	int64_t get_searched_count() const;
	int64_t measure_search(int64_t p_searches, int64_t p_seed, int64_t p_least_rows) const;

	const std::shared_ptr<const matching::MotionSet> &core() const { return _core; }

protected:
	static void _bind_methods();

private:
	const matching::Clip *_clip(int64_t p_clip) const;
	const matching::MotionSet::Entry *_entry_of(int64_t p_clip) const;

	matching::Body _body;
	std::vector<matching::Clip> _clips;
	std::shared_ptr<const matching::MotionSet> _core;
};

} // namespace godot
