// SPDX-License-Identifier: MIT
#pragma once

#include "running_gear.hpp"

#include <rim.hpp>

#include <godot_cpp/classes/physics_direct_space_state3d.hpp>
#include <godot_cpp/classes/physics_ray_query_parameters3d.hpp>

namespace godot {

/// Rays with springs and a brush model of the tread. Documented in doc_classes/RayRunningGear.xml.
class RayRunningGear : public RunningGear {
	GDCLASS(RayRunningGear, RunningGear)

public:
	~RayRunningGear() override;

protected:
	static void _bind_methods() {}

	bool make() override;
	void unmake() override;
	void read(float p_delta) override;
	void drive(float p_delta) override;
	void put() override;
	Ground ground_of(std::size_t p_wheel) override;

private:
	/// What a wheel stands on.
	struct Contact {
		Ground ground;
		RID body; // Where it can be pushed.
		float mass = 0.0f; // Of that body, kg.
		Vector3 ahead; // Axes in the plane of the ground.
		Vector3 aside;
	};

	void cast(std::size_t p_wheel, PhysicsDirectSpaceState3D *p_space);
	void meet(std::size_t p_wheel, const Dictionary &p_hit);
	void find_load(std::size_t p_wheel);
	void turn_rims(const vehicle::SideForces &p_forces, float p_delta);
	void push(std::size_t p_wheel);

	std::vector<Contact> _contacts;
	std::vector<vehicle::Patch> _patches;
	std::vector<vehicle::Rim> _rims; // One for each side of a tracked vehicle, one for each wheel of another.
	float _axle = 0.0f; // Where the wheels are that are not steered, along the hull's z.
	Ref<PhysicsRayQueryParameters3D> _query;
};

} // namespace godot
