// SPDX-License-Identifier: MIT
#include "impact_watch.hpp"

#include <godot_cpp/classes/physics_server3d.hpp>

#include <algorithm>

namespace godot {

namespace {

/// Contacts that the engine keeps of each body: the corners of a face.
constexpr int CONTACTS = 4;
/// Impacts and scrapes of a step.
constexpr std::size_t MOST = 16;

PhysicsServer3D *server() {
	return PhysicsServer3D::get_singleton();
}

} // namespace

void ImpactWatch::watch(int64_t p_entity, const RID &p_body, int64_t p_group) {
	ERR_FAIL_COND_MSG(!p_body.is_valid(), "There is no such body to watch.");
	if (_by_body.count(std::uint64_t(p_body.get_id())) != 0) {
		return;
	}
	if (server()->body_get_max_contacts_reported(p_body) < CONTACTS) {
		server()->body_set_max_contacts_reported(p_body, CONTACTS);
	}
	_by_body[std::uint64_t(p_body.get_id())] = _bodies.size();
	_bodies.push_back({ p_body, p_entity, p_group });
}

void ImpactWatch::forget(int64_t p_entity) {
	for (const Watched &watched : _bodies) {
		if (watched.entity == p_entity) {
			_detector.forget(std::uint64_t(watched.body.get_id()));
		}
	}
	const auto gone = [p_entity](const Watched &p_watched) { return p_watched.entity == p_entity; };
	_bodies.erase(std::remove_if(_bodies.begin(), _bodies.end(), gone), _bodies.end());
	_by_body.clear();
	for (std::size_t i = 0; i < _bodies.size(); i++) {
		_by_body[std::uint64_t(_bodies[i].body.get_id())] = i;
	}
}

void ImpactWatch::clear() {
	_bodies.clear();
	_by_body.clear();
	_found.clear();
	_detector = contact::ImpactDetector();
}

int64_t ImpactWatch::advance() {
	_touches.clear();
	_places.clear();
	_found.clear();
	for (const Watched &watched : _bodies) {
		_read(watched);
	}
	for (const contact::Impact &impact : _detector.advance(_touches, MOST)) {
		_found.push_back({ impact, _places[impact.tag] });
	}
	return int64_t(_found.size());
}

void ImpactWatch::_read(const Watched &p_watched) {
	PhysicsDirectBodyState3D *state = server()->body_get_direct_state(p_watched.body);
	// Null for a body that has been freed or is in no space.
	if (state == nullptr || state->is_sleeping()) {
		return;
	}
	const int count = int(state->get_contact_count());
	if (count == 0) {
		return;
	}
	const float inverse = float(state->get_inverse_mass());
	for (int i = 0; i < count; i++) {
		_add(p_watched, *state, i, inverse > 0.0f ? 1.0f / inverse : 1.0f);
	}
}

void ImpactWatch::_add(const Watched &p_watched, PhysicsDirectBodyState3D &r_state, int p_contact, float p_mass) {
	const RID other = r_state.get_contact_collider(p_contact);
	const auto number = std::uint64_t(other.get_id());
	const auto known = _by_body.find(number);
	const Watched *also = known != _by_body.end() ? &_bodies[known->second] : nullptr;
	if (also != nullptr && also->group == p_watched.group && p_watched.group != 0) {
		return;
	}
	const auto own = std::uint64_t(p_watched.body.get_id());
	// Two that are watched both say so: the first one's word counts.
	if (also != nullptr && number < own) {
		return;
	}
	const Vector3 normal = r_state.get_contact_local_normal(p_contact);
	Vector3 slip = r_state.get_contact_local_velocity_at_position(p_contact) -
			r_state.get_contact_collider_velocity_at_position(p_contact);
	slip -= normal * normal.dot(slip);
	contact::Touch touch;
	touch.pair = { std::min(own, number), std::max(own, number) };
	touch.impulse = float(r_state.get_contact_impulse(p_contact).length());
	touch.mass = p_mass;
	touch.slip = float(slip.length());
	touch.tag = _places.size();
	_touches.push_back(touch);
	_places.push_back({ r_state.get_contact_collider_position(p_contact), p_watched.entity,
			also != nullptr ? also->entity : -1, int64_t(r_state.get_contact_collider_id(p_contact)) });
}

int64_t ImpactWatch::get_entity(int64_t p_impact) const {
	return _has(p_impact) ? _found[std::size_t(p_impact)].place.entity : -1;
}

int64_t ImpactWatch::get_other_entity(int64_t p_impact) const {
	return _has(p_impact) ? _found[std::size_t(p_impact)].place.other : -1;
}

int64_t ImpactWatch::get_other_instance(int64_t p_impact) const {
	return _has(p_impact) ? _found[std::size_t(p_impact)].place.instance : 0;
}

Vector3 ImpactWatch::get_place(int64_t p_impact) const {
	return _has(p_impact) ? _found[std::size_t(p_impact)].place.point : Vector3();
}

double ImpactWatch::get_impulse(int64_t p_impact) const {
	return _has(p_impact) ? double(_found[std::size_t(p_impact)].impact.impulse) : 0.0;
}

double ImpactWatch::get_slip(int64_t p_impact) const {
	return _has(p_impact) ? double(_found[std::size_t(p_impact)].impact.slip) : 0.0;
}

void ImpactWatch::_bind_methods() {
	ClassDB::bind_method(D_METHOD("watch", "entity", "body", "group"), &ImpactWatch::watch, DEFVAL(0));
	ClassDB::bind_method(D_METHOD("forget", "entity"), &ImpactWatch::forget);
	ClassDB::bind_method(D_METHOD("clear"), &ImpactWatch::clear);
	ClassDB::bind_method(D_METHOD("advance"), &ImpactWatch::advance);
	ClassDB::bind_method(D_METHOD("get_entity", "impact"), &ImpactWatch::get_entity);
	ClassDB::bind_method(D_METHOD("get_other_entity", "impact"), &ImpactWatch::get_other_entity);
	ClassDB::bind_method(D_METHOD("get_other_instance", "impact"), &ImpactWatch::get_other_instance);
	ClassDB::bind_method(D_METHOD("get_place", "impact"), &ImpactWatch::get_place);
	ClassDB::bind_method(D_METHOD("get_impulse", "impact"), &ImpactWatch::get_impulse);
	ClassDB::bind_method(D_METHOD("get_slip", "impact"), &ImpactWatch::get_slip);
}

} // namespace godot
