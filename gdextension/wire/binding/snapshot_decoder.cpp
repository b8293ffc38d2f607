// SPDX-License-Identifier: MIT
#include "snapshot_decoder.hpp"

#include "entity_arrays.hpp"
#include "pose_arrays.hpp"
#include <convert.hpp>

#include <cstring>

namespace godot {

namespace {

constexpr const char *UNCONFIGURED_DECODER = "SnapshotDecoder: call configure() first.";

} // namespace

bool SnapshotDecoder::configure(const PackedInt32Array &p_parents, double p_max_error_deg) {
	kinematics::Skeleton shape;
	ERR_FAIL_COND_V_MSG(!read_parents(p_parents, shape), false,
			"SnapshotDecoder: parents come before their children, the first has -1.");
	ERR_FAIL_COND_V_MSG(!is_pose_error(p_max_error_deg), false, "SnapshotDecoder: an error is 0.02 to 5 degrees.");
	_core = std::make_unique<wire::SnapshotDecoder>(shape, p_max_error_deg);
	return true;
}

SnapshotDecoder::Outcome SnapshotDecoder::decode(const PackedByteArray &p_bytes) {
	ERR_FAIL_COND_V_MSG(_core == nullptr, BROKEN, UNCONFIGURED_DECODER);
	return Outcome(int(_core->decode(p_bytes.ptr(), std::size_t(p_bytes.size()))));
}

void SnapshotDecoder::set_wants_marks(bool p_wanted) {
	ERR_FAIL_COND_MSG(_core == nullptr, UNCONFIGURED_DECODER);
	_core->want_marks(p_wanted);
}

PackedByteArray SnapshotDecoder::get_ack(const Vector3 &p_viewpoint) {
	PackedByteArray result;
	ERR_FAIL_COND_V_MSG(_core == nullptr, result, UNCONFIGURED_DECODER);
	wire::SnapshotDecoder::Ack bytes{};
	const std::size_t size = _core->write_ack(to_core(p_viewpoint), bytes);
	if (size > 0) {
		result.resize(int64_t(size));
		std::memcpy(result.ptrw(), bytes.data(), size);
	}
	return result;
}

bool SnapshotDecoder::define_type(int64_t p_type, const PackedByteArray &p_kinds, const PackedFloat32Array &p_mins,
		const PackedFloat32Array &p_maxs, const PackedFloat32Array &p_resolutions) {
	ERR_FAIL_COND_V_MSG(_core == nullptr, false, UNCONFIGURED_DECODER);
	return read_type(_core->types(), p_type, p_kinds, p_mins, p_maxs, p_resolutions);
}

bool SnapshotDecoder::add_entity(int64_t p_entity, int64_t p_type, const PackedFloat32Array &p_values) {
	ERR_FAIL_COND_V_MSG(_core == nullptr, false, UNCONFIGURED_DECODER);
	return is_id(p_entity) && is_type(p_type) &&
			_core->add_entity(uint16_t(p_entity), uint8_t(p_type), p_values.ptr(), std::size_t(p_values.size()));
}

void SnapshotDecoder::remove_entity(int64_t p_entity) {
	ERR_FAIL_COND_MSG(_core == nullptr, UNCONFIGURED_DECODER);
	if (is_id(p_entity)) {
		_core->remove_entity(uint16_t(p_entity));
	}
}

void SnapshotDecoder::set_table_version(int64_t p_version) {
	ERR_FAIL_COND_MSG(_core == nullptr, UNCONFIGURED_DECODER);
	_core->set_table_version(uint32_t(p_version));
}

double SnapshotDecoder::get_field(int64_t p_entity, int64_t p_field) const {
	if (_core == nullptr || !is_id(p_entity) || !_core->has_entity(uint16_t(p_entity))) {
		return 0.0;
	}
	const wire::EntityType &type = *_core->type_of(uint16_t(p_entity));
	if (p_field < 0 || p_field >= int64_t(type.fields.size())) {
		return 0.0;
	}
	return double(type.fields[std::size_t(p_field)].restore(_core->newest_fields(uint16_t(p_entity))[p_field]));
}

PackedInt32Array SnapshotDecoder::get_changed_entities() const {
	PackedInt32Array result;
	if (_core != nullptr) {
		for (const wire::FieldUpdate &update : _core->fields()) {
			result.push_back(update.id);
		}
	}
	return result;
}

int64_t SnapshotDecoder::get_command_ack() const {
	return _core == nullptr ? -1 : _core->command_ack();
}

PackedByteArray SnapshotDecoder::find_motion_ack(const PackedByteArray &p_bytes) {
	PackedByteArray result;
	const uint8_t *found = wire::SnapshotDecoder::find_motion_ack(p_bytes.ptr(), std::size_t(p_bytes.size()));
	for (std::size_t i = 0; found != nullptr && i < wire::MOTION_ACK_BYTES; i++) {
		result.push_back(found[i]);
	}
	return result;
}

int64_t SnapshotDecoder::get_unacknowledged() const {
	return _core == nullptr ? 0 : _core->unacknowledged();
}

int64_t SnapshotDecoder::get_frame(int64_t p_person) const {
	const wire::PersonUpdate *update = _find_person(p_person);
	return update == nullptr || update->frame == 0 ? -1 : update->frame;
}

int64_t SnapshotDecoder::get_tick() const {
	return _core == nullptr || _core->tick() == wire::NEVER ? -1 : int64_t(_core->tick());
}

int64_t SnapshotDecoder::get_tick_rate() const {
	return _core == nullptr ? 0 : _core->tick_rate();
}

Dictionary SnapshotDecoder::get_mark() const {
	Dictionary result;
	const wire::Mark *mark = _core == nullptr ? nullptr : _core->mark();
	if (mark != nullptr) {
		PackedInt32Array steps;
		for (const uint16_t step : mark->steps) {
			steps.push_back(int32_t(step * wire::Mark::STEP_USEC));
		}
		result["person"] = int64_t(mark->person);
		result["sample"] = int64_t(mark->sample);
		result["tick"] = get_tick();
		result["simulated_usec"] = mark->simulated_usec;
		result["steps_usec"] = steps;
	}
	return result;
}

PackedInt32Array SnapshotDecoder::get_people() const {
	PackedInt32Array result;
	if (_core != nullptr) {
		for (const wire::PersonUpdate &update : _core->people()) {
			result.push_back(update.id);
		}
	}
	return result;
}

PackedInt32Array SnapshotDecoder::get_bodies() const {
	PackedInt32Array result;
	if (_core != nullptr) {
		for (const wire::BodyUpdate &update : _core->bodies()) {
			result.push_back(update.id);
		}
	}
	return result;
}

const wire::PersonUpdate *SnapshotDecoder::_find_person(int64_t p_person) const {
	if (_core != nullptr) {
		for (const wire::PersonUpdate &update : _core->people()) {
			if (int64_t(update.id) == p_person) {
				return &update;
			}
		}
	}
	return nullptr;
}

PackedFloat32Array SnapshotDecoder::get_orientations(int64_t p_person) const {
	PackedFloat32Array result;
	const wire::PersonUpdate *update = _find_person(p_person);
	if (update != nullptr) {
		for (int i = 0; i < _core->shape().limb_count; i++) {
			const kinematics::Quat &turn = update->pose.orientations[std::size_t(i)];
			for (const float part : { turn.x, turn.y, turn.z, turn.w }) {
				result.push_back(part);
			}
		}
	}
	return result;
}

Vector3 SnapshotDecoder::get_root(int64_t p_person) const {
	const wire::PersonUpdate *update = _find_person(p_person);
	return update == nullptr ? Vector3() : from_core(update->pose.root);
}

const wire::BodyUpdate *SnapshotDecoder::_find_body(int64_t p_body) const {
	if (_core != nullptr) {
		for (const wire::BodyUpdate &update : _core->bodies()) {
			if (int64_t(update.id) == p_body) {
				return &update;
			}
		}
	}
	return nullptr;
}

bool SnapshotDecoder::has_body(int64_t p_body) const {
	return _find_body(p_body) != nullptr;
}

Transform3D SnapshotDecoder::get_body_transform(int64_t p_body) const {
	const wire::BodyUpdate *found = _find_body(p_body);
	if (found == nullptr) {
		return Transform3D();
	}
	return Transform3D(Basis(from_core(found->orientation)), from_core(found->position));
}

Vector3 SnapshotDecoder::get_body_velocity(int64_t p_body) const {
	const wire::BodyUpdate *found = _find_body(p_body);
	return found != nullptr ? from_core(found->velocity) : Vector3();
}

Vector3 SnapshotDecoder::get_body_spin(int64_t p_body) const {
	const wire::BodyUpdate *found = _find_body(p_body);
	return found != nullptr ? from_core(found->spin) : Vector3();
}

void SnapshotDecoder::clear() {
	if (_core != nullptr) {
		_core->clear();
	}
}

void SnapshotDecoder::_bind_methods() {
	ClassDB::bind_method(D_METHOD("configure", "parents", "max_error_deg"), &SnapshotDecoder::configure);
	ClassDB::bind_method(D_METHOD("decode", "bytes"), &SnapshotDecoder::decode);
	ClassDB::bind_method(
			D_METHOD("define_type", "type", "kinds", "mins", "maxs", "resolutions"), &SnapshotDecoder::define_type);
	ClassDB::bind_method(D_METHOD("add_entity", "entity", "type", "values"), &SnapshotDecoder::add_entity);
	ClassDB::bind_method(D_METHOD("remove_entity", "entity"), &SnapshotDecoder::remove_entity);
	ClassDB::bind_method(D_METHOD("set_table_version", "version"), &SnapshotDecoder::set_table_version);
	ClassDB::bind_method(D_METHOD("get_field", "entity", "field"), &SnapshotDecoder::get_field);
	ClassDB::bind_method(D_METHOD("get_changed_entities"), &SnapshotDecoder::get_changed_entities);
	ClassDB::bind_method(D_METHOD("get_command_ack"), &SnapshotDecoder::get_command_ack);
	ClassDB::bind_static_method(
			"SnapshotDecoder", D_METHOD("find_motion_ack", "bytes"), &SnapshotDecoder::find_motion_ack);
	ClassDB::bind_method(D_METHOD("get_unacknowledged"), &SnapshotDecoder::get_unacknowledged);
	ClassDB::bind_method(D_METHOD("get_frame", "person"), &SnapshotDecoder::get_frame);
	ClassDB::bind_method(D_METHOD("set_wants_marks", "wanted"), &SnapshotDecoder::set_wants_marks);
	ClassDB::bind_method(D_METHOD("get_ack", "viewpoint"), &SnapshotDecoder::get_ack);
	ClassDB::bind_method(D_METHOD("get_tick"), &SnapshotDecoder::get_tick);
	ClassDB::bind_method(D_METHOD("get_tick_rate"), &SnapshotDecoder::get_tick_rate);
	ClassDB::bind_method(D_METHOD("get_mark"), &SnapshotDecoder::get_mark);
	ClassDB::bind_method(D_METHOD("get_people"), &SnapshotDecoder::get_people);
	ClassDB::bind_method(D_METHOD("get_bodies"), &SnapshotDecoder::get_bodies);
	ClassDB::bind_method(D_METHOD("get_orientations", "person"), &SnapshotDecoder::get_orientations);
	ClassDB::bind_method(D_METHOD("get_root", "person"), &SnapshotDecoder::get_root);
	ClassDB::bind_method(D_METHOD("get_body_transform", "body"), &SnapshotDecoder::get_body_transform);
	ClassDB::bind_method(D_METHOD("has_body", "body"), &SnapshotDecoder::has_body);
	ClassDB::bind_method(D_METHOD("get_body_velocity", "body"), &SnapshotDecoder::get_body_velocity);
	ClassDB::bind_method(D_METHOD("get_body_spin", "body"), &SnapshotDecoder::get_body_spin);
	ClassDB::bind_method(D_METHOD("clear"), &SnapshotDecoder::clear);
	BIND_ENUM_CONSTANT(OK);
	BIND_ENUM_CONSTANT(BROKEN);
	BIND_ENUM_CONSTANT(STALE);
	BIND_ENUM_CONSTANT(LACKS_BASELINE);
	BIND_ENUM_CONSTANT(NOT_BEGUN);
}

} // namespace godot
