// SPDX-License-Identifier: MIT
#pragma once

#include "running_gear.hpp"

#include <track.hpp>

namespace godot {

/// Rigid spheres on damped sliders with angular motors. Documented in doc_classes/SphereRunningGear.xml.
class SphereRunningGear : public RunningGear {
	GDCLASS(SphereRunningGear, RunningGear)

public:
	~SphereRunningGear() override;

protected:
	static void _bind_methods() {}

	bool make() override;
	void unmake() override;
	void read(float p_delta) override;
	void drive(float p_delta) override;
	void put() override;
	Ground ground_of(std::size_t p_wheel) override;
	void list_bodies(TypedArray<RID> &r_bodies) const override;

private:
	/// A sphere, its two joints, and what was last written to them.
	struct Sphere {
		RID body;
		RID slider;
		RID motor;
		float target = 0.0f;
		float force = 0.0f;
		float across = 0.0f;
	};

	void make_sphere(const Wheel &p_wheel, Sphere &r_sphere);
	void write(const Wheel &p_wheel, Sphere &r_sphere, float p_target, float p_force, float p_across);
	/// Whether a sphere is where its slider cannot hold it: the hull was put elsewhere.
	bool is_torn(const Wheel &p_wheel, const Vector3 &p_offset) const;

	std::vector<Sphere> _spheres;
	std::vector<RID> _shapes;
	std::vector<vehicle::SphereMotor> _motors;
};

} // namespace godot
