// SPDX-License-Identifier: MIT
#include "snapshot_smoother.hpp"

#include "pose_arrays.hpp"
#include <convert.hpp>

#include <algorithm>
#include <limits>

namespace godot {

namespace {

bool is_tick(int64_t p_tick) {
	return p_tick >= 0 && p_tick <= std::numeric_limits<uint32_t>::max();
}

Transform3D to_transform(const wire::BodyTransform &p_body) {
	return Transform3D(Basis(from_core(p_body.orientation)), from_core(p_body.position));
}

} // namespace

void SnapshotSmoother::set_method(Method p_method) {
	ERR_FAIL_COND_MSG(int(p_method) < 0 || int(p_method) >= wire::SMOOTHING_METHOD_COUNT,
			"SnapshotSmoother: there is no such method.");
	_smoother.set_method(wire::SmoothingMethod(int(p_method)));
}

void SnapshotSmoother::set_tick_rate(double p_rate) {
	ERR_FAIL_COND_MSG(!_smoother.set_tick_rate(p_rate), "SnapshotSmoother: a tick rate is above 0, at most 1000.");
}

bool SnapshotSmoother::set_skeleton(int64_t p_person, const PackedInt32Array &p_parents,
		const PackedVector3Array &p_joints_in_parent, const PackedVector3Array &p_joints_in_limb) {
	ERR_FAIL_COND_V_MSG(!is_id(p_person), false, "SnapshotSmoother: a person's number is 0 to 65535.");
	kinematics::Skeleton skeleton;
	return read_skeleton(p_parents, p_joints_in_parent, p_joints_in_limb, skeleton) &&
			_smoother.set_skeleton(uint16_t(p_person), skeleton);
}

bool SnapshotSmoother::push_person(int64_t p_person, int64_t p_tick, double p_arrival_s, const Vector3 &p_root,
		const PackedFloat32Array &p_orientations) {
	wire::PersonUpdate update;
	const int count = int(p_orientations.size() / 4);
	if (!is_id(p_person) || !is_tick(p_tick) || count > kinematics::MAX_LIMBS ||
			!read_orientations(p_orientations, count, update.pose) ||
			count != _smoother.limb_count(uint16_t(p_person))) {
		return false;
	}
	update.id = uint16_t(p_person);
	update.tick = uint32_t(p_tick);
	update.pose.root = to_core(p_root);
	return _smoother.push(update, p_arrival_s);
}

bool SnapshotSmoother::push_body(int64_t p_body, int64_t p_tick, double p_arrival_s, const Transform3D &p_transform,
		const Vector3 &p_velocity, const Vector3 &p_spin, bool p_at_rest) {
	if (!is_id(p_body) || !is_tick(p_tick)) {
		return false;
	}
	wire::BodyUpdate update;
	update.id = uint16_t(p_body);
	update.tick = uint32_t(p_tick);
	update.position = to_core(p_transform.origin);
	update.orientation = to_core(p_transform.basis);
	update.velocity = to_core(p_velocity);
	update.spin = to_core(p_spin);
	update.at_rest = p_at_rest;
	return _smoother.push(update, p_arrival_s);
}

void SnapshotSmoother::take(const Ref<SnapshotDecoder> &p_decoder, double p_arrival_s) {
	ERR_FAIL_COND_MSG(
			p_decoder.is_null() || p_decoder->get_core() == nullptr, "SnapshotSmoother: that decoder is none.");
	_decoder = p_decoder;
	const wire::SnapshotDecoder &decoder = *p_decoder->get_core();
	if (decoder.tick_rate() > 0 && double(decoder.tick_rate()) != get_tick_rate()) {
		set_tick_rate(decoder.tick_rate());
	}
	// Carriers before who is carried.
	for (const wire::BodyUpdate &update : decoder.bodies()) {
		_smoother.push(update, p_arrival_s);
	}
	for (const wire::PersonUpdate &update : decoder.people()) {
		_smoother.push(update, p_arrival_s);
	}
	for (const wire::FieldUpdate &update : decoder.fields()) {
		_smoother.push(update.tick, update.id, *update.type, decoder.generation_of(update.id),
				decoder.spawn_fields(update.id), update.values, p_arrival_s);
	}
}

double SnapshotSmoother::field(int64_t p_entity, int64_t p_field) const {
	if (_decoder.is_null() || !is_id(p_entity) || _decoder->get_core() == nullptr ||
			!_decoder->get_core()->has_entity(uint16_t(p_entity))) {
		return 0.0;
	}
	const uint32_t generation = _decoder->get_core()->generation_of(uint16_t(p_entity));
	const wire::FieldTrack *track = _smoother.fields(uint16_t(p_entity), generation);
	if (track == nullptr) {
		return _decoder->get_field(p_entity, p_field);
	}
	if (p_field < 0 || p_field >= int64_t(track->field_count())) {
		return 0.0;
	}
	return double(_smoother.shown_field(*track, std::size_t(p_field)));
}

void SnapshotSmoother::forget_entity(int64_t p_entity) {
	if (is_id(p_entity)) {
		_smoother.forget_person(uint16_t(p_entity));
		_smoother.forget_body(uint16_t(p_entity));
		_smoother.forget_fields(uint16_t(p_entity));
	}
}

double SnapshotSmoother::server_time(double p_now_s) const {
	return _smoother.get_clock().is_known() ? _smoother.get_clock().server_now(p_now_s) : -1.0;
}

bool SnapshotSmoother::has_person(int64_t p_person) const {
	return is_id(p_person) && _smoother.person(uint16_t(p_person)) != nullptr;
}

bool SnapshotSmoother::has_body(int64_t p_body) const {
	return is_id(p_body) && _smoother.body(uint16_t(p_body)) != nullptr;
}

PackedFloat32Array SnapshotSmoother::person_transforms(int64_t p_person) const {
	const wire::Smoother::Person *person = is_id(p_person) ? _smoother.person(uint16_t(p_person)) : nullptr;
	if (person == nullptr) {
		return PackedFloat32Array();
	}
	return write_transforms(person->pose, person->positions, person->limb_count);
}

PackedFloat32Array SnapshotSmoother::newest_person_transforms(int64_t p_person) const {
	wire::Smoother::Person person;
	if (!is_id(p_person) || !_smoother.newest(uint16_t(p_person), person)) {
		return PackedFloat32Array();
	}
	return write_transforms(person.pose, person.positions, person.limb_count);
}

Transform3D SnapshotSmoother::body_transform(int64_t p_body) const {
	const wire::BodyTransform *transform = is_id(p_body) ? _smoother.body(uint16_t(p_body)) : nullptr;
	return transform != nullptr ? to_transform(*transform) : Transform3D();
}

Transform3D SnapshotSmoother::newest_body_transform(int64_t p_body) const {
	wire::BodyTransform transform;
	return is_id(p_body) && _smoother.newest(uint16_t(p_body), transform) ? to_transform(transform) : Transform3D();
}

bool SnapshotSmoother::predict_body(int64_t p_body, const Transform3D &p_transform) {
	return is_id(p_body) &&
			_smoother.predict_body(
					uint16_t(p_body), { to_core(p_transform.origin), to_core(p_transform.basis.orthonormalized()) });
}

void SnapshotSmoother::forget_prediction(int64_t p_body) {
	if (is_id(p_body)) {
		_smoother.forget_prediction(uint16_t(p_body));
	}
}

PackedInt32Array SnapshotSmoother::get_moved_bodies() const {
	const std::vector<uint16_t> &moved = _smoother.moved_bodies();
	PackedInt32Array result;
	result.resize(int64_t(moved.size()));
	std::copy(moved.begin(), moved.end(), result.ptrw());
	return result;
}

void SnapshotSmoother::_bind_methods() {
	ClassDB::bind_method(D_METHOD("set_method", "method"), &SnapshotSmoother::set_method);
	ClassDB::bind_method(D_METHOD("get_method"), &SnapshotSmoother::get_method);
	ClassDB::bind_method(D_METHOD("set_tick_rate", "rate"), &SnapshotSmoother::set_tick_rate);
	ClassDB::bind_method(D_METHOD("get_tick_rate"), &SnapshotSmoother::get_tick_rate);
	ClassDB::bind_method(D_METHOD("set_skeleton", "person", "parents", "joints_in_parent", "joints_in_limb"),
			&SnapshotSmoother::set_skeleton);
	ClassDB::bind_method(D_METHOD("push_person", "person", "tick", "arrival_s", "root", "orientations"),
			&SnapshotSmoother::push_person);
	ClassDB::bind_method(D_METHOD("push_body", "body", "tick", "arrival_s", "transform", "velocity", "spin", "at_rest"),
			&SnapshotSmoother::push_body);
	ClassDB::bind_method(D_METHOD("predict_body", "body", "transform"), &SnapshotSmoother::predict_body);
	ClassDB::bind_method(D_METHOD("forget_prediction", "body"), &SnapshotSmoother::forget_prediction);
	ClassDB::bind_method(D_METHOD("field", "entity", "field"), &SnapshotSmoother::field);
	ClassDB::bind_method(D_METHOD("forget_entity", "entity"), &SnapshotSmoother::forget_entity);
	ClassDB::bind_method(D_METHOD("take", "decoder", "arrival_s"), &SnapshotSmoother::take);
	ClassDB::bind_method(D_METHOD("evaluate", "now_s"), &SnapshotSmoother::evaluate);
	ClassDB::bind_method(D_METHOD("show_tick", "tick", "now_s"), &SnapshotSmoother::show_tick);
	ClassDB::bind_method(D_METHOD("get_shown_tick"), &SnapshotSmoother::get_shown_tick);
	ClassDB::bind_method(D_METHOD("get_motion_tick"), &SnapshotSmoother::get_motion_tick);
	ClassDB::bind_method(D_METHOD("get_delay"), &SnapshotSmoother::get_delay);
	ClassDB::bind_method(D_METHOD("server_time", "now_s"), &SnapshotSmoother::server_time);
	ClassDB::bind_method(D_METHOD("has_person", "person"), &SnapshotSmoother::has_person);
	ClassDB::bind_method(D_METHOD("has_body", "body"), &SnapshotSmoother::has_body);
	ClassDB::bind_method(D_METHOD("person_transforms", "person"), &SnapshotSmoother::person_transforms);
	ClassDB::bind_method(D_METHOD("newest_person_transforms", "person"), &SnapshotSmoother::newest_person_transforms);
	ClassDB::bind_method(D_METHOD("body_transform", "body"), &SnapshotSmoother::body_transform);
	ClassDB::bind_method(D_METHOD("newest_body_transform", "body"), &SnapshotSmoother::newest_body_transform);
	ClassDB::bind_method(D_METHOD("get_moved_bodies"), &SnapshotSmoother::get_moved_bodies);
	ClassDB::bind_method(D_METHOD("clear"), &SnapshotSmoother::clear);
	ADD_PROPERTY(PropertyInfo(Variant::INT, "method", PROPERTY_HINT_ENUM,
						 "None,Linear,Extrapolate and lerp,Hermite,Error offset,Adaptive low delay"),
			"set_method", "get_method");
	ADD_PROPERTY(PropertyInfo(Variant::FLOAT, "tick_rate", PROPERTY_HINT_RANGE, "1,1000,1,suffix:Hz"), "set_tick_rate",
			"get_tick_rate");
	BIND_ENUM_CONSTANT(NONE);
	BIND_ENUM_CONSTANT(LINEAR);
	BIND_ENUM_CONSTANT(EXTRAPOLATE_LERP);
	BIND_ENUM_CONSTANT(HERMITE);
	BIND_ENUM_CONSTANT(ERROR_OFFSET);
	BIND_ENUM_CONSTANT(ADAPTIVE_LOW_DELAY);
}

} // namespace godot
