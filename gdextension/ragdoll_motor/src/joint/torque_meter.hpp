// SPDX-License-Identifier: MIT
#pragma once

#include "body/rig.hpp"
#include "joint/actuation.hpp"

#include <vector>

namespace ragdoll {

/// Estimates what torque each joint has had to bring up in the last step, from how the bodies moved:
/// recursive Newton-Euler inverse dynamics, from the leaves to the root (Luh, Walker, Paul 1980).
/// The engine does not report them. Forces of contacts are not known and count as the joints' work; what holds the
/// root is measured (ResidualMeter).
class TorqueMeter {
public:
	explicit TorqueMeter(std::size_t p_limb_count);

	/// Takes the state after a step of p_delta_s seconds.
	void note(const Rig &p_rig, const RigState &p_state, float p_delta_s);
	/// Compares the torques with what the joints can give.
	/// @param p_root_torque torque of the root's hold, N m
	/// @param p_root_most the greatest that it may be, N m
	void compare(const Rig &p_rig, const ActuationTable &p_table, float p_root_torque, float p_root_most);
	/// Magnitude of the torque at each limb's joint, N m; the root's is that of its hold by the world.
	const std::vector<float> &get_torques() const { return _torques; }
	/// What part of each joint's greatest torque that was at the last compare(), 0 to 1 and more.
	const std::vector<float> &get_saturations() const { return _saturations; }
	void clear() { _is_known = false; }

private:
	bool _is_known = false;
	std::vector<Vec3> _linear_before;
	std::vector<Vec3> _angular_before;
	std::vector<Vec3> _forces;
	std::vector<Vec3> _moments;
	std::vector<float> _torques;
	std::vector<float> _saturations;
};

} // namespace ragdoll
