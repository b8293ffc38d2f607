// SPDX-License-Identifier: MIT
#pragma once

#include "balance/anatomy.hpp"
#include "balance/rise_stages.hpp"
#include "base/archive.hpp"

#include <vector>

namespace ragdoll {

/// From 0 to 1, at rest at both ends.
float eased(float p_part);

/// Gets a body that lies up onto its feet: plays one pose after another, by how it lies. Hands, knees and feet push;
/// from outside comes a torque at the hips that is limited as a vector, and no force.
class Rise {
public:
	Rise() = default;
	Rise(const Rig &p_rig, const std::vector<Leg> &p_legs, const std::vector<std::size_t> &p_arms);

	/// Begins to get up, the way that suits how the body lies.
	/// @param p_again whether it has fallen on the way up
	void begin(const Rig &p_rig, const RigState &p_state, bool p_again);
	/// Begins a step. Who does not get to a pose in time chooses anew.
	/// @param p_motion where the wearer has the limbs
	void advance(const Rig &p_rig, const RigState &p_state, const Pose &p_motion, float p_gravity, float p_delta_s);
	/// Bends the motion's pose to where the limbs are to be.
	/// @param p_after since the beginning of this step, s
	void bend(const Rig &p_rig, float p_after, Pose &r_pose);

	const RiseStage &get_stage() const { return get_stages(_lie)[_stage]; }
	Lie get_lie() const { return _lie; }
	/// Whether the body stands.
	bool is_done() const { return _is_done; }
	/// Whether it has fallen again on the way.
	bool has_failed() const { return _has_failed; }
	/// The most that it may be in this stage, N m.
	float get_most_help() const { return get_stage().torque * _help_scale; }
	/// The torque on the hips from outside in this step, world axes, N m.
	const Vec3 &get_help() const { return _help; }

	void save(ArchiveWriter &p_archive) const;
	bool restore(ArchiveReader &p_archive);

private:
	/// Whether the feet are behind the knees.
	bool has_feet_behind(const Rig &p_rig, const RigState &p_state) const;
	void choose(const Rig &p_rig, const RigState &p_state);
	void start_stage(const RigState &p_state);
	void find_heading(const RigState &p_state);
	void find_balance(const Rig &p_rig, const RigState &p_state, float p_gravity, float p_delta_s);
	void help(const RigState &p_state, const Pose &p_motion, float p_weight);
	bool has_arrived(const RigState &p_state) const;
	/// Stands the feet of a pose flat and turns all else about them until the centre of mass is over them: as joints
	/// come from one pose to another in their own time, the body would lean like a plank in between.
	/// @param p_share how far it has straightened up, 0 to 1
	void balance(const Rig &p_rig, float p_share, Pose &r_pose);

	Anatomy _anatomy;
	std::vector<Leg> _legs;
	Lie _lie = Lie::FACE_UP;
	std::size_t _stage = 0;
	float _time_s = 0.0f; // In this stage.
	Quat _heading;
	Quat _motion_hips; // Where the motion has them in this step.
	float _lean = 0.0f; // How far all but the feet are leant back, rad.
	Vec3 _ahead_of_feet; // From between the feet to the capture point, horizontal, m.
	Vec3 _help;
	float _help_scale = 1.0f; // Grows with each try.
	bool _is_done = false;
	bool _has_failed = false;
	std::vector<Quat> _start; // Each limb in its parent's frame where the stage began, the hips in the world ...
	std::vector<Quat> _last; // ... and where they were wanted last.
	std::vector<Quat> _wanted;
	Pose _flat; // The pose, turned until the feet stand flat ...
	std::vector<Vec3> _joints; // ... and its joints, m.
	float _began_ahead = 0.0f; // How far the centre of mass was ahead of the feet where the stage began, m.
};

} // namespace ragdoll
