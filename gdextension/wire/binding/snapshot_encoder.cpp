// SPDX-License-Identifier: MIT
#include "snapshot_encoder.hpp"

#include "entity_arrays.hpp"
#include "pose_arrays.hpp"
#include <convert.hpp>

#include <godot_cpp/classes/physics_direct_body_state3d.hpp>
#include <godot_cpp/classes/physics_server3d.hpp>

#include <algorithm>
#include <cstring>

namespace godot {

namespace {

constexpr const char *UNCONFIGURED_ENCODER = "SnapshotEncoder: call configure() first.";

} // namespace

bool SnapshotEncoder::configure(const PackedInt32Array &p_parents, double p_max_error_deg, int64_t p_tick_rate) {
	kinematics::Skeleton shape;
	ERR_FAIL_COND_V_MSG(!read_parents(p_parents, shape), false,
			"SnapshotEncoder: parents come before their children, the first has -1.");
	ERR_FAIL_COND_V_MSG(!is_pose_error(p_max_error_deg), false, "SnapshotEncoder: an error is 0.02 to 5 degrees.");
	ERR_FAIL_COND_V_MSG(
			p_tick_rate < 1 || p_tick_rate > 240, false, "SnapshotEncoder: a tick rate is 1 to 240 a second.");
	_core = std::make_unique<wire::SnapshotEncoder>(shape, p_max_error_deg, int(p_tick_rate));
	return true;
}

bool SnapshotEncoder::define_type(int64_t p_type, const PackedByteArray &p_kinds, const PackedFloat32Array &p_mins,
		const PackedFloat32Array &p_maxs, const PackedFloat32Array &p_resolutions) {
	ERR_FAIL_COND_V_MSG(_core == nullptr, false, UNCONFIGURED_ENCODER);
	return read_type(_core->world().entities().types(), p_type, p_kinds, p_mins, p_maxs, p_resolutions);
}

bool SnapshotEncoder::add_entity(
		int64_t p_entity, int64_t p_type, const PackedFloat32Array &p_values, int64_t p_table_version) {
	ERR_FAIL_COND_V_MSG(_core == nullptr, false, UNCONFIGURED_ENCODER);
	if (!is_id(p_entity) || !is_type(p_type) || p_table_version < 0 || p_table_version >= int64_t(wire::NEVER)) {
		return false;
	}
	remove_entity(p_entity);
	return _core->world().entities().add(uint16_t(p_entity), uint8_t(p_type), p_values.ptr(),
			std::size_t(p_values.size()), uint32_t(p_table_version));
}

void SnapshotEncoder::remove_entity(int64_t p_entity) {
	ERR_FAIL_COND_MSG(_core == nullptr, UNCONFIGURED_ENCODER);
	if (is_id(p_entity)) {
		_remove_person(p_entity);
		_remove_body(p_entity);
		_core->remove_entity(uint16_t(p_entity));
	}
}

bool SnapshotEncoder::set_field(int64_t p_entity, int64_t p_field, double p_value) {
	ERR_FAIL_COND_V_MSG(_core == nullptr, false, UNCONFIGURED_ENCODER);
	return is_id(p_entity) && p_field >= 0 &&
			_core->world().entities().set(uint16_t(p_entity), std::size_t(p_field), float(p_value));
}

double SnapshotEncoder::get_field(int64_t p_entity, int64_t p_field) const {
	ERR_FAIL_COND_V_MSG(_core == nullptr, 0.0, UNCONFIGURED_ENCODER);
	float value = 0.0f;
	const bool is_there = is_id(p_entity) && p_field >= 0 &&
			_core->world().entities().get(uint16_t(p_entity), std::size_t(p_field), value);
	return is_there ? double(value) : 0.0;
}

void SnapshotEncoder::set_position(int64_t p_entity, const Vector3 &p_position) {
	ERR_FAIL_COND_MSG(_core == nullptr, UNCONFIGURED_ENCODER);
	if (is_id(p_entity)) {
		_core->world().entities().set_position(uint16_t(p_entity), to_core(p_position));
	}
}

void SnapshotEncoder::set_frame(int64_t p_person, int64_t p_carrier) {
	ERR_FAIL_COND_MSG(_core == nullptr, UNCONFIGURED_ENCODER);
	ERR_FAIL_COND_MSG(!is_id(p_person) || p_carrier < -1 || p_carrier == 0 || (p_carrier > 0 && !is_id(p_carrier)),
			"SnapshotEncoder: a person is carried by an entity of 1 to 65535, or by none: -1.");
	_core->world().set_frame(uint16_t(p_person), uint16_t(std::max<int64_t>(p_carrier, 0)));
}

bool SnapshotEncoder::add_person(
		int64_t p_person, const TypedArray<RID> &p_bodies, const PackedFloat32Array &p_reset_orientations) {
	ERR_FAIL_COND_V_MSG(_core == nullptr, false, UNCONFIGURED_ENCODER);
	ERR_FAIL_COND_V_MSG(!is_id(p_person), false, "SnapshotEncoder: a person's number is 0 to 65535.");
	ERR_FAIL_COND_V_MSG(p_bodies.size() != _core->world().shape().limb_count, false,
			"SnapshotEncoder: a person has as many bodies as configure() has named parents.");
	kinematics::PersonPose reset;
	ERR_FAIL_COND_V_MSG(!read_orientations(p_reset_orientations, int(p_bodies.size()), reset), false,
			"SnapshotEncoder: each body has an orientation of four floats in the reset pose.");
	_remove_person(p_person);
	Person person;
	person.id = uint16_t(p_person);
	for (int64_t i = 0; i < p_bodies.size(); i++) {
		person.bodies.push_back(p_bodies[i]);
		person.from_reset.push_back(reset.orientations[std::size_t(i)].inverse());
	}
	_people.push_back(std::move(person));
	return true;
}

bool SnapshotEncoder::add_body(int64_t p_body, const RID &p_rid) {
	ERR_FAIL_COND_V_MSG(!is_id(p_body), false, "SnapshotEncoder: a body's number is 0 to 65535.");
	_bodies.push_back({ uint16_t(p_body), p_rid });
	return true;
}

bool SnapshotEncoder::set_body_pose(int64_t p_person, const PackedFloat32Array &p_pose) {
	const auto person = std::find_if(
			_people.begin(), _people.end(), [p_person](const Person &p_one) { return int64_t(p_one.id) == p_person; });
	if (person == _people.end() || p_pose.size() != 3 + 4 * int64_t(person->bodies.size())) {
		return false;
	}
	const float *values = p_pose.ptr();
	person->pose.root = { values[0], values[1], values[2] };
	for (std::size_t i = 0; i < person->bodies.size(); i++) {
		const float *turn = values + 3 + i * 4;
		person->pose.orientations[i] = kinematics::Quat{ turn[0], turn[1], turn[2], turn[3] } * person->from_reset[i];
	}
	person->has_pose = true;
	return true;
}

bool SnapshotEncoder::_read_pose(const Person &p_person, kinematics::PersonPose &r_pose) {
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	for (std::size_t i = 0; i < p_person.bodies.size(); i++) {
		PhysicsDirectBodyState3D *state = server->body_get_direct_state(p_person.bodies[i]);
		if (state == nullptr) {
			return false;
		}
		const Transform3D transform = state->get_transform();
		r_pose.orientations[i] = to_core(transform.basis) * p_person.from_reset[i];
		r_pose.root = i == 0 ? to_core(transform.origin) : r_pose.root;
	}
	return true;
}

void SnapshotEncoder::capture(int64_t p_tick) {
	ERR_FAIL_COND_MSG(_core == nullptr, UNCONFIGURED_ENCODER);
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	_core->world().begin(uint32_t(p_tick));
	// Whoever is carried is put after what carries.
	for (const Body &body : _bodies) {
		PhysicsDirectBodyState3D *state = server->body_get_direct_state(body.rid);
		if (state == nullptr) {
			continue;
		}
		wire::BodyUpdate update;
		const Transform3D transform = state->get_transform();
		update.id = body.id;
		update.position = to_core(transform.origin);
		update.orientation = to_core(transform.basis);
		update.velocity = to_core(state->get_linear_velocity());
		update.spin = to_core(state->get_angular_velocity());
		update.at_rest = state->is_sleeping();
		_core->world().put_body(update);
	}
	for (Person &person : _people) {
		if (person.has_pose || _read_pose(person, person.pose)) {
			_core->world().put_person(person.id, person.pose);
		}
		person.has_pose = false;
	}
	_core->world().end();
}

void SnapshotEncoder::begin_tick(int64_t p_tick) {
	ERR_FAIL_COND_MSG(_core == nullptr, UNCONFIGURED_ENCODER);
	_core->world().begin(uint32_t(p_tick));
}

bool SnapshotEncoder::put_person(int64_t p_person, const Vector3 &p_root, const PackedFloat32Array &p_orientations) {
	ERR_FAIL_COND_V_MSG(_core == nullptr, false, UNCONFIGURED_ENCODER);
	kinematics::PersonPose pose;
	pose.root = to_core(p_root);
	return is_id(p_person) && read_orientations(p_orientations, _core->world().shape().limb_count, pose) &&
			_core->world().put_person(uint16_t(p_person), pose);
}

void SnapshotEncoder::put_body(int64_t p_body, const Transform3D &p_transform, const Vector3 &p_velocity,
		const Vector3 &p_spin, bool p_at_rest) {
	ERR_FAIL_COND_MSG(_core == nullptr, UNCONFIGURED_ENCODER);
	ERR_FAIL_COND_MSG(!is_id(p_body), "SnapshotEncoder: a body's number is 0 to 65535.");
	wire::BodyUpdate update;
	update.id = uint16_t(p_body);
	update.position = to_core(p_transform.origin);
	update.orientation = to_core(p_transform.basis);
	update.velocity = to_core(p_velocity);
	update.spin = to_core(p_spin);
	update.at_rest = p_at_rest;
	_core->world().put_body(update);
}

void SnapshotEncoder::end_tick() {
	ERR_FAIL_COND_MSG(_core == nullptr, UNCONFIGURED_ENCODER);
	_core->world().end();
}

void SnapshotEncoder::set_datagram_overhead(int64_t p_bytes) {
	ERR_FAIL_COND_MSG(_core == nullptr, UNCONFIGURED_ENCODER);
	ERR_FAIL_COND_MSG(p_bytes < 0 || p_bytes > 1000, "SnapshotEncoder: a datagram's overhead is 0 to 1000 bytes.");
	_core->set_datagram_overhead(std::size_t(p_bytes));
}

void SnapshotEncoder::add_client(int64_t p_client, int64_t p_snapshots_per_second, double p_bits_per_second) {
	ERR_FAIL_COND_MSG(_core == nullptr, UNCONFIGURED_ENCODER);
	_core->add_client(int(p_client), int(p_snapshots_per_second), p_bits_per_second);
}

void SnapshotEncoder::set_bandwidth(int64_t p_client, double p_bits_per_second) {
	_core->set_bandwidth(int(p_client), p_bits_per_second);
}

void SnapshotEncoder::add_recorder(int64_t p_client) {
	ERR_FAIL_COND_MSG(_core == nullptr, UNCONFIGURED_ENCODER);
	_core->add_recorder(int(p_client));
}

void SnapshotEncoder::remove_client(int64_t p_client) {
	ERR_FAIL_COND_MSG(_core == nullptr, UNCONFIGURED_ENCODER);
	_core->remove_client(int(p_client));
}

void SnapshotEncoder::set_own_person(int64_t p_client, int64_t p_person) {
	ERR_FAIL_COND_MSG(_core == nullptr, UNCONFIGURED_ENCODER);
	wire::ClientRecord *client = _core->client(int(p_client));
	if (client != nullptr) {
		client->own_person = int(p_person);
	}
}

bool SnapshotEncoder::set_cells(
		const Vector3 &p_origin, double p_size, const Vector3i &p_counts, const PackedByteArray &p_visible) {
	ERR_FAIL_COND_V_MSG(_core == nullptr, false, UNCONFIGURED_ENCODER);
	return _core->interest().set_cells(to_core(p_origin), float(p_size), { p_counts.x, p_counts.y, p_counts.z },
			p_visible.ptr(), std::size_t(p_visible.size()));
}

void SnapshotEncoder::set_command_ack(int64_t p_client, int64_t p_number) {
	ERR_FAIL_COND_MSG(_core == nullptr, UNCONFIGURED_ENCODER);
	_core->set_command_ack(int(p_client), uint16_t(p_number));
}

void SnapshotEncoder::set_motion_ack(int64_t p_client, const PackedByteArray &p_bytes) {
	ERR_FAIL_COND_MSG(_core == nullptr, UNCONFIGURED_ENCODER);
	ERR_FAIL_COND_MSG(p_bytes.size() != int64_t(wire::MOTION_ACK_BYTES),
			"SnapshotEncoder: an acknowledgement of motion is what MotionDecoder.get_ack() gives.");
	_core->set_motion_ack(int(p_client), p_bytes.ptr(), std::size_t(p_bytes.size()));
}

bool SnapshotEncoder::take_ack(int64_t p_client, const PackedByteArray &p_bytes) {
	ERR_FAIL_COND_V_MSG(_core == nullptr, false, UNCONFIGURED_ENCODER);
	wire::ClientRecord *client = _core->client(int(p_client));
	return client != nullptr &&
			client->take_ack(p_bytes.ptr(), std::size_t(p_bytes.size()), _core->world().tick(),
					_core->world().entities().newest_version());
}

void SnapshotEncoder::set_mark(
		int64_t p_person, int64_t p_sample, int64_t p_simulated_usec, const PackedInt32Array &p_steps_usec) {
	ERR_FAIL_COND_MSG(_core == nullptr, UNCONFIGURED_ENCODER);
	ERR_FAIL_COND_MSG(p_steps_usec.size() != 3 || !is_id(p_person), "SnapshotEncoder: a mark has three steps.");
	wire::Mark mark;
	mark.person = uint16_t(p_person);
	mark.sample = uint32_t(p_sample);
	mark.simulated_usec = p_simulated_usec;
	for (int64_t i = 0; i < 3; i++) {
		const int64_t step = int64_t(p_steps_usec[i]) / wire::Mark::STEP_USEC;
		mark.steps[std::size_t(i)] = uint16_t(std::clamp<int64_t>(step, 0, 65535));
	}
	_core->set_mark(mark);
}

TypedArray<PackedByteArray> SnapshotEncoder::encode(int64_t p_client, int64_t p_now_usec) {
	TypedArray<PackedByteArray> result;
	ERR_FAIL_COND_V_MSG(_core == nullptr, result, UNCONFIGURED_ENCODER);
	_datagrams.clear();
	const std::size_t count = _core->encode(int(p_client), p_now_usec, _datagrams);
	for (std::size_t i = 0; i < count; i++) {
		PackedByteArray bytes;
		bytes.resize(int64_t(_datagrams[i].size));
		std::memcpy(bytes.ptrw(), _datagrams[i].bytes.data(), _datagrams[i].size);
		result.push_back(bytes);
	}
	return result;
}

PackedInt32Array SnapshotEncoder::encode_each(
		const PackedInt32Array &p_clients, int64_t p_now_usec, TypedArray<PackedByteArray> r_datagrams) {
	PackedInt32Array receivers;
	ERR_FAIL_COND_V_MSG(_core == nullptr, receivers, UNCONFIGURED_ENCODER);
	for (int64_t i = 0; i < p_clients.size(); i++) {
		_datagrams.clear();
		const std::size_t count = _core->encode(int(p_clients[i]), p_now_usec, _datagrams);
		for (std::size_t k = 0; k < count; k++) {
			PackedByteArray bytes;
			bytes.resize(int64_t(_datagrams[k].size));
			std::memcpy(bytes.ptrw(), _datagrams[k].bytes.data(), _datagrams[k].size);
			r_datagrams.push_back(bytes);
			receivers.push_back(p_clients[i]);
		}
	}
	return receivers;
}

Dictionary SnapshotEncoder::get_stats(int64_t p_client) {
	Dictionary result;
	ERR_FAIL_COND_V_MSG(_core == nullptr, result, UNCONFIGURED_ENCODER);
	const wire::ClientRecord *client = _core->client(int(p_client));
	if (client == nullptr) {
		return result;
	}
	const wire::ClientStats &stats = client->stats;
	result["datagrams"] = int64_t(stats.datagrams);
	result["bytes"] = int64_t(stats.bytes);
	result["acknowledged"] = int64_t(stats.acked);
	result["lost"] = int64_t(stats.lost);
	result["round_trip_ms"] = 1000.0 * double(stats.round_trip_ticks) / _core->world().rate();
	return result;
}

void SnapshotEncoder::_remove_person(int64_t p_person) {
	_people.erase(std::remove_if(_people.begin(), _people.end(),
						  [p_person](const Person &p_one) { return int64_t(p_one.id) == p_person; }),
			_people.end());
}

void SnapshotEncoder::_remove_body(int64_t p_body) {
	_bodies.erase(std::remove_if(_bodies.begin(), _bodies.end(),
						  [p_body](const Body &p_one) { return int64_t(p_one.id) == p_body; }),
			_bodies.end());
}

void SnapshotEncoder::_bind_methods() {
	ClassDB::bind_method(D_METHOD("configure", "parents", "max_error_deg", "tick_rate"), &SnapshotEncoder::configure);
	ClassDB::bind_method(
			D_METHOD("define_type", "type", "kinds", "mins", "maxs", "resolutions"), &SnapshotEncoder::define_type);
	ClassDB::bind_method(
			D_METHOD("add_entity", "entity", "type", "values", "table_version"), &SnapshotEncoder::add_entity);
	ClassDB::bind_method(D_METHOD("remove_entity", "entity"), &SnapshotEncoder::remove_entity);
	ClassDB::bind_method(D_METHOD("set_field", "entity", "field", "value"), &SnapshotEncoder::set_field);
	ClassDB::bind_method(D_METHOD("get_field", "entity", "field"), &SnapshotEncoder::get_field);
	ClassDB::bind_method(D_METHOD("set_position", "entity", "position"), &SnapshotEncoder::set_position);
	ClassDB::bind_method(D_METHOD("set_frame", "person", "carrier"), &SnapshotEncoder::set_frame);
	ClassDB::bind_method(D_METHOD("set_datagram_overhead", "bytes"), &SnapshotEncoder::set_datagram_overhead);
	ClassDB::bind_method(D_METHOD("add_recorder", "client"), &SnapshotEncoder::add_recorder);
	ClassDB::bind_method(D_METHOD("set_command_ack", "client", "number"), &SnapshotEncoder::set_command_ack);
	ClassDB::bind_method(D_METHOD("set_motion_ack", "client", "bytes"), &SnapshotEncoder::set_motion_ack);
	ClassDB::bind_method(
			D_METHOD("add_person", "person", "bodies", "reset_orientations"), &SnapshotEncoder::add_person);
	ClassDB::bind_method(D_METHOD("add_body", "body", "rid"), &SnapshotEncoder::add_body);
	ClassDB::bind_method(D_METHOD("set_body_pose", "person", "pose"), &SnapshotEncoder::set_body_pose);
	ClassDB::bind_method(D_METHOD("capture", "tick"), &SnapshotEncoder::capture);
	ClassDB::bind_method(D_METHOD("begin_tick", "tick"), &SnapshotEncoder::begin_tick);
	ClassDB::bind_method(D_METHOD("put_person", "person", "root", "orientations"), &SnapshotEncoder::put_person);
	ClassDB::bind_method(
			D_METHOD("put_body", "body", "transform", "velocity", "spin", "at_rest"), &SnapshotEncoder::put_body);
	ClassDB::bind_method(D_METHOD("end_tick"), &SnapshotEncoder::end_tick);
	ClassDB::bind_method(
			D_METHOD("add_client", "client", "snapshots_per_second", "bits_per_second"), &SnapshotEncoder::add_client);
	ClassDB::bind_method(D_METHOD("set_bandwidth", "client", "bits_per_second"), &SnapshotEncoder::set_bandwidth);
	ClassDB::bind_method(D_METHOD("remove_client", "client"), &SnapshotEncoder::remove_client);
	ClassDB::bind_method(D_METHOD("set_own_person", "client", "person"), &SnapshotEncoder::set_own_person);
	ClassDB::bind_method(D_METHOD("set_cells", "origin", "size", "counts", "visible"), &SnapshotEncoder::set_cells);
	ClassDB::bind_method(D_METHOD("take_ack", "client", "bytes"), &SnapshotEncoder::take_ack);
	ClassDB::bind_method(
			D_METHOD("set_mark", "person", "sample", "simulated_usec", "steps_usec"), &SnapshotEncoder::set_mark);
	ClassDB::bind_method(D_METHOD("encode", "client", "now_usec"), &SnapshotEncoder::encode);
	ClassDB::bind_method(D_METHOD("encode_each", "clients", "now_usec", "datagrams"), &SnapshotEncoder::encode_each);
	ClassDB::bind_method(D_METHOD("get_stats", "client"), &SnapshotEncoder::get_stats);
}

} // namespace godot
