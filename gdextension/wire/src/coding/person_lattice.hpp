// SPDX-License-Identifier: MIT
#pragma once

#include "coding/lattice_rotation.hpp"

namespace wire {

using kinematics::Skeleton;

/// The lattice of poses that server and clients share: the root to a millimetre, its orientation in the
/// world, every other limb's relative to its parent.
///
/// A rotation is its three components beside a large one, each divided by 1 + the large one (half the
/// tangent of a quarter of the angle: a stereographic map, which stretches the same in all directions),
/// rounded to the nearest point of a body-centred cubic lattice (three whole numbers, all even or all
/// odd), which covers space with fewer points than a cubic one.
class PersonLattice {
public:
	/// The resolution at which no limb is off by more than so many degrees.
	static int resolution_for(double p_max_error_deg);
	/// Resolutions for 0.1 and 0.5 degrees.
	static constexpr int FINE = 2600;
	static constexpr int COARSE = 520;
	static constexpr int MIN_RESOLUTION = 32;
	static constexpr int MAX_RESOLUTION = 16384;
	/// The root is within so many millimetres from the origin, along each axis.
	static constexpr int32_t MAX_ROOT = 1 << 28;

	/// What cannot be a resolution becomes the nearest one that can.
	explicit PersonLattice(int p_resolution = FINE);

	/// Lattice units to a tangent of 1.
	int resolution() const { return _lattice_resolution; }
	/// Puts a pose on the lattice. A limb's relative rotation is taken against its parent as receivers
	/// restore it, so that errors do not add up. p_previous, where the person was a tick ago, helps to
	/// choose among what is near enough; it may be null, or r_state itself. False, and nothing is changed, if the pose
	/// has numbers that are not finite, rotations that are none, or a root out of range.
	bool quantise(const PersonPose &p_pose, const Skeleton &p_skeleton, const PersonState *p_previous,
			PersonState &r_state) const;
	/// The pose that a state stands for.
	void restore(const PersonState &p_state, const Skeleton &p_skeleton, PersonPose &r_pose) const;
	/// The rotation that a code stands for.
	Quat rotation(const RotationCode &p_code) const;
	/// The code of a unit quaternion; p_previous may be null.
	RotationCode nearest(const Quat &p_rotation, const RotationCode *p_previous) const;

private:
	int _lattice_resolution;
};

} // namespace wire
