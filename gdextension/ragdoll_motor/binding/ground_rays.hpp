// SPDX-License-Identifier: MIT
#pragma once

#include <world/ground.hpp>

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/classes/ray_cast3d.hpp>
#include <godot_cpp/variant/rid.hpp>

#include <vector>

namespace godot {

/// The ground under a point, found by rays straight down into the physics world.
class GroundRays : public ragdoll::Ground {
public:
	/// A ray ends so far below the point, m.
	static constexpr float BELOW = 1.0f;

	/// Bodies from this mass on (kg) carry people like a platform; lighter ones are pushed about by them.
	static constexpr double HEAVY = 150.0;

	/// Makes the node that casts, as a child of another that is in the tree.
	void attach(Node *p_parent, const std::vector<RID> &p_ignored, std::uint32_t p_mask);
	/// Frees it.
	void detach();
	/// Height of the highest ground between STEP above and BELOW the point, m; NaN where there is none.
	float height(const ragdoll::Vec3 &p_at) const override;
	ragdoll::Footing find(const ragdoll::Vec3 &p_at, float p_above) const override;

private:
	RayCast3D *_ray = nullptr; // The parent owns it.
};

} // namespace godot
