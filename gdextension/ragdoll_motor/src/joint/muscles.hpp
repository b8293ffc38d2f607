// SPDX-License-Identifier: MIT
#pragma once

#include "base/archive.hpp"
#include "base/vectors.hpp"

#include <cstddef>
#include <vector>

namespace ragdoll {

/// Limits a joint's torque while the motion turns it: the faster, the less, as in muscles (A. V.
/// Hill 1938, "The heat of shortening and the dynamic constants of muscle", eq. 3).
///
/// A motor has its whole torque at any speed: a fist that meets a crate would push it along like a
/// machine. Here a fast joint has what its own motion needs, and what is left of the whole torque at
/// that speed, which comes back within half a second. What resists a slow or resting joint still meets
/// all of it.
class Muscles {
public:
	/// A torque that would change by less than this share of the whole stays as it is: so small a change
	/// is not felt, and the engine need not be told of it. Full torque is never held back.
	static constexpr float DEAD_BAND = 1.0f / 32.0f;
	/// F0 / a of Hill's equation: how bent the curve is.
	static constexpr float CURVE = 4.0f;
	/// Share of the torque that is left at any speed: with less, a swing on a crate of 10 kg gives less
	/// than 0.7 of the inelastic estimate (bench contacts --scene=fist; 0.19 gives 0.67).
	static constexpr float MIN = 0.25f;
	/// How much of the torque comes back in a second.
	static constexpr float RECOVERY = 2.0f;

	Muscles() = default;
	explicit Muscles(std::size_t p_limb_count) :
			_before(p_limb_count), _left(p_limb_count, 1.0f), _given(p_limb_count, 1.0f) {}

	/// The joint's greatest torque for a step, N m, at most p_whole. Call it once a step for each joint.
	/// @param p_forward the motion's velocity relative to the parent, limb's axes, rad/s
	/// @param p_missing what the joint lacks to its target velocity, rad/s
	/// @param p_inertia what the joint has to turn, about the limb's axes, kg m^2
	/// @param p_fast speed (rad/s) from which MIN is left
	float get_torque(std::size_t p_limb, const Vec3 &p_forward, const Vec3 &p_missing, const Vec3 &p_inertia,
			float p_fast, float p_delta_s, float p_whole);
	void reset();

	void save(ArchiveWriter &p_archive) const {
		p_archive.put_all(_before);
		p_archive.put_all(_left);
		p_archive.put_all(_given);
	}
	bool restore(ArchiveReader &p_archive) {
		return p_archive.get_all(_before) && p_archive.get_all(_left) && p_archive.get_all(_given);
	}

private:
	std::vector<Vec3> _before; // The motion's velocity in the last step, rad/s.
	std::vector<float> _left; // Share of the whole torque.
	std::vector<float> _given; // The share of the last step.
};

} // namespace ragdoll
