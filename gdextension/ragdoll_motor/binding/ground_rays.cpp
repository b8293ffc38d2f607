// SPDX-License-Identifier: MIT
#include "ground_rays.hpp"

#include <convert.hpp>

#include <godot_cpp/core/memory.hpp>

#include <limits>

namespace godot {

void GroundRays::attach(Node *p_parent, const std::vector<RID> &p_ignored, std::uint32_t p_mask) {
	if (!_ray) {
		_ray = memnew(RayCast3D);
		_ray->set_enabled(false); // Cast by hand, not once a tick.
		_ray->set_target_position(Vector3(0.0f, -(ABOVE + BELOW), 0.0f));
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
	if (!_ray) {
		return std::numeric_limits<float>::quiet_NaN();
	}
	_ray->set_position(from_core(p_at) + Vector3(0.0f, ABOVE, 0.0f));
	_ray->force_raycast_update();
	return _ray->is_colliding() ? float(_ray->get_collision_point().y) : std::numeric_limits<float>::quiet_NaN();
}

} // namespace godot
