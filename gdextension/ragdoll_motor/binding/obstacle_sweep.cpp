// SPDX-License-Identifier: MIT
#include "obstacle_sweep.hpp"

#include "ground_rays.hpp"

#include <convert.hpp>

#include <godot_cpp/classes/physics_server3d.hpp>
#include <godot_cpp/variant/typed_array.hpp>

namespace godot {

namespace {

constexpr double MARGIN = 0.005; // m
constexpr int MAX_COLLISIONS = 4;

/// Whether a body does not give way to a person.
bool stands_firm(const RID &p_body) {
	PhysicsServer3D *server = PhysicsServer3D::get_singleton();
	const PhysicsServer3D::BodyMode mode = server->body_get_mode(p_body);
	if (mode == PhysicsServer3D::BODY_MODE_STATIC || mode == PhysicsServer3D::BODY_MODE_KINEMATIC) {
		return true;
	}
	return double(server->body_get_param(p_body, PhysicsServer3D::BODY_PARAM_MASS)) >= GroundRays::HEAVY;
}

} // namespace

void ObstacleSweep::attach(const std::vector<RID> &p_bodies) {
	_bodies = p_bodies;
	_parameters.instantiate();
	_result.instantiate();
	TypedArray<RID> own;
	for (const RID &body : p_bodies) {
		own.push_back(body);
	}
	_parameters->set_exclude_bodies(own);
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
	if (!PhysicsServer3D::get_singleton()->body_test_motion(_bodies[p_limb], _parameters, _result)) {
		return false;
	}
	for (int i = 0; i < int(_result->get_collision_count()); i++) {
		if (stands_firm(_result->get_collider_rid(i))) {
			return true;
		}
	}
	return false;
}

} // namespace godot
