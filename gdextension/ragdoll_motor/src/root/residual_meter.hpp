// SPDX-License-Identifier: MIT
#pragma once

#include "base/vectors.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

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
	void note(const Residual &p_joint);
	/// Of the last step.
	const Residual &get_latest() const { return _latest; }
	/// What the lengths of force (N) and torque (N m) did not exceed in that part of the steps, to 10 N and 10 N m.
	float find_force(double p_fraction) const { return _forces.find(p_fraction, _count); }
	float find_torque(double p_fraction) const { return _torques.find(p_fraction, _count); }
	void clear();

private:
	static constexpr float BIN = 10.0f; // N or N m
	static constexpr std::size_t BINS = 256;
	struct Histogram {
		std::array<std::uint32_t, BINS> bins{};

		void add(float p_value);
		float find(double p_fraction, std::uint64_t p_count) const;
	};

	Residual _applied;
	Residual _latest;
	Histogram _forces;
	Histogram _torques;
	std::uint64_t _count = 0;
};

} // namespace ragdoll
