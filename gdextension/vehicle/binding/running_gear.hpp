// SPDX-License-Identifier: MIT
#pragma once

#include "drivetrain.hpp"
#include "vehicle_wheel.hpp"

#include <godot_cpp/classes/node3d.hpp>
#include <godot_cpp/classes/physics_direct_body_state3d.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/transform3d.hpp>
#include <godot_cpp/variant/typed_array.hpp>

#include <vector>

namespace godot {

/// What is between a vehicle's hull and the ground. Documented in doc_classes/RunningGear.xml.
class RunningGear : public RefCounted {
	GDCLASS(RunningGear, RefCounted)

public:
	~RunningGear() override = default;

	bool setup(Node3D *p_hull, const RID &p_body, const RID &p_space, const TypedArray<VehicleWheel> &p_wheels,
			const Ref<VehicleDrivetrain> &p_drivetrain);
	void release();
	bool is_set_up() const { return !_wheels.empty(); }
	void step(double p_delta);
	void place();

	double get_left_speed() const { return _motion.left; }
	double get_right_speed() const { return _motion.right; }
	int64_t get_wheel_count() const { return int64_t(_wheels.size()); }
	TypedArray<RID> get_bodies() const;
	Transform3D get_wheel_transform(int64_t p_wheel) const;
	double get_wheel_compression(int64_t p_wheel) const;
	double get_wheel_load(int64_t p_wheel) const;
	double get_wheel_speed(int64_t p_wheel) const;
	double get_wheel_slip(int64_t p_wheel);
	bool is_wheel_on_ground(int64_t p_wheel);
	Vector3 get_contact_point(int64_t p_wheel);
	Vector3 get_ground_velocity(int64_t p_wheel);

	void set_rolling_resistance(double p_share) { _rolling_resistance = float(p_share); }
	double get_rolling_resistance() const { return _rolling_resistance; }
	void set_drag_area(double p_area) { _drag_area = float(p_area); }
	double get_drag_area() const { return _drag_area; }
	void set_collision_mask(int64_t p_mask) { _collision_mask = p_mask; }
	int64_t get_collision_mask() const { return _collision_mask; }
	void set_collision_layer(int64_t p_layer) { _collision_layer = p_layer; }
	int64_t get_collision_layer() const { return _collision_layer; }

protected:
	static void _bind_methods();

	/// A wheel as both kinds of gear have it. Sides are 0 (left) and 1 (right); wheels are sorted by them.
	struct Wheel {
		Vector3 position; // At rest, in the hull's frame.
		float radius = 0.5f;
		float mass = 1.0f;
		float stiffness = 0.0f;
		float damping = 0.0f;
		float sag = 0.0f;
		float travel_up = 0.0f;
		float travel_down = 0.0f;
		float grip = 1.0f;
		float side_grip = 1.0f;
		int rays = 1;
		bool is_driven = true;
		bool is_steered = false;
		bool is_parked = true;
		int side = 0;
		int given = 0; // Its number among those that were given.
		// From step to step.
		float height = 0.0f; // Above where it is at rest, m.
		float load = 0.0f; // N.
		float speed = 0.0f; // At the rim, m/s.
		float angle = 0.0f; // Steered, rad.
		float turn = 0.0f; // How far it has rolled, rad.
	};

	/// Of the ground under a wheel.
	struct Ground {
		bool is_there = false;
		Vector3 point;
		Vector3 normal{ 0.0f, 1.0f, 0.0f };
		Vector3 velocity;
	};

	virtual bool make() = 0;
	virtual void unmake() = 0;
	/// Reads what the wheels do: their loads, speeds, heights.
	virtual void read(float p_delta) = 0;
	/// Applies what the drivetrain gives.
	virtual void drive(float p_delta) = 0;
	virtual void put() = 0;
	virtual Ground ground_of(std::size_t p_wheel) = 0;
	virtual void list_bodies(TypedArray<RID> &r_bodies) const;

	std::size_t first_of(int p_side) const { return p_side == 0 ? 0 : _left_count; }
	std::size_t count_of(int p_side) const { return p_side == 0 ? _left_count : _wheels.size() - _left_count; }
	const Wheel *wheel_at(int64_t p_wheel) const;
	/// The way that a wheel rolls which is turned by an angle (rad, to the left positive).
	Vector3 heading(float p_angle) const;
	Vector3 velocity_at(const Vector3 &p_point) const; // Of the hull, in the world.

	Node3D *_hull = nullptr;
	RID _body;
	RID _space;
	std::vector<Wheel> _wheels;
	std::vector<std::size_t> _order; // From the given number to ours.
	std::size_t _left_count = 0;
	Ref<VehicleDrivetrain> _drivetrain;
	vehicle::DriveMotion _motion;
	float _rolling_resistance = 0.02f;
	float _drag_area = 0.0f;
	int64_t _collision_mask = 7;
	int64_t _collision_layer = 4;
	// Of the hull in this step.
	Transform3D _frame;
	Vector3 _velocity; // Of its centre of mass.
	Vector3 _turning;
	Vector3 _centre; // In the world.
};

} // namespace godot
