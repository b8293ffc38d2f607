// SPDX-License-Identifier: MIT
#pragma once

#include "base/archive.hpp"
#include "body/rig.hpp"
#include "joint/actuation.hpp"
#include "world/obstacles.hpp"

#include <cstdint>
#include <vector>

namespace ragdoll {

/// Brings a body into a motion that is on its way already: one that begins, or comes back after a pause.
///
/// Joints and feet could not: they would take so long that the motion is elsewhere by then, and fling limbs.
/// Instead the body is put into the motion's pose, with its velocities, in each of a few steps: the first sample
/// tells no velocity, only those that follow do. Who goes on after a short pause comes to the pose within that
/// time; what is limp, or would have to go through something firm, hangs on the rest as it did.
class Arrival {
public:
	/// How long it takes, s; longer where the second sample takes longer. Within 0.1 s a body is to move as the
	/// motion does (bench starts), and 30 steps a second leave three placings to that.
	static constexpr float DURATION_S = 0.06f;
	/// From this distance of the root on (m) it is put there at once: on the way it would meet others.
	static constexpr float LONG_WAY = 0.5f;

	/// A limb above the legs that was off by so much (rad, at its joint) when the motion stalled was held by something.
	static constexpr float HELD = 0.35f;

	explicit Arrival(std::size_t p_limb_count);

	/// The motion stalls in this step: notes what holds the body.
	/// @param p_now what the body was to do at the beginning of the step
	void note_stall(const Rig &p_rig, const RigState &p_state, const Pose &p_now);

	/// Begins: the body is in the motion's pose at once.
	void begin();
	/// Begins from where the body is.
	/// @param p_now the motion at the beginning of the step
	/// @param p_offset from the motion's root to where the body's will be, m
	/// @param p_at_once whether nothing lies between the two poses: what finds the travel by the body's own feet
	/// would take the way there for one that the feet went
	/// @param p_obstacles null where nothing is known of what is in the way
	void begin_from(const Rig &p_rig, const RigState &p_state, const Pose &p_now, const Vec3 &p_offset, bool p_at_once,
			const ActuationTable &p_table, const Obstacles *p_obstacles);
	bool is_on() const { return _is_on; }

	/// Begins a step: puts the bodies where they are at its beginning, with the velocities that lead along the
	/// motion. The last placing is exactly the motion's.
	/// @param p_may_end whether the motion's velocity is known, or will not come
	/// @param p_now, p_next the motion at the beginning and at the end of the step
	void advance(const Rig &p_rig, const Pose &p_now, const Pose &p_next, bool p_may_end, float p_delta_s,
			RigState &r_state);

	void save(ArchiveWriter &p_archive) const;
	bool restore(ArchiveReader &p_archive);

private:
	struct Limb {
		Vec3 off; // From the motion's orientation to that at the beginning, in its axes, rad.
		Quat held; // In the parent's frame, as it was at the beginning.
		bool is_held = false;
		bool was_held = false; // When the motion stalled.
	};

	/// The motion's pose, with so much of what the body was off by.
	/// @param p_left 1 at the beginning, 0 where the body has come to the motion
	void blend(const Rig &p_rig, const Pose &p_motion, float p_left, Pose &r_pose) const;

	std::vector<Limb> _limbs;
	Vec3 _offset; // From the motion's root to where the body's will be, m.
	Vec3 _off; // From there to where it was at the beginning, m.
	float _time_s = 0.0f;
	bool _is_on = false;
	// Kept between steps, so that a step allocates nothing.
	Pose _placed;
	Pose _placed_next;
	std::vector<Vec3> _joints;
};

} // namespace ragdoll
