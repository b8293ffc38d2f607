// SPDX-License-Identifier: MIT
#pragma once

#include "body/leg.hpp"
#include "body/rig.hpp"
#include "gait/travel.hpp"

#include <limits>
#include <vector>

namespace ragdoll {

/// Bends the legs of a pose a little, so that feet that stand stay where they are: two-bone inverse
/// kinematics on thigh and shin. It takes up what noise, calibration and the estimate of the root leave, and
/// puts the feet of somebody who walks on a level floor onto the ground that his body walks on.
class FootLock {
public:
	/// The most that a foot is moved, m.
	static constexpr float FURTHEST = 0.12f;
	/// A foot that is held further than this (m) from where the motion has it is let slip within SLIP_S.
	static constexpr float SLIPS_FROM = 0.05f;
	/// That distance is larger by this where the motion is nothing but noise, m.
	static constexpr float SLIPS_LATER = 0.3f;
	static constexpr float SLIP_S = 0.15f;
	/// The most that a foot is raised or lowered to the ground that is really there, m.
	static constexpr float HIGHEST = 0.2f;
	/// Ground that is so close to the pose's own floor (m) is the same.
	static constexpr float EVEN = 0.005f;
	/// A foot that swings keeps its height over the pose's floor, up to this, over the ground too, m.
	static constexpr float SWING = 0.025f;
	/// A foot that swings with CLEARS_AT (m/s) or faster clears the ground by CLEARS (m); a slower one by less, and
	/// one below CLEARS_FROM (m/s) by nothing. Soles that scuff stick, and are dragged along behind the motion.
	static constexpr float CLEARS = 0.03f;
	static constexpr float CLEARS_FROM = 0.3f;
	static constexpr float CLEARS_AT = 1.5f;
	/// That distance is larger by this where the motion is nothing but noise, m.
	static constexpr float UNEVEN = 0.06f;
	/// Share of a leg's length to which it is stretched before the hips come down instead.
	static constexpr float STRETCHED = 0.995f;
	/// The hips come down with the time constant SINK_S (s) so that feet reach the ground, with SINK_SPEED (m/s) at
	/// most.
	static constexpr float SINK_S = 0.2f;
	static constexpr float SINK_SPEED = 1.5f;
	/// A foot that the motion itself has so far below the one that stands (m) is on its way to a lower step.
	static constexpr float LOWER = 0.04f;
	/// How fast feet are fitted to the ground, s.
	static constexpr float FIT_S = 0.03f;
	/// Ground under a foot is even when no point of it is further from a plane than this, m.
	static constexpr float PLANE = 0.02f;
	/// Feet are tilted no further than this, rad: about as far as ankles bend upward (AAOS 1965: 20 deg).
	static constexpr float STEEPEST = 0.4f;
	/// How fast a foot that lifts off comes back to where the motion has it, s.
	static constexpr float LET_GO_S = 0.06f;
	/// How slowly points are taken hold of and let go where the motion is nothing but noise, s.
	static constexpr float GRIP_S = 0.05f;
	/// How far the body's foot may be from where it is held before the hold gives in, m: a foot that strikes is
	/// a few centimetres behind the motion, and motors that are calmed put it down elsewhere.
	static constexpr float SLACK = 0.002f;
	/// The hold gives in only once that foot is no higher than this over where it is held, m.
	static constexpr float DOWN = 0.03f;

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
	/// Lets the hips come down so far that legs reach where the feet shall be. Returns how far that is, m.
	/// @param p_joints of the pose, m
	float sink(const Rig &p_rig, float p_unrest, const std::vector<Vec3> &p_joints, float p_delta_s);
	/// How far the hips have come down for the feet, m.
	float get_drop() const { return _drop; }
	/// The world has moved the body, m.
	void shift(const Vec3 &p_offset);
	void clear();

	void save(ArchiveWriter &p_archive) const;
	bool restore(ArchiveReader &p_archive);

private:
	static constexpr float NAN_M = std::numeric_limits<float>::quiet_NaN();
	static constexpr Vec3 NOWHERE{ NAN_M, NAN_M, NAN_M };

	struct HeldLeg : Leg {
		std::vector<std::size_t> points; // Of the sole, as in the list of contact points.
		Vec3 sole; // Their middle, in the foot's frame, m.
		Vec3 offset; // m
		Vec3 away; // How far from where it is held the motion has it, across, m.
		float rise = 0.0f; // To the ground, m.
		Vec3 tilt; // Of the foot with the ground, rotation vector, rad.
		Vec3 place = NOWHERE; // Of the sole in the motion, m.
		float clearance = 0.0f; // By how much it shall clear the ground while it swings, m.
	};

	void find_level(const Travel &p_travel, const std::vector<Vec3> &p_points);
	void find_clearance(HeldLeg &r_leg, const Travel &p_travel, const Vec3 &p_root, const std::vector<Vec3> &p_points,
			float p_delta_s) const;
	/// How the ground under a foot is tilted, rotation vector, rad; none where it is not even.
	Vec3 find_tilt(const HeldLeg &p_leg) const;
	/// How far a foot has to be raised onto the ground, or lowered where it stands, m.
	float find_rise(const HeldLeg &p_leg, const Vec3 &p_root, const std::vector<Vec3> &p_points, float p_unrest) const;
	void fit(HeldLeg &r_leg, const Vec3 &p_root, const std::vector<Vec3> &p_points, float p_unrest,
			float p_delta_s) const;
	/// Tilts a foot about the middle of its sole; returns how far that moves the ankle, m.
	Vec3 tilt(const HeldLeg &p_leg, Pose &r_pose) const;

	std::vector<HeldLeg> _legs;
	std::vector<ContactPoint> _contacts;
	std::vector<Vec3> _anchors; // Where the held points are shown, m.
	std::vector<Vec3> _grounds; // The ground under the points; NaN where none is known, m.
	float _level = 0.0f; // That the pose stands on, from the root, m.
	float _drop = 0.0f; // Of the hips, m.
	float _floor = 0.0f; // Of the pose, from the root, m.
	std::vector<float> _grips; // How firmly each point is held, 0 to 1.
};

} // namespace ragdoll
