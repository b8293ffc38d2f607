// SPDX-License-Identifier: MIT
#include "obstacle_sweep.hpp"

#include "ground_rays.hpp"

#include <convert.hpp>

#include <godot_cpp/classes/physics_direct_body_state3d.hpp>
#include <godot_cpp/classes/physics_direct_space_state3d.hpp>
#include <godot_cpp/classes/physics_server3d.hpp>

namespace godot {

namespace {

constexpr double MARGIN = 0.005; // m
constexpr int MAX_COLLISIONS = 4;
constexpr int MAX_SWEEPS = 8; // Through what gives way.

} // namespace

bool ObstacleSweep::stands_firm(const RID &p_body) const {
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	// Hips that are held are kinematic, but give way when they meet somebody.
	if ((server->body_get_collision_layer(p_body) & _mask) == 0) {
		return false;
	}
	const PhysicsServer3D::BodyMode mode = server->body_get_mode(p_body);
	if (mode == PhysicsServer3D::BODY_MODE_STATIC || mode == PhysicsServer3D::BODY_MODE_KINEMATIC) {
		return true;
	}
	return double(server->body_get_param(p_body, PhysicsServer3D::BODY_PARAM_MASS)) >= GroundRays::HEAVY;
}

void ObstacleSweep::attach(const std::vector<RID> &p_bodies, const RID &p_space) {
	_bodies = p_bodies;
	_space = p_space;
	_ray.instantiate();
	_parameters.instantiate();
	_result.instantiate();
	_own = TypedArray<RID>();
	for (const RID &body : p_bodies) {
		_own.push_back(body);
	}
	_parameters->set_exclude_bodies(_own);
	_ray->set_exclude(_own);
	_parameters->set_margin(MARGIN);
	_parameters->set_max_collisions(MAX_COLLISIONS);
}

bool ObstacleSweep::is_in_way(std::size_t p_limb, const ragdoll::Quat &p_orientation, const ragdoll::Vec3 &p_centre,
		const ragdoll::Vec3 &p_motion) const {
	if (p_limb >= _bodies.size()) {
		return false;
	}
	_parameters->set_from(Transform3D(Basis(from_core(p_orientation)), from_core(p_centre)));
	_parameters->set_motion(from_core(p_motion));
	TypedArray<RID> passed;
	bool is_met = false;
	for (int sweep = 0; sweep < MAX_SWEEPS && !is_met; sweep++) {
		if (!PhysicsServer3D::get_singleton()->body_test_motion(_bodies[p_limb], _parameters, _result)) {
			break;
		}
		// What gives way may hide what does not.
		passed = passed.is_empty() ? TypedArray<RID>(_own.duplicate()) : passed;
		for (int i = 0; i < int(_result->get_collision_count()); i++) {
			const RID body = _result->get_collider_rid(i);
			is_met = is_met || stands_firm(body);
			passed.push_back(body);
		}
		_parameters->set_exclude_bodies(passed);
	}
	if (!passed.is_empty()) {
		_parameters->set_exclude_bodies(_own);
	}
	return is_met;
}

bool ObstacleSweep::find_between(const ragdoll::Vec3 &p_from, const ragdoll::Vec3 &p_to, ragdoll::Hit &r_hit) const {
	PhysicsDirectSpaceState3D *space = PhysicsServer3D::get_singleton()->space_get_direct_state(_space);
	const float length = (p_to - p_from).length();
	if (space == nullptr || !(length > 0.0f)) {
		return false;
	}
	_ray->set_from(from_core(p_from));
	_ray->set_to(from_core(p_to));
	_ray->set_collision_mask(_mask);
	TypedArray<RID> passed;
	bool is_met = false;
	for (int ray = 0; ray < MAX_SWEEPS; ray++) {
		const Dictionary found = space->intersect_ray(_ray);
		if (found.is_empty()) {
			break;
		}
		const RID body = found["rid"];
		if (stands_firm(body)) {
			const Vector3 at = found["position"];
			r_hit.share = (to_core(at) - p_from).length() / length;
			r_hit.normal = to_core(Vector3(found["normal"]));
			r_hit.velocity = find_velocity(body, at);
			is_met = true;
			break;
		}
		// What gives way may hide what does not.
		passed = passed.is_empty() ? TypedArray<RID>(_own.duplicate()) : passed;
		passed.push_back(body);
		_ray->set_exclude(passed);
	}
	if (!passed.is_empty()) {
		_ray->set_exclude(_own); // Only then: the engine takes 16 of them apart each time.
	}
	return is_met;
}

ragdoll::Vec3 ObstacleSweep::find_velocity(const RID &p_body, const Vector3 &p_at) {
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	if (server->body_get_mode(p_body) == PhysicsServer3D::BODY_MODE_STATIC) {
		return {};
	}
	const PhysicsDirectBodyState3D *state = server->body_get_direct_state(p_body);
	return state == nullptr ? ragdoll::Vec3()
							: to_core(state->get_velocity_at_local_position(p_at - state->get_transform().origin));
}

} // namespace godot
