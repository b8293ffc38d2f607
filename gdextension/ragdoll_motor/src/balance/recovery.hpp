// SPDX-License-Identifier: MIT
#pragma once

#include "balance/rise.hpp"
#include "base/archive.hpp"
#include "body/leg.hpp"
#include "body/rig.hpp"

#include <vector>

namespace ragdoll {

/// Parameters of falling and getting up.
struct RecoverySettings {
	/// A body falls when its hips lean from where the motion has them by more than the first number, rad. Half of
	/// that is enough when its centre of mass is lower over the lowest limb than the second number, a share of
	/// the motion's height.
	float fall_angle = 0.9f;
	float fall_height = 0.6f;
	/// What is left of the joints' torque in a fall: limbs soften it, they do not hold it.
	float fall_strength = 0.25f;
	/// A falling body bends by the first number, a part of a crouch, and reaches out, both within the second, s. Its
	/// arms point down by the third, rad, from the direction of the fall.
	float fall_crouch = 0.4f;
	float protect_s = 0.25f;
	float reach_down = 0.6f;
	/// A fallen body lies still when its centre of mass has been slower than the first number, m/s, for the second,
	/// s; and in any case after the third, s.
	float rest_speed = 0.4f;
	float rest_from_s = 0.25f;
	float rest_s = 0.6f;
	/// What joints' torque is multiplied by while the body gets up. Found by hand, not swept.
	float rise_strength = 1.5f;
	/// How far thighs and trunk are bent and shins turned in a crouch, rad.
	float thigh_angle = 1.75f;
	float shin_angle = 0.6f;
	float trunk_angle = 0.5f;
};

/// What a body knows that may fall.
struct RecoveryInput {
	const RigState *state = nullptr;
	float height = 0.0f; ///< Of the body's centre of mass over its lowest limb, m.
	float wanted_height = 0.0f; ///< The same of the motion, m.
	float speed = 0.0f; ///< Of the body's centre of mass, m/s.
	float gravity = 9.81f; ///< m/s^2
	bool is_limp = false; ///< Nothing drives the body.
	float delta_s = 0.0f;
};

/// Tells when a body falls, lets it fall softly, and brings it back to its feet, see Rise.
class Recovery {
public:
	enum class Phase : int {
		NONE, ///< The body stands, or lies because the motion does.
		FALLING,
		TUCKING, ///< The parts of getting up, see RisePart.
		ROLLING,
		RISING,
	};

	Recovery() = default;
	Recovery(const Rig &p_rig, const std::vector<ContactPoint> &p_contacts);

	/// Begins a step; bends the poses while the body falls and gets up.
	void advance(const Rig &p_rig, const RecoveryInput &p_input, Pose &r_now, Pose &r_next);
	void clear() { _phase = Phase::NONE; }

	Phase get_phase() const { return _phase; }
	/// What the joints' torque is multiplied by.
	float get_strength() const;
	/// Greatest torque from outside at the hips while the body gets up, as a vector, N m.
	float get_most_help() const { return is_rising() ? _rise.get_most_help() : 0.0f; }
	/// That torque in this step, world axes, N m.
	Vec3 get_help() const { return is_rising() ? _rise.get_help() : Vec3(); }

	void save(ArchiveWriter &p_archive) const;
	bool restore(ArchiveReader &p_archive);

	RecoverySettings settings;

private:
	bool is_rising() const { return _phase > Phase::FALLING; }
	void go(Phase p_phase, const RigState &p_state);
	void get_up(const Rig &p_rig, const RecoveryInput &p_input, const Pose &p_motion);
	void crouch(const Rig &p_rig, const Pose &p_motion, float p_share, Pose &r_pose) const;
	/// Bends knees and trunk and reaches for the ground: nobody falls like a plank.
	void protect(const Rig &p_rig, const RigState &p_state, float p_time_s, Pose &r_pose);
	bool has_fallen(const RigState &p_state, float p_height, float p_wanted_height, const Pose &p_now) const;

	std::vector<Leg> _legs;
	std::vector<std::size_t> _arms; // Upper arms, each before the limbs that hang on it.
	Vec3 _left; // From the right hip joint to the left one, or the other way round: knees bend ahead, in the hips'
				// axes.
	std::vector<Quat> _start; // Where the limbs were when the fall began.
	Rise _rise;
	Pose _crouch;
	Phase _phase = Phase::NONE;
	float _time_s = 0.0f; // Since the fall began.
};

} // namespace ragdoll
