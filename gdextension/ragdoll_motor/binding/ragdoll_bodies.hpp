// SPDX-License-Identifier: MIT
#pragma once

#include "comparison/root_assist.hpp"
#include "joint_motors.hpp"
#include "limb_joint.hpp"
#include "world_anchor.hpp"

#include <control/world_drive.hpp>
#include <joint/controller.hpp>
#include <root/root_drive.hpp>

#include <godot_cpp/classes/physics_direct_body_state3d.hpp>
#include <godot_cpp/classes/physics_server3d.hpp>
#include <godot_cpp/variant/rid.hpp>
#include <godot_cpp/variant/transform3d.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace godot {

/// The bodies of a ragdoll in the physics engine, and the joints that this class makes for them.
///
/// One 6DOF joint a limb, parent = A, limb = B; made from the leaves to the root, the joint to the
/// world last, because the order of making is the order of solving. The joints and the anchor go
/// with this object; the bodies belong to somebody else.
class RagdollBodies {
public:
	/// How a limb's joint is made.
	struct JointSpec {
		RID body;
		/// The axes of the joint in the limb's frame: X along the limb where there are limits.
		ragdoll::Quat axes;
		bool has_limits = false;
		Vector3 lower; ///< rad about the joint's axes, from the reset pose
		Vector3 upper;
	};

	RagdollBodies() = default;
	~RagdollBodies();
	RagdollBodies(const RagdollBodies &) = delete;
	RagdollBodies &operator=(const RagdollBodies &) = delete;

	/// Makes the joints. The limbs' `rest` orientations are those of the reset pose.
	void make(const ragdoll::Rig &p_rig, std::vector<JointSpec> p_specs, const RID &p_space);
	/// Makes the joints anew and lets the bodies enter the space anew: they forget what the engine's
	/// solver remembers of the last steps, of joints and of contacts.
	void remake();
	/// Sets what a body needs to be driven well: inertia, continuous collision detection, no sleep.
	void prepare(bool p_self_collision);

	/// The state of the bodies; false (and an error, once) where one is not there.
	bool read(ragdoll::RigState &r_state);
	void write(const std::vector<ragdoll::LimbCommand> &p_commands, const std::vector<ragdoll::Quat> &p_orientations,
			const std::vector<ragdoll::Vec3> &p_joints);
	/// Forces and torques of this step on limbs that are simulated, besides their joints'.
	void push_limbs(
			const std::vector<ragdoll::LimbCommand> &p_commands, const std::vector<ragdoll::LimbPush> &p_pushes);
	/// Lowers what a limb's motor was given last to a share at once: the next step may come before the next
	/// commands, and would stop a blow with all its torque. The root's upward force stays.
	void weaken(std::size_t p_limb, float p_share);
	/// Gives a body an impulse (N s) at a position from its origin (m), both in world axes.
	void strike(std::size_t p_limb, const Vector3 &p_impulse, const Vector3 &p_position);
	/// Sets the root's hold: kinematic at a pose, or by limited forces.
	void hold_root(const ragdoll::Quat &p_orientation, const ragdoll::Vec3 &p_joint);
	void pull_root(ragdoll::RootMode p_mode, const ragdoll::RootCommand &p_command, const ragdoll::Vec3 &p_turn);
	/// What the joint to the world did to the root in the last step of p_delta_s seconds, about the root's joint at
	/// p_at, m.
	ragdoll::Residual weigh_hold(const ragdoll::Vec3 &p_at, float p_delta_s) { return _anchor.weigh(p_at, p_delta_s); }
	/// The joint that holds a limb.
	const RID &get_joint(std::size_t p_limb) const { return _joints[p_limb].get_rid(); }
	/// The limb that SELF_RIGHTING keeps upright besides the root.
	void set_righted_limb(int p_limb) { _righted_limb = p_limb; }
	/// Puts all bodies somewhere, with these velocities.
	void put(const ragdoll::RigState &p_state);

private:
	struct Hold {
		float across = -1.0f;
		float up = -1.0f;
	};

	RID make_joint(const RID &p_a, const Transform3D &p_frame_a, std::size_t p_limb);
	void set_assist(ragdoll::RootMode p_mode);
	std::unique_ptr<RootAssist> make_assist(ragdoll::RootMode p_mode);
	RootAssist::Handle find_handle(std::size_t p_limb) const;
	void set_forces(const ragdoll::RootCommand &p_command);
	void free_all();
	Transform3D frame_in_body(std::size_t p_limb) const;
	ragdoll::Vec3 find_gravity();
	void set_kinematic(std::size_t p_limb, bool p_kinematic);
	void set_pose(std::size_t p_limb, const ragdoll::Quat &p_orientation, const ragdoll::Vec3 &p_joint);
	void push(std::size_t p_limb, const ragdoll::LimbCommand &p_command);

	const ragdoll::Rig *_rig = nullptr;
	std::vector<JointSpec> _specs;
	std::vector<LimbJoint> _joints;
	std::vector<bool> _is_set; // DIRECT_SET: the body is kinematic.
	std::vector<PhysicsDirectBodyState3D *> _states; // Of this tick.
	Hold _hold;
	bool _is_lost = false; // A body was not there at the last reading.
	RID _space;
	bool _has_stepped = false; // The space, since the joints were made.
	uint64_t _first_frame = 0; // At whose end the space steps for the first time.
	WorldAnchor _anchor;
	std::unique_ptr<RootAssist> _assist; // Null unless the root is free.
	int _righted_limb = -1;
};

} // namespace godot
