// SPDX-License-Identifier: MIT
#include "ground_rays.hpp"

#include "../../kinematics/binding/convert.hpp"

#include <godot_cpp/core/memory.hpp>

#include <limits>

namespace godot {

void GroundRays::attach(Node *p_parent, const std::vector<RID> &p_ignored, std::uint32_t p_mask) {
	if (!ray) {
		ray = memnew(RayCast3D);
		ray->set_enabled(false); // Cast by hand, not once a tick.
		ray->set_target_position(Vector3(0.0f, -(ABOVE + BELOW), 0.0f));
		p_parent->add_child(ray, false, Node::INTERNAL_MODE_FRONT);
	}
	ray->set_collision_mask(p_mask);
	ray->clear_exceptions();
	for (const RID &body : p_ignored) {
		ray->add_exception_rid(body);
	}
}

void GroundRays::detach() {
	if (ray) {
		ray->queue_free();
		ray = nullptr;
	}
}

float GroundRays::height(const ragdoll::Vec3 &p_at) const {
	if (!ray) {
		return std::numeric_limits<float>::quiet_NaN();
	}
	ray->set_position(from_core(p_at) + Vector3(0.0f, ABOVE, 0.0f));
	ray->force_raycast_update();
	return ray->is_colliding() ? float(ray->get_collision_point().y) : std::numeric_limits<float>::quiet_NaN();
}

} // namespace godot
