// SPDX-License-Identifier: MIT
#pragma once

#include "body/pose.hpp"
#include "root/carrier.hpp"

namespace ragdoll {

/// A frame in the world: a point p of it is at orientation p + origin (m).
struct MotionFrame {
	Quat orientation;
	Vec3 origin; ///< m
	bool is_identity = true; ///< It is the world's own: nothing has to be moved.

	/// Takes a pose from this frame to the world.
	void apply(Pose &r_pose) const;
	MotionFrame moved(const Ride &p_ride) const;
	void save(ArchiveWriter &p_archive) const;
	bool restore(ArchiveReader &p_archive);
};

/// The frame that a person's motion happens in, and how it moves: with a seat (whoever drives sets it, each step),
/// or with the platform that the person stands on (Carrier finds that).
class CarriedFrame {
public:
	/// Sets where the frame is at the end of the next step. Until it is set again, it moves with what the person
	/// stands on.
	void set(const Quat &p_orientation, const Vec3 &p_origin);
	/// Whether somebody sets it: since the last step.
	bool is_set() const { return _is_set; }
	/// A new motion begins in the frame that is set.
	void restart() { _now = _next; }
	/// Begins a step: finds how the frame moves in it.
	/// @param p_ground null where there is none: the frame then moves only when it is set
	void advance(const Rig &p_rig, const std::vector<ContactPoint> &p_contacts, const RigState &p_state,
			const Ground *p_ground, float p_delta_s);
	/// Takes the motion at the beginning and at the end of the step to the world, once in a step.
	void apply(Pose &r_now, Pose &r_next);
	/// Takes a pose to the world by where the frame will be.
	void to_world(Pose &r_pose) const { _next.apply(r_pose); }
	/// Moves a pose as far as the frame moves in this step.
	void move(Pose &r_pose) const { MotionFrame{ _turn, _shift, false }.apply(r_pose); }
	/// How far the frame takes a point of the world in this step, m.
	Vec3 get_way(const Vec3 &p_from) const { return _turn.rotate(p_from) + _shift - p_from; }
	/// Takes orientations and points (m) from the world to the frame.
	void to_own(std::vector<Quat> &r_orientations, std::vector<Vec3> &r_points) const;

	/// Whether the frame is the world's own.
	bool is_world() const { return _next.is_identity; }
	const Quat &get_orientation() const { return _next.orientation; }
	const Vec3 &get_origin() const { return _next.origin; }
	/// How the frame moves in this step: a point p of the world goes to turn p + shift (m).
	const Quat &get_turn() const { return _turn; }
	const Vec3 &get_shift() const { return _shift; }
	const Carrier &get_carrier() const { return _carrier; }

	void save(ArchiveWriter &p_archive) const;
	bool restore(ArchiveReader &p_archive);

private:
	MotionFrame _now; // At the beginning of the step.
	MotionFrame _next; // At its end, as far as is known.
	MotionFrame _base; // Where it truly is, not where it was expected to be.
	bool _is_set = true; // By whoever drives, since the last step.
	Carrier _carrier;
	Quat _turn; // In this step.
	Vec3 _shift; // m
};

} // namespace ragdoll
