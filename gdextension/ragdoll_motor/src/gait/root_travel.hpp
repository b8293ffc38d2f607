// SPDX-License-Identifier: MIT
#pragma once

#include "gait/foot_lock.hpp"
#include "gait/path_filter.hpp"
#include "gait/travel.hpp"
#include "motion/pose_filter.hpp"
#include "root/carrier.hpp"
#include "root/root_drive.hpp"

#include <memory>
#include <vector>

namespace ragdoll {

/// Makes the estimator of a root mode; null where the mode has none.
using TravelMaker = std::unique_ptr<Travel> (*)(RootMode p_mode, const std::vector<ContactPoint> &p_contacts);

/// What RootTravel gets for a step.
struct RootTravelInput {
	RootMode mode = RootMode::SOFT;
	const RigState *state = nullptr;
	const Ground *ground = nullptr; ///< Null: level ground at height 0.
	const PoseFilter *filter = nullptr; ///< How noisy the motion is.
	const Ride *ride = nullptr; ///< How what carries the person has moved since the last step.
	bool begins = false; ///< Begins anew from where the body is: it was limp, or the motion had stalled.
	float delta_s = 0.0f;
};

/// Finds where the root of a person goes in the modes that do not know its position: lets the mode's estimator
/// (Travel) take the pose, keeps the estimate near the body, smooths its path and puts the feet onto the ground.
class RootTravel {
public:
	/// How far the body may be held back from where the feet carry it before the estimate gives in, m: a person
	/// who walks against a wall walks on the spot.
	static constexpr float SLACK = 0.05f;
	/// How far the target may be above or below the body, and across, m. Nobody is lifted faster than he rises
	/// himself, and who lies on something that no ray sees stays there.
	static constexpr float FURTHEST_UP = 0.2f;
	static constexpr float FURTHEST_ACROSS = 0.12f;

	/// @param p_make makes a mode's estimator when the mode is chosen for the first time
	RootTravel(const Rig &p_rig, const std::vector<ContactPoint> &p_contacts, TravelMaker p_make);

	/// Begins a step: moves the motion's root at its beginning and end to where it is found, and bends its legs.
	/// Modes without an estimator leave the motion as it is.
	void advance(const Rig &p_rig, const RootTravelInput &p_input, Pose &r_now, Pose &r_next);
	/// The estimator of a mode, or null where the mode has none or has not been stepped yet.
	Travel *find(RootMode p_mode) const;
	/// The mode of the last step.
	RootMode get_mode() const { return _mode; }
	/// Where the last step was to bring the root, m.
	const Vec3 &get_target() const { return _target; }

	void save(ArchiveWriter &p_archive) const;
	bool restore(ArchiveReader &p_archive);

private:
	struct ModeTravel {
		RootMode mode = RootMode::INERTIAL;
		std::unique_ptr<Travel> estimator;
	};

	/// Makes the estimator of a mode; null where the mode has none.
	Travel *make(RootMode p_mode);
	/// Brings the estimate to where the body is held back or pushed to.
	/// @param p_off how far the body is from where it should be, m
	void give_in(Travel &r_estimator, const Vec3 &p_off);
	/// Keeps the estimate near the body.
	void stay_near(Travel &r_estimator, const RigState &p_state);
	void shift(Travel &r_estimator, const Vec3 &p_offset);
	/// Lets the estimator take the pose.
	void estimate(const Rig &p_rig, const RootTravelInput &p_input, Travel &r_estimator, Pose &r_now, Pose &r_next);
	/// Puts the feet onto the ground, and lets the hips come down for them.
	void place_feet(
			const Rig &p_rig, const Travel &p_estimator, float p_unrest, float p_delta_s, Pose &r_now, Pose &r_next);
	void find_points(const Rig &p_rig, const Pose &p_pose, std::vector<Vec3> &r_points);
	void find_shown(const Rig &p_rig, const RigState &p_state);

	TravelMaker _make = nullptr;
	std::vector<ModeTravel> _estimators; // Of modes that have been chosen.
	std::vector<ContactPoint> _contacts;
	FootLock _foot_lock;
	PathFilter _path;
	FlatGround _level_ground;
	RootMode _mode = RootMode::SOFT; // Of the last step.
	Vec3 _target; // m
	// Kept between steps, so that a step allocates nothing.
	std::vector<Vec3> _joints;
	std::vector<Vec3> _points_now;
	std::vector<Vec3> _points_next;
	std::vector<Vec3> _points_shown;
	std::vector<Vec3> _turns; // Rates of the limbs, world axes, rad/s.
};

} // namespace ragdoll
