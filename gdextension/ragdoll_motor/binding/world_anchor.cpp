// SPDX-License-Identifier: MIT
#include "world_anchor.hpp"

#include "joint_motors.hpp"

#include <convert.hpp>

#include <godot_cpp/classes/physics_direct_body_state3d.hpp>

namespace godot {

namespace {

// The joint's force has an arm of the distance from the world's origin, 1 km at most: 1e6 N m turn it by 3e-10 rad.
constexpr float MASS = 1e9f; // kg
constexpr float INERTIA = 1e12f; // kg m^2

} // namespace

void WorldAnchor::make(const RID &p_space) {
	using Body = PhysicsServer3D;
	free();
	_body = server()->body_create();
	server()->body_set_mode(_body, Body::BODY_MODE_RIGID);
	server()->body_set_collision_layer(_body, 0);
	server()->body_set_collision_mask(_body, 0);
	server()->body_set_param(_body, Body::BODY_PARAM_MASS, MASS);
	server()->body_set_param(_body, Body::BODY_PARAM_INERTIA, Vector3(INERTIA, INERTIA, INERTIA));
	server()->body_set_param(_body, Body::BODY_PARAM_GRAVITY_SCALE, 0.0);
	server()->body_set_param(_body, Body::BODY_PARAM_LINEAR_DAMP_MODE, Body::BODY_DAMP_MODE_REPLACE);
	server()->body_set_param(_body, Body::BODY_PARAM_LINEAR_DAMP, 0.0);
	server()->body_set_param(_body, Body::BODY_PARAM_ANGULAR_DAMP_MODE, Body::BODY_DAMP_MODE_REPLACE);
	server()->body_set_param(_body, Body::BODY_PARAM_ANGULAR_DAMP, 0.0);
	server()->body_set_space(_body, p_space);
}

void WorldAnchor::free() {
	if (_body.is_valid()) {
		server()->free_rid(_body);
		_body = RID();
	}
}

ragdoll::Residual WorldAnchor::weigh(const ragdoll::Vec3 &p_at, float p_delta_s) {
	PhysicsDirectBodyState3D *state = server()->body_get_direct_state(_body);
	if (state == nullptr) {
		return {};
	}
	const ragdoll::Vec3 force = to_core(state->get_linear_velocity()) * (-MASS / p_delta_s);
	const ragdoll::Vec3 about_origin = to_core(state->get_angular_velocity()) * (-INERTIA / p_delta_s);
	state->set_linear_velocity(Vector3());
	state->set_angular_velocity(Vector3());
	// Bit by bit where it was: a state that is restored has to go on as the one that was saved.
	state->set_transform(Transform3D());
	return { force, about_origin - p_at.cross(force) };
}

} // namespace godot
