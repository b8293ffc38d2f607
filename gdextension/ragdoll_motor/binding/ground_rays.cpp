// SPDX-License-Identifier: MIT
#include "ground_rays.hpp"

#include <convert.hpp>

#include <godot_cpp/classes/physics_direct_body_state3d.hpp>
#include <godot_cpp/classes/physics_server3d.hpp>
#include <godot_cpp/core/memory.hpp>

namespace godot {

void GroundRays::attach(Node *p_parent, const std::vector<RID> &p_ignored, std::uint32_t p_mask) {
	if (!_ray) {
		_ray = memnew(RayCast3D);
		_ray->set_enabled(false); // Cast by hand, not once a tick.
		p_parent->add_child(_ray, false, Node::INTERNAL_MODE_FRONT);
	}
	_ray->set_collision_mask(p_mask);
	_ray->clear_exceptions();
	for (const RID &body : p_ignored) {
		_ray->add_exception_rid(body);
	}
}

void GroundRays::detach() {
	if (_ray) {
		_ray->queue_free();
		_ray = nullptr;
	}
}

float GroundRays::height(const ragdoll::Vec3 &p_at) const {
	return find(p_at, STEP).height;
}

ragdoll::Footing GroundRays::find(const ragdoll::Vec3 &p_at, float p_above) const {
	ragdoll::Footing found;
	if (!_ray) {
		return found;
	}
	_ray->set_position(from_core(p_at) + Vector3(0.0f, p_above, 0.0f));
	_ray->set_target_position(Vector3(0.0f, -(p_above + BELOW), 0.0f));
	_ray->force_raycast_update();
	if (!_ray->is_colliding()) {
		return found;
	}
	found.height = float(_ray->get_collision_point().y);
	const RID body = _ray->get_collider_rid();
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	const PhysicsServer3D::BodyMode mode = server->body_get_mode(body);
	if (mode == PhysicsServer3D::BODY_MODE_STATIC) {
		return found;
	}
	const double mass = server->body_get_param(body, PhysicsServer3D::BODY_PARAM_MASS);
	found.is_loose = mode != PhysicsServer3D::BODY_MODE_KINEMATIC && mass < HEAVY;
	if (found.is_loose) {
		return found; // A crate goes where the feet on it push it, and must not take them along then.
	}
	found.velocity = to_core(Vector3(server->body_get_state(body, PhysicsServer3D::BODY_STATE_LINEAR_VELOCITY)));
	found.turning = to_core(Vector3(server->body_get_state(body, PhysicsServer3D::BODY_STATE_ANGULAR_VELOCITY)));
	// The engine's velocity is that of the centre of mass.
	const Transform3D frame = server->body_get_state(body, PhysicsServer3D::BODY_STATE_TRANSFORM);
	const PhysicsDirectBodyState3D *state = server->body_get_direct_state(body);
	found.body = std::uint64_t(body.get_id());
	found.orientation = to_core(frame.basis);
	found.origin = to_core(frame.origin);
	found.pivot = to_core(frame.origin + (state != nullptr ? state->get_center_of_mass() : Vector3()));
	return found;
}

} // namespace godot
