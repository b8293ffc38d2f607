// SPDX-License-Identifier: MIT
#pragma once

#include "base/vectors.hpp"
#include "body/limb_shape.hpp"
#include "body/pose.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ragdoll {

/// A rigid body of a ragdoll and the joint that holds it. A limb's frame has its origin in that joint
/// and the axes of the body.
struct Segment {
	int parent = -1; ///< Index of the limb that holds it, which comes before it; -1 for the root.
	Vec3 anchor; ///< The joint in the parent's frame, m. The root's is ignored.
	Vec3 centre; ///< The body's origin (its centre of mass) in the limb's frame, m.
	Quat rest; ///< Orientation in the pose in which inertias of subtrees are taken.
	float mass = 1.0f; ///< kg
	/// Moments about the limb's axes through the centre, as simulated, kg m^2.
	Vec3 inertia{ 1.0f, 1.0f, 1.0f };
	float max_torque = 0.0f; ///< Greatest torque of the joint, N m. The root's is ignored.
	int group = 0; ///< Index of the strength group.
	bool is_foot = false;
	LimbShape shape;
};

/// Gravity where nothing else is known, m/s^2 (ISO 80000-3, rounded as the engine has it).
constexpr float STANDARD_GRAVITY = 9.81f;

/// What the simulation says of the limbs, all in world axes.
struct RigState {
	std::vector<Quat> orientations;
	std::vector<Vec3> centres; ///< Where the bodies' origins are, m.
	std::vector<Vec3> linear; ///< Velocities of the bodies' origins, m/s.
	std::vector<Vec3> angular; ///< rad/s
	Vec3 root; ///< Where the root limb's joint is, m.
	/// What pulls at the root limb: that of the areas it is in, m/s^2.
	Vec3 gravity{ 0.0f, -STANDARD_GRAVITY, 0.0f };

	void resize(std::size_t p_limb_count);
};

/// The tree of limbs: everything that follows from its geometry and masses alone.
class Rig {
public:
	Rig() = default;
	/// @param p_limbs parents before children, the root first
	explicit Rig(std::vector<Segment> p_limbs);

	std::size_t size() const { return _limbs.size(); }
	const Segment &operator[](std::size_t p_limb) const { return _limbs[p_limb]; }
	/// Mass of all limbs, kg.
	float get_mass() const { return _mass; }
	/// Moments of inertia (kg m^2) of a limb and all that hangs on it about the limb's joint and axes,
	/// in the rest pose: what springs are tuned by. CompositeInertia has them in any pose.
	const Vec3 &get_subtree_inertia(std::size_t p_limb) const { return _subtree_inertia[p_limb]; }

	/// Mass of a limb and all that hangs on it, kg.
	float get_subtree_mass(std::size_t p_limb) const { return _subtree_mass[p_limb]; }
	/// The inertia of the limb alone about its joint, kg m^2.
	const Vec3 &get_own_inertia(std::size_t p_limb) const { return _own_inertia[p_limb]; }

	/// Whether a limb is part of a leg: a foot, or between the root and a foot.
	bool is_in_leg(std::size_t p_limb) const { return _legs[p_limb] != 0; }

	/// World positions of the limbs' joints for a pose, parent first (thesis section 8.1.1, eq. 1-4:
	/// each limb is moved so that the anchors on both bodies match up).
	void joint_positions(const Pose &p_pose, std::vector<Vec3> &r_positions) const;
	/// The whole body's centre of mass for a pose whose joints are known, m.
	Vec3 centre_of_mass(const Pose &p_pose, const std::vector<Vec3> &p_joints) const;
	/// The same of bodies as they are, m, and how fast it moves, m/s.
	Vec3 centre_of_mass(const RigState &p_state) const;
	Vec3 mean_velocity(const RigState &p_state) const;
	/// The joint's position in the world by the state of the limb's own body, m.
	Vec3 joint_of(const RigState &p_state, std::size_t p_limb) const;

private:
	/// The mean of the limbs' values by their masses.
	Vec3 weigh(const std::vector<Vec3> &p_values) const;

	std::vector<Segment> _limbs;
	std::vector<Vec3> _subtree_inertia;
	std::vector<Vec3> _own_inertia;
	std::vector<float> _subtree_mass;
	std::vector<std::uint8_t> _legs;
	float _mass = 0.0f;
};

/// Makes the limbs of a body such that the engine's solver comes close enough to what their joints are to do,
/// in the steps that it has: about its long axis a limb turns no more easily than across (what hangs beyond its
/// joint would wag it), and bodies are heavier to turn than they are.
/// @param p_bearing factor for trunk and legs, which carry the others
/// @param p_hanging factor for head and arms
void scale_inertia(std::vector<Segment> &r_limbs, float p_bearing, float p_hanging);

/// The diagonal of R I R^T: moments about other axes of a body whose products of inertia are small.
Vec3 turned_inertia(const Vec3 &p_moments, const Quat &p_turn);

} // namespace ragdoll
