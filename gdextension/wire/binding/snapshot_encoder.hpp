// SPDX-License-Identifier: MIT
#pragma once

#include <replication/snapshot_encoder.hpp>

#include <godot_cpp/classes/ref_counted.hpp>
#include <godot_cpp/core/binder_common.hpp>
#include <godot_cpp/core/class_db.hpp>
#include <godot_cpp/variant/dictionary.hpp>
#include <godot_cpp/variant/packed_byte_array.hpp>
#include <godot_cpp/variant/packed_float32_array.hpp>
#include <godot_cpp/variant/packed_int32_array.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/typed_array.hpp>
#include <godot_cpp/variant/vector3.hpp>
#include <godot_cpp/variant/vector3i.hpp>

namespace godot {

/// Sends clients where everything is. Documented in doc_classes/SnapshotEncoder.xml.
class SnapshotEncoder : public RefCounted {
	GDCLASS(SnapshotEncoder, RefCounted)

public:
	bool configure(const PackedInt32Array &p_parents, double p_max_error_deg, int64_t p_tick_rate);

	bool define_type(int64_t p_type, const PackedByteArray &p_kinds, const PackedFloat32Array &p_mins,
			const PackedFloat32Array &p_maxs, const PackedFloat32Array &p_resolutions);
	bool add_entity(int64_t p_entity, int64_t p_type, const PackedFloat32Array &p_values, int64_t p_table_version);
	void remove_entity(int64_t p_entity);
	bool set_field(int64_t p_entity, int64_t p_field, double p_value);
	double get_field(int64_t p_entity, int64_t p_field) const;
	void set_position(int64_t p_entity, const Vector3 &p_position);
	void set_frame(int64_t p_person, int64_t p_carrier);

	bool add_person(int64_t p_person, const TypedArray<RID> &p_bodies, const PackedFloat32Array &p_reset_orientations);
	bool add_body(int64_t p_body, const RID &p_rid);
	bool set_body_pose(int64_t p_person, const PackedFloat32Array &p_pose);
	void capture(int64_t p_tick);

	void begin_tick(int64_t p_tick);
	bool put_person(int64_t p_person, const Vector3 &p_root, const PackedFloat32Array &p_orientations);
	void put_body(int64_t p_body, const Transform3D &p_transform, const Vector3 &p_velocity, const Vector3 &p_spin,
			bool p_at_rest);
	void end_tick();

	void set_datagram_overhead(int64_t p_bytes);
	void add_client(int64_t p_client, int64_t p_snapshots_per_second, double p_bits_per_second);
	void set_bandwidth(int64_t p_client, double p_bits_per_second);
	void add_recorder(int64_t p_client);
	void remove_client(int64_t p_client);
	void set_own_person(int64_t p_client, int64_t p_person);
	bool set_cells(const Vector3 &p_origin, double p_size, const Vector3i &p_counts, const PackedByteArray &p_visible);
	void set_command_ack(int64_t p_client, int64_t p_number);
	void set_motion_ack(int64_t p_client, const PackedByteArray &p_bytes);
	bool take_ack(int64_t p_client, const PackedByteArray &p_bytes);
	void set_mark(int64_t p_person, int64_t p_sample, int64_t p_simulated_usec, const PackedInt32Array &p_steps_usec);
	TypedArray<PackedByteArray> encode(int64_t p_client, int64_t p_now_usec);
	PackedInt32Array encode_each(
			const PackedInt32Array &p_clients, int64_t p_now_usec, TypedArray<PackedByteArray> r_datagrams);
	Dictionary get_stats(int64_t p_client);

protected:
	static void _bind_methods();

private:
	struct Person {
		uint16_t id = 0;
		std::vector<RID> bodies;
		std::vector<kinematics::Quat> from_reset; // Inverse of each body's orientation in the reset pose.
		/// What somebody has read of the bodies for the next capture, if anybody has.
		kinematics::PersonPose pose;
		bool has_pose = false;
	};
	void _remove_person(int64_t p_person);
	void _remove_body(int64_t p_body);
	static bool _read_pose(const Person &p_person, kinematics::PersonPose &r_pose);
	struct Body {
		uint16_t id;
		RID rid;
	};

	std::unique_ptr<wire::SnapshotEncoder> _core;
	std::vector<Person> _people;
	std::vector<Body> _bodies;
	wire::DatagramList _datagrams;
};

} // namespace godot
