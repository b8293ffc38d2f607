// SPDX-License-Identifier: MIT
#pragma once

#include "gait/travel.hpp"
#include "rig.hpp"

#include <vector>

namespace ragdoll {

/// Bends the legs of a pose a little, so that feet that stand stay where they are: two-bone inverse
/// kinematics on thigh and shin. It takes up what noise, calibration and the estimate of the root leave.
class FootLock {
public:
	/// The most that a foot is moved, m.
	static constexpr float FURTHEST = 0.12f;
	/// How fast a foot that lifts off comes back to where the motion has it, s.
	static constexpr float LET_GO_S = 0.06f;
	/// How slowly points are taken hold of and let go where the motion is nothing but noise, s.
	static constexpr float GRIP_S = 0.05f;
	/// How far the body's foot may be from where it is held before the hold gives in, where the motion is
	/// nothing but noise, m: motors that are calmed put it down elsewhere.
	static constexpr float SLACK = 0.002f;

	FootLock() = default;
	/// Legs are the limbs with soles, what they hang on, and what that hangs on.
	FootLock(const Rig &p_rig, const std::vector<ContactPoint> &p_contacts);

	/// Moves the feet of a pose to where they stand. A foot that has let go comes back slowly.
	/// @param p_unrest how noisy the motion is, 0 to 1
	/// @param r_joints the pose's joints, m; they are brought up to date
	void apply(const Rig &p_rig, float p_unrest, Pose &r_pose, std::vector<Vec3> &r_joints);
	/// Begins a step: lets go of feet that lifted off, and takes hold of those that came down where they
	/// are shown.
	/// @param p_points contact points of the pose from the root's joint, m
	/// @param p_shown where the bodies have them, m
	/// @param p_unrest how noisy the motion is, 0 to 1
	void advance(const Travel &p_travel, const Vec3 &p_root, const std::vector<Vec3> &p_points,
			const std::vector<Vec3> &p_shown, float p_unrest, float p_delta_s);
	/// The world has moved the body, m.
	void shift(const Vec3 &p_offset);
	void clear();

	void save(ArchiveWriter &p_archive) const;
	bool restore(ArchiveReader &p_archive);

private:
	struct Leg {
		int foot = 0;
		int shin = 0;
		int thigh = 0;
		Vec3 offset; // m
	};

	void bend(const Rig &p_rig, const Leg &p_leg, Pose &r_pose, std::vector<Vec3> &r_joints) const;

	std::vector<Leg> _legs;
	std::vector<ContactPoint> _contacts;
	std::vector<Vec3> _anchors; // Where the held points are shown, m.
	std::vector<float> _grips; // How firmly each point is held, 0 to 1.
};

} // namespace ragdoll
