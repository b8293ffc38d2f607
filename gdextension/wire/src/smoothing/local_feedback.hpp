// SPDX-License-Identifier: MIT
#pragma once

#include "smoothing/frame.hpp"

#include <skeleton.hpp>

namespace wire {

/// Shows wearers their own bodies at once (thesis section 7.5), and still what the server's world does
/// to them.
///
/// What is shown is the wearer's pose now, turned by what the server's pose deviated from the wearer's
/// at the moment that it was made of. Deviations that come of following a motion are left out, the rest
/// comes and goes smoothly, so that a moving person does not jitter and a wall still stops an arm.
///
/// Moments are times of the wearer's clock, s; frames as in kinematics::PersonPose. Nothing allocates.
class LocalFeedback {
public:
	static constexpr float FARTHEST = 1e5f; ///< Positions further from the origin are refused, m.

	/// Says how the limbs hang together; forgets everything. False if it is no skeleton.
	bool set_skeleton(const kinematics::Skeleton &p_skeleton);
	int limb_count() const { return _skeleton.limb_count; }

	/// Turns the wearer's poses about the vertical, rad: as the wearer's own frame is turned in the world.
	/// Where that changes all poses are forgotten.
	void set_heading(float p_heading);
	/// Takes the wearer's pose at a moment. False if it is broken or not newer than the last.
	bool push_local(double p_moment_s, const PersonPose &p_pose);
	/// Takes what the server made of the wearer's pose at a moment. False if it is broken, not newer
	/// than the last, or nobody knows the wearer's pose then.
	bool push_truth(double p_moment_s, const PersonPose &p_pose);
	/// Works out what is shown at a time of the client's clock, s: the wearer's pose at a moment, which
	/// may be a little beyond the newest. False before the first pose.
	bool evaluate(double p_now_s, double p_moment_s);
	/// Forgets all poses.
	void clear();

	/// As shown.
	const PersonPose &get_pose() const { return _pose; }
	const std::array<Vec3, kinematics::MAX_LIMBS> &get_positions() const { return _positions; }
	/// How far a limb is shown from where the wearer has it, rad.
	float deviation(std::size_t p_limb) const { return _shown.turns[p_limb].length(); }
	/// Moment of the newest pose of the wearer, s.
	double newest_moment() const { return _local_count > 0 ? _local(_local_count - 1).moment : 0.0; }

private:
	using Limbs = Frame<kinematics::MAX_LIMBS>;
	using LimbDelta = Delta<kinematics::MAX_LIMBS>;
	struct Local {
		double moment = 0.0;
		Limbs frame;
	};

	static constexpr std::size_t KEPT = 256;

	const Local &_local(std::size_t p_number) const { return _history[p_number % KEPT]; }
	std::size_t _oldest() const { return _local_count > KEPT ? _local_count - KEPT : 0; }
	bool _read(const PersonPose &p_pose, Limbs &r_frame) const;
	bool _local_at(double p_moment_s, Limbs &r_frame, LimbDelta &r_speed) const;
	void _note_turn(std::size_t p_limb, const Vec3 &p_deviation, float p_speed);
	void _filter(float p_step);

	kinematics::Skeleton _skeleton;
	std::size_t _count = 0;
	float _heading = 0.0f;
	Quat _turn; // By the heading.
	std::array<Local, KEPT> _history{};
	std::size_t _local_count = 0; // Of all; the newest KEPT are kept.
	double _truth_moment = 0.0;
	bool _has_truth = false;
	bool _has_news = false;
	double _truth_at = 0.0;
	bool _is_shown = false;
	double _shown_at = 0.0;
	LimbDelta _wanted; // What the server's pose deviates by, as far as it is to be shown.
	LimbDelta _shown; // What is shown of it.
	LimbDelta _speed; // How fast that changes.
	PersonPose _pose;
	std::array<Vec3, kinematics::MAX_LIMBS> _positions{};
};

} // namespace wire
