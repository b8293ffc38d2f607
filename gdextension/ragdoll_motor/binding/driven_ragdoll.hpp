// SPDX-License-Identifier: MIT
#pragma once

#include "ground_rays.hpp"
#include "motor_settings.hpp"
#include "obstacle_sweep.hpp"
#include "ragdoll_bodies.hpp"
#include "ragdoll_plan.hpp"
#include <driver.hpp>

#include <godot_cpp/classes/node.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/typed_array.hpp>
#include <godot_cpp/variant/vector3.hpp>

#include <cstdint>
#include <vector>

namespace godot {

/// A ragdoll that is set up in the physics engine: carries the bodies' state to its driver and the driver's
/// commands to the bodies.
class DrivenRagdoll {
public:
	/// @param p_owner the node in whose world the ground is looked for; must live as long
	DrivenRagdoll(Node *p_owner, RagdollPlan p_plan, const MotorSettings &p_settings, const RID &p_space);
	DrivenRagdoll(const DrivenRagdoll &) = delete;
	DrivenRagdoll &operator=(const DrivenRagdoll &) = delete;

	const RagdollPlan &get_plan() const { return _plan; }
	ragdoll::Driver &get_driver() { return _driver; }
	const ragdoll::Driver &get_driver() const { return _driver; }
	/// The bodies' state as it was read or restored last.
	const ragdoll::RigState &get_state() const { return _state; }
	ragdoll::RigState &edit_state() { return _state; }
	/// The joints that hold the limbs.
	TypedArray<RID> get_joints() const;
	bool has_motion() const { return !_driver.get_stream().is_empty(); }

	/// Takes properties over that have changed.
	void apply(const MotorSettings &p_settings);
	/// Gives the node back by which it looks at the ground. Before this object goes, while the owner lives on.
	void leave_ground() { _ground.detach(); }

	/// Reads the bodies' state; false where one is not there.
	bool read() { return _bodies.read(_state); }
	/// The same, unless what was read last is still true.
	bool read_if_old();
	/// Drives the bodies for a step that begins at a moment of the motion. Returns false where they are not there.
	/// @param r_guarded flags of GuardAction: what the guard against explosions had to do
	bool drive(double p_time_s, float p_delta_s, std::uint32_t &r_guarded);
	/// Puts the bodies into the motion's pose, at rest.
	void snap_to(double p_time_s);
	/// Gives the nearest limb an impulse (N s) at a position (m), and lets those around it give way for a moment.
	/// Returns the limb, or -1.
	int hit(const Vector3 &p_impulse, const Vector3 &p_position, float p_strength, float p_blend_s, int p_group);
	/// Puts the bodies where the edited state has them. The joints are new: they know nothing of the impulses of
	/// the time before, and every replay begins the same.
	void put_anew();

private:
	bool is_state_current() const;
	void look_at_ground();

	Node *_owner = nullptr;
	RagdollPlan _plan;
	ragdoll::Driver _driver;
	RagdollBodies _bodies; // After the driver: they refer to its rig.
	GroundRays _ground;
	ObstacleSweep _obstacles;
	std::uint32_t _ground_mask = 0;

	ragdoll::RigState _state; // Kept between ticks, so that a tick allocates nothing.
	/// When the state was read: number of the physics frame, and whether before its step.
	bool _is_state_read = false;
	bool _is_read_in_step = false;
	uint64_t _read_frame = 0;
};

} // namespace godot
