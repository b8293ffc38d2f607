// SPDX-License-Identifier: MIT
#pragma once

#include "base/histogram.hpp"
#include "base/vectors.hpp"

#include <cstddef>

namespace ragdoll {

/// Force and torque on the hips from outside, which neither gravity nor contacts explain, about the hips' joint.
struct Residual {
	Vec3 force; ///< World axes, N.
	Vec3 torque; ///< World axes, N m.
};

/// Counts the residual of a body: what the field calls the hand of God, and wants small (Wensing and Orin 2013;
/// Hicks et al. 2015, "Is my model good enough?", J. Biomech. Eng. 137, for residuals of motions without simulation).
class ResidualMeter {
public:
	/// What the motor itself applies in the step that begins, besides the joint to the world.
	void expect(const Residual &p_applied) { _applied = p_applied; }
	/// Notes what the joint to the world gave in the step that has ended.
	void note(const Residual &p_joint) {
		_latest = { p_joint.force + _applied.force, p_joint.torque + _applied.torque };
		_torques.add(double(_latest.torque.length() / BIN));
	}
	/// Of the last step.
	const Residual &get_latest() const { return _latest; }
	/// What the torque's length did not exceed in that part of the steps, to 10 N m.
	float find_torque(double p_fraction) const { return float(_torques.find(p_fraction) + 1) * BIN; }
	void clear() { *this = ResidualMeter(); }

private:
	static constexpr float BIN = 10.0f; // N m
	static constexpr std::size_t BINS = 256;

	Residual _applied;
	Residual _latest;
	Histogram<BINS> _torques;
};

} // namespace ragdoll
