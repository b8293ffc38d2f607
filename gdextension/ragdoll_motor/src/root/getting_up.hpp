// SPDX-License-Identifier: MIT
#pragma once

#include "base/archive.hpp"
#include "body/rig.hpp"

namespace ragdoll {

/// Lifts the root of a body that gets up after it was limp: a leg that lies askew could not pass under it.
class GettingUp {
public:
	/// The lift for each radian that the limbs are off on average, m/rad.
	static constexpr float LIFT = 0.6f;
	/// Something may lie on a body whose travel is found. From STUCK_S seconds on it is lifted further, each
	/// second by MORE times as far again, up to MOST times as far, until that falls off.
	static constexpr float STUCK_S = 1.0f;
	static constexpr float MORE = 2.0f;
	static constexpr float MOST = 3.0f;
	/// A body has got up when its limbs have been off by less than UPRIGHT (rad) for UPRIGHT_S seconds: legs that
	/// swing pass through the pose without being there.
	static constexpr float UPRIGHT = 0.02f;
	static constexpr float UPRIGHT_S = 0.2f;

	/// Begins a step.
	/// @param p_highest how far the target may be above the body's root where the travel is found, m
	void advance(const RigState &p_state, const Pose &p_now, const Pose &p_next, bool p_is_limp, bool p_finds_travel,
			float p_highest, float p_delta_s);
	/// How far the root is lifted in this step, m.
	const Vec3 &get_lift() const { return _lift; }

	void save(ArchiveWriter &p_archive) const;
	bool restore(ArchiveReader &p_archive);

private:
	float find_lift(const RigState &p_state, const Pose &p_now, const Pose &p_next, bool p_finds_travel,
			float p_highest, float p_delta_s);

	bool _was_limp = false;
	bool _is_getting_up = false;
	float _since_s = 0.0f; // How long it has been getting up, where the travel is found.
	float _upright_s = 0.0f; // For how long its limbs have been where they belong.
	Vec3 _lift; // m
};

} // namespace ragdoll
