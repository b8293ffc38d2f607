// SPDX-License-Identifier: MIT
#pragma once

#include "body/rig.hpp"

namespace ragdoll {

/// The axis of a solid, as a way through the world: a point s of it (0 to 1) is at from + s * way.
struct SolidAxis {
	Vec3 from; ///< m
	Vec3 way; ///< m

	Vec3 at(float p_share) const { return from + way * p_share; }
};

/// A limb's shape as it lies in the world: a box or a pill about an axis, and for boxes the faces that nothing is
/// pushed out of, as other limbs join there.
struct LimbSolid {
	int limb = 0;
	bool is_box = false;
	Vec3 half; ///< Along its axes, m; of a pill: radius, half of its cylinder, radius. The longest is Y.
	float reach = 0.0f; ///< From the centre to its furthest point, m.
	bool is_closed[6] = {}; ///< Faces of a box: -X, +X, -Y, ...
	Vec3 centre; ///< m
	Vec3 axes[3];

	LimbSolid() = default;
	LimbSolid(const Rig &p_rig, std::size_t p_limb);
	/// Takes it to where a limb lies. The axes are turned by turn_axes() only, as most are in nobody's way.
	/// @param p_joint the limb's joint, m
	void place(const Quat &p_orientation, const Vec3 &p_joint);
	void turn_axes(const Quat &p_orientation);
	/// From its centre to the end of its axis in the limb's frame, m.
	Vec3 get_local_half() const { return _local_axes[1] * half.y; }
	/// How far it reaches from its axis in a direction (a unit vector), m. The ends of boxes are round, too: fingers
	/// bend.
	float find_thickness(const Vec3 &p_direction) const;
	/// A lower bound of the distance from a point to its surface, m; no more than 0 inside.
	float find_distance(const Vec3 &p_point, const Vec3 &p_centre) const;
	/// Where its axis lies.
	SolidAxis get_axis() const { return { centre - axes[1] * half.y, axes[1] * (2.0f * half.y) }; }
	/// Where its axis lies with its limb elsewhere.
	SolidAxis find_axis(const Quat &p_orientation, const Vec3 &p_joint) const;
	/// The place so far (m) outside the middle of a box's face.
	Vec3 find_outside(int p_face, float p_distance) const;

private:
	Vec3 _local_axes[3]; // In the limb's frame.
	Vec3 _local_centre;
};

/// How freely an axis can be moved: its points turn about the first joint of a chain with the middle joint, and some
/// about the middle joint as well.
struct AxisFreedom {
	Vec3 upper_way; ///< Along the upper limb, a unit vector: nothing moves that way by turning it.
	Vec3 lower_way; ///< Along the lower one.
	float low = 0.0f; ///< How much the axis' beginning turns about the middle joint, 0 to 1 ...
	float high = 0.0f; ///< ... and its end.

	/// Square of how far a point goes in a direction where both limbs turn for it, m per m.
	float find_lever(const Vec3 &p_direction, float p_share) const;
};

/// Where the axis of one solid comes nearest to another.
struct Approach {
	float distance = 0.0f; ///< To the other one's surface, m; below zero inside.
	Vec3 normal; ///< Out of the other one, a unit vector.
	float share = 0.0f; ///< Of the way along the axis.
	float other_share = 0.5f; ///< Of the way along the other one's axis, 0 to 1: where a pill is touched.
};

/// Where a point is nearest to a solid.
/// @param p_axis the solid's own axis, wherever it is now
Approach approach_point(const Vec3 &p_point, const LimbSolid &p_solid, const SolidAxis &p_axis);

/// Where an axis comes nearest to a solid. Where it goes through a box, the face is found through which it comes out
/// by the least turns.
Approach approach_axis(
		const SolidAxis &p_mover, const AxisFreedom &p_freedom, const LimbSolid &p_solid, const SolidAxis &p_axis);

} // namespace ragdoll
