// SPDX-License-Identifier: MIT
#pragma once

#include <replication/snapshot_decoder.hpp>

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/transform3d.hpp>

namespace godot {

/// Reads what a server sends. Documented in doc_classes/SnapshotDecoder.xml.
class SnapshotDecoder : public RefCounted {
	GDCLASS(SnapshotDecoder, RefCounted)

public:
	enum Outcome {
		OK,
		BROKEN,
		STALE,
		LACKS_BASELINE,
		NOT_BEGUN,
	};

	bool configure(const PackedInt32Array &p_parents, double p_max_error_deg);
	Outcome decode(const PackedByteArray &p_bytes);
	bool define_type(int64_t p_type, const PackedByteArray &p_kinds, const PackedFloat32Array &p_mins,
			const PackedFloat32Array &p_maxs, const PackedFloat32Array &p_resolutions);
	bool add_entity(int64_t p_entity, int64_t p_type, const PackedFloat32Array &p_values);
	void remove_entity(int64_t p_entity);
	void set_table_version(int64_t p_version);
	double get_field(int64_t p_entity, int64_t p_field) const;
	PackedInt32Array get_changed_entities() const;
	int64_t get_command_ack() const;
	static PackedByteArray find_motion_ack(const PackedByteArray &p_bytes);
	int64_t get_unacknowledged() const;
	int64_t get_frame(int64_t p_person) const;
	void set_wants_marks(bool p_wanted);
	PackedByteArray get_ack(const Vector3 &p_viewpoint);
	int64_t get_tick() const;
	int64_t get_tick_rate() const;
	Dictionary get_mark() const;
	PackedInt32Array get_people() const;
	PackedInt32Array get_bodies() const;
	PackedFloat32Array get_orientations(int64_t p_person) const;
	Vector3 get_root(int64_t p_person) const;
	bool has_body(int64_t p_body) const;
	Transform3D get_body_transform(int64_t p_body) const;
	Vector3 get_body_velocity(int64_t p_body) const;
	Vector3 get_body_spin(int64_t p_body) const;
	void clear();

	/// The core, or null before configure().
	const wire::SnapshotDecoder *get_core() const { return _core.get(); }

protected:
	static void _bind_methods();

private:
	const wire::BodyUpdate *_find_body(int64_t p_body) const;

	const wire::PersonUpdate *_find_person(int64_t p_person) const;

	std::unique_ptr<wire::SnapshotDecoder> _core;
};

} // namespace godot

VARIANT_ENUM_CAST(SnapshotDecoder::Outcome);
