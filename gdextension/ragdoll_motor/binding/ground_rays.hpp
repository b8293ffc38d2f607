// SPDX-License-Identifier: MIT
#pragma once

#include <gait/ground.hpp>

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/classes/ray_cast3d.hpp>
#include <godot_cpp/variant/rid.hpp>

#include <vector>

namespace godot {

/// The ground under a point, found by rays straight down into the physics world.
class GroundRays : public ragdoll::Ground {
public:
	/// A ray begins so far above the point (m): steps that a foot may stand on are not higher.
	static constexpr float ABOVE = 0.35f;
	/// And ends so far below, m.
	static constexpr float BELOW = 1.0f;

	/// Makes the node that casts, as a child of another that is in the tree.
	void attach(Node *p_parent, const std::vector<RID> &p_ignored, std::uint32_t p_mask);
	/// Frees it.
	void detach();
	/// Height of the highest ground between ABOVE and BELOW the point, m; NaN where there is none.
	float height(const ragdoll::Vec3 &p_at) const override;

private:
	RayCast3D *_ray = nullptr; // The parent owns it.
};

} // namespace godot
