// SPDX-License-Identifier: MIT
#pragma once

#include "base/archive.hpp"

#include <cstddef>
#include <vector>

namespace ragdoll {

/// How a limb is made to follow the motion.
enum class Actuation : int {
	DIRECT_SET, ///< Thesis 8.1: put where the motion has it; nothing can hold it up.
	SPRING_TORQUE, ///< Thesis 8.2: a torque grows with the error, and with a leaky integral of it.
	ANGULAR_MOTOR, ///< Thesis 8.3: the joint's motor turns with a speed in proportion to the error.
	VELOCITY_MOTOR, ///< The same, plus the speed that the motion has anyway (feed-forward).
	POSITION_MOTOR, ///< The engine's spring, pulled to where the motion will be.
	LIMP, ///< Nothing but a little friction in the joint.
};
constexpr int ACTUATION_COUNT = 6;

/// A value that changes smoothly to another.
class Ramp {
public:
	Ramp() = default;
	explicit Ramp(float p_value) : _from(p_value), _to(p_value) {}

	float get() const;
	float get_target() const { return _to; }
	bool is_moving() const { return _elapsed < _duration; }
	/// Goes to a value within a time, s; at once for 0.
	void go(float p_to, float p_duration_s);
	void advance(float p_delta_s);

private:
	float _from = 0.0f;
	float _to = 0.0f;
	float _elapsed = 0.0f;
	float _duration = 0.0f;
};

/// Parameters of a strength group.
struct GroupSettings {
	Ramp strength{ 1.0f }; ///< Multiplies every torque limit of the group.
	float frequency = 0.0f; ///< Of the springs, Hz; 0 takes the mode's own.
	float damping_ratio = 0.0f; ///< Of the springs; 0 takes the mode's own.
};

/// What a limb's springs are like.
struct SpringSettings {
	float frequency = 0.0f; ///< Hz; 0 takes the mode's own.
	float damping_ratio = 0.0f; ///< 0 takes the mode's own.
};

/// Which mode and how much strength every limb has, and how they pass into each other.
///
/// From and to LIMP the torque fades, so that a hit, a death or a getting-up looks like one. Into
/// DIRECT_SET the limb is moved from where it is. Between the other modes the change is at once: they
/// hold the same pose.
class ActuationTable {
public:
	/// What is left of a joint's torque when it is limp: friction of joints and clothes.
	static constexpr float LIMP_FRICTION = 0.02f;

	ActuationTable() = default;
	/// @param p_groups each limb's strength group
	ActuationTable(const std::vector<int> &p_groups, std::size_t p_group_count);

	/// Changes the mode of a group, or of all limbs (-1), within a time, s.
	void set_mode(Actuation p_mode, int p_group, float p_blend_s);
	/// Changes the strength of a group, or of all (-1). Values below 0 count as 0.
	void set_strength(float p_strength, int p_group, float p_blend_s);
	void set_spring(float p_frequency, float p_damping_ratio, int p_group);
	/// Scales everybody's strength besides: a stream that has stalled.
	void set_overall(float p_strength, float p_blend_s);
	// Single limbs, as controls have them; within a time, s.
	void set_limb_mode(Actuation p_mode, std::size_t p_limb, float p_blend_s) {
		change(_limbs[p_limb], p_mode, p_blend_s);
	}
	/// Multiplies the limb's torque besides its group's strength.
	void set_limb_share(float p_share, std::size_t p_limb, float p_blend_s) {
		_limbs[p_limb].share.go(p_share, p_blend_s);
	}
	/// Springs of the limb instead of its group's; a frequency of 0 gives it those again.
	/// @param p_usual the mode's own frequency, from which the first one is approached, Hz
	void set_limb_spring(float p_frequency, float p_damping_ratio, float p_usual, std::size_t p_limb, float p_blend_s);
	/// How far the limb is shown from the motion (0) to the simulation (1).
	void set_physics_blend(float p_blend, std::size_t p_limb, float p_blend_s) {
		_limbs[p_limb].blend.go(p_blend, p_blend_s);
	}
	/// Leaves a limb no more than a share of its strength, which comes back within a time, s.
	void flinch(std::size_t p_limb, float p_strength, float p_blend_s);
	void advance(float p_delta_s);

	/// The mode a limb is in now: while it goes limp, still the old one.
	Actuation get_mode(std::size_t p_limb) const { return _limbs[p_limb].mode; }
	/// The mode that was asked for.
	Actuation get_wanted_mode(std::size_t p_limb) const { return _limbs[p_limb].wanted; }
	/// Whether any limb is in a mode.
	bool has_mode(Actuation p_mode) const;
	/// Multiplies a limb's torque besides, until it is set again: what balance asks for in a step.
	void set_scale(std::size_t p_limb, float p_scale) { _scales[p_limb] = p_scale; }
	/// What the limb's torque limit is multiplied by, LIMP_FRICTION at least.
	float get_strength(std::size_t p_limb) const;
	/// The same without what set_overall() and flinch() take away: neither lets anybody drop.
	float get_standing_strength(std::size_t p_limb) const;
	/// The strength that was asked for, of a group.
	float get_group_strength(int p_group) const { return _groups[p_group].strength.get_target(); }
	/// How far a DIRECT_SET limb has come from where it was, 0 to 1.
	float get_arrival(std::size_t p_limb) const { return _limbs[p_limb].arrival.get(); }
	SpringSettings get_spring(std::size_t p_limb) const;
	float get_flinch(std::size_t p_limb) const { return _limbs[p_limb].flinch.get(); }
	float get_physics_blend(std::size_t p_limb) const { return _limbs[p_limb].blend.get(); }
	/// Whether any limb is shown elsewhere than where it is simulated.
	bool is_blended() const;

	void save(ArchiveWriter &p_archive) const;
	bool restore(ArchiveReader &p_archive);

private:
	struct LimbState {
		int group = 0;
		Actuation mode = Actuation::VELOCITY_MOTOR;
		Actuation wanted = Actuation::VELOCITY_MOTOR;
		Ramp authority{ 1.0f };
		Ramp arrival{ 1.0f };
		Ramp share{ 1.0f };
		Ramp flinch{ 1.0f };
		Ramp blend{ 1.0f };
		Ramp frequency{ 0.0f }; // 0 takes the group's.
		Ramp damping_ratio{ 0.0f };
	};

	static void change(LimbState &r_limb, Actuation p_mode, float p_blend_s);

	std::vector<LimbState> _limbs;
	std::vector<GroupSettings> _groups;
	std::vector<float> _scales; // No part of the saved state.
	Ramp _overall{ 1.0f };
};

} // namespace ragdoll
