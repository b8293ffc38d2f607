// SPDX-License-Identifier: MIT
#include "body_surroundings.hpp"

#include <convert.hpp>

#include <godot_cpp/classes/physics_server3d.hpp>

#include <algorithm>
#include <tuple>

namespace godot {

namespace {

constexpr double MARGIN = 0.001; // m

PhysicsServer3D *server() {
	return PhysicsServer3D::get_singleton();
}

bool comes_first(const mover::Contact &p_one, const mover::Contact &p_other) {
	const auto key = [](const mover::Contact &p_contact) {
		return std::make_tuple(-p_contact.normal.y, p_contact.carrier, p_contact.normal.x, p_contact.normal.z);
	};
	return key(p_one) < key(p_other);
}

} // namespace

BodySurroundings::BodySurroundings() {
	_parameters.instantiate();
	_result.instantiate();
	_parameters->set_margin(MARGIN);
	_parameters->set_max_collisions(int(mover::Sweep().contacts.size()));
	for (std::size_t i = 0; i < _bodies.size(); i++) {
		_bodies[i] = server()->body_create();
		_shapes[i] = server()->cylinder_shape_create();
		Dictionary size;
		size["radius"] = mover::RADIUS;
		size["height"] = mover::HEIGHTS[i];
		server()->shape_set_data(_shapes[i], size);
		server()->body_set_mode(_bodies[i], PhysicsServer3D::BODY_MODE_KINEMATIC);
		// The foot's middle is its origin.
		server()->body_add_shape(_bodies[i], _shapes[i], Transform3D(Basis(), Vector3(0, mover::HEIGHTS[i] / 2, 0)));
		server()->body_set_collision_layer(_bodies[i], 0);
	}
}

BodySurroundings::~BodySurroundings() {
	for (std::size_t i = 0; i < _bodies.size(); i++) {
		server()->free_rid(_bodies[i]);
		server()->free_rid(_shapes[i]);
	}
}

void BodySurroundings::enter(const RID &p_space, const Ref<Resource> &p_world, std::uint32_t p_mask) {
	for (const RID &body : _bodies) {
		server()->body_set_collision_mask(body, p_mask);
		server()->body_set_space(body, p_space);
	}
	_world = p_world;
}

void BodySurroundings::set_carrier(const RID &p_body, std::uint32_t p_number) {
	const auto known = _numbers.find(p_body.get_id());
	if (known != _numbers.end()) {
		_carriers.erase(known->second);
		_numbers.erase(known);
	}
	if (p_number != 0) {
		_numbers[p_body.get_id()] = p_number;
		_carriers[p_number] = p_body;
	}
}

void BodySurroundings::set_ladder(const RID &p_body, bool p_is_ladder) {
	if (p_is_ladder) {
		_ladders[p_body.get_id()] = true;
	} else {
		_ladders.erase(p_body.get_id());
	}
}

void BodySurroundings::set_passable(const RID &p_body, bool p_is_passable) {
	_passable.erase(p_body);
	if (p_is_passable) {
		_passable.push_back(p_body);
	}
	_parameters->set_exclude_bodies(_passable);
}

void BodySurroundings::clear() {
	_numbers.clear();
	_carriers.clear();
	_ladders.clear();
	_passable.clear();
	_parameters->set_exclude_bodies(_passable);
}

void BodySurroundings::sweep(
		mover::Stance p_stance, const mover::Vec3 &p_from, const mover::Vec3 &p_motion, mover::Sweep &r_sweep) const {
	_parameters->set_from(Transform3D(Basis(), from_core(p_from)));
	_parameters->set_motion(from_core(p_motion));
	const RID &body = _bodies[std::size_t(p_stance)];
	r_sweep.is_stopped = server()->body_test_motion(body, _parameters, _result);
	r_sweep.travel = to_core(_result->get_travel());
	r_sweep.left = to_core(_result->get_remainder());
	r_sweep.count = r_sweep.is_stopped ? int(_result->get_collision_count()) : 0;
	r_sweep.count = std::min(r_sweep.count, int(r_sweep.contacts.size()));
	for (int i = 0; i < r_sweep.count; i++) {
		mover::Contact &contact = r_sweep.contacts[std::size_t(i)];
		contact.normal = to_core(_result->get_collision_normal(i));
		const std::uint64_t collider = _result->get_collider_rid(i).get_id();
		const auto carrier = _numbers.find(collider);
		contact.carrier = carrier == _numbers.end() ? 0 : carrier->second;
		contact.is_ladder = _ladders.count(collider) != 0;
	}
	// The engine lists what is equally near in an order that depends on what has moved before.
	std::sort(r_sweep.contacts.begin(), r_sweep.contacts.begin() + r_sweep.count, comes_first);
}

bool BodySurroundings::find_frame(std::uint32_t p_carrier, mover::Frame &r_frame) const {
	const auto found = _carriers.find(p_carrier);
	if (found == _carriers.end()) {
		return false;
	}
	const Transform3D frame = server()->body_get_state(found->second, PhysicsServer3D::BODY_STATE_TRANSFORM);
	r_frame.origin = to_core(frame.origin);
	r_frame.turn = to_core(frame.basis.orthonormalized());
	return true;
}

} // namespace godot
