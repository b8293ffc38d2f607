// SPDX-License-Identifier: MIT
#pragma once

#include <world/obstacles.hpp>

#include <godot_cpp/classes/physics_ray_query_parameters3d.hpp>
#include <godot_cpp/classes/physics_test_motion_parameters3d.hpp>
#include <godot_cpp/classes/physics_test_motion_result3d.hpp>
#include <godot_cpp/classes/ref.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <cstdint>
#include <vector>

namespace godot {

/// What stands in people's way, found by moving a limb's shapes through the physics world.
class ObstacleSweep : public ragdoll::Obstacles {
public:
	/// Takes the bodies of the limbs, and the space that they are in.
	void attach(const std::vector<RID> &p_bodies, const RID &p_space);
	/// The layers that can hold somebody back: the world and props, not people.
	void set_mask(std::uint32_t p_mask) { _mask = p_mask; }
	bool is_in_way(std::size_t p_limb, const ragdoll::Quat &p_orientation, const ragdoll::Vec3 &p_centre,
			const ragdoll::Vec3 &p_motion) const override;
	bool find_between(const ragdoll::Vec3 &p_from, const ragdoll::Vec3 &p_to, ragdoll::Hit &r_hit) const override;

private:
	bool stands_firm(const RID &p_body) const;
	static ragdoll::Vec3 find_velocity(const RID &p_body, const Vector3 &p_at);

	std::vector<RID> _bodies;
	RID _space;
	TypedArray<RID> _own; // The same.
	std::uint32_t _mask = 0;
	Ref<PhysicsTestMotionParameters3D> _parameters;
	Ref<PhysicsTestMotionResult3D> _result;
	Ref<PhysicsRayQueryParameters3D> _ray;
};

} // namespace godot
