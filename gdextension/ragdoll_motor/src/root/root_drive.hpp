// SPDX-License-Identifier: MIT
#pragma once

#include "body/rig.hpp"

namespace ragdoll {

/// The root's target, and what holds it there.
enum class RootMode : int {
	HELD, ///< Its position is known; it follows exactly and cannot be pushed.
	SOFT, ///< Its position is known; it is pulled there with limited force.
	LOWEST_FOOT, ///< Thesis 8.4.1: the lowest foot point stands still.
	CONTACTS, ///< Thesis 8.4.2: whatever touches the ground stands still, on any ground.
	PENDULUM, ///< Thesis 8.4.3: a heavy weight far below keeps the body upright; the feet move it.
	SELF_RIGHTING, ///< Thesis 8.4.4: motors to the world keep pelvis and trunk upright; the feet move it.
	INERTIAL, ///< For suits without position: predicted velocity and contacts, limited force.
	GROUNDED, ///< Its position is known; feet and whatever else touches carry the body.
};
constexpr int ROOT_MODE_COUNT = 8;

/// Whether the mode finds the root's travel from the ground instead of getting it.
constexpr bool finds_travel(RootMode p_mode) {
	return p_mode == RootMode::LOWEST_FOOT || p_mode == RootMode::CONTACTS || p_mode == RootMode::INERTIAL;
}
/// Whether the mode's people stand on the ground that is found under their feet.
constexpr bool needs_ground(RootMode p_mode) {
	return finds_travel(p_mode) || p_mode == RootMode::GROUNDED;
}
/// Whether no force pulls the root along: the feet alone do.
constexpr bool is_free(RootMode p_mode) {
	return p_mode == RootMode::PENDULUM || p_mode == RootMode::SELF_RIGHTING;
}

/// Whether the mode holds the root at a known position by force: what is in the way must hold that back.
constexpr bool is_tethered(RootMode p_mode) {
	return p_mode == RootMode::HELD || p_mode == RootMode::SOFT;
}

/// What the root's joint to the world gets for a step.
struct RootCommand {
	Vec3 velocity; ///< Of the root limb's joint, world axes, m/s.
	float force_across = 0.0f; ///< Greatest horizontal force an axis, N.
	float force_up = 0.0f; ///< Greatest vertical force, N.
	float torque = 0.0f; ///< Greatest torque an axis, N m.
	float assist_torque = 0.0f; ///< Of the joint that keeps a free root upright (is_free()), N m.
	Vec3 assist_turn; ///< The turning rate of that joint, its limb's axes, rad/s.
	Vec3 push; ///< A force on the root's body besides, world axes, N.

	/// Leaves a share of what holds the root, but of what carries it up.
	void weaken(float p_share) {
		force_across *= p_share;
		torque *= p_share;
		assist_torque *= p_share;
	}
};

/// Parameters of the root's hold.
struct RootSettings {
	float gain = 50.0f; ///< How fast errors are corrected, 1/s.
	float force = 2000.0f; ///< N
	float torque = 800.0f; ///< N m
	/// INERTIAL: horizontal force as a share of the body's weight: what soles and a stride can hold.
	float grip = 1.6f;
};

/// The root's command for a step: feed-forward with the motion's velocity plus a correction, which is
/// never faster than the limits can brake: level and upright each by their own. Not for modes that are free.
/// @param p_strength multiplies the limits
RootCommand drive_root(RootMode p_mode, const RootSettings &p_settings, const Rig &p_rig, const RigState &p_actual,
		const Vec3 &p_now, const Vec3 &p_next, float p_delta_s, float p_strength);

} // namespace ragdoll
