// SPDX-License-Identifier: MIT
#pragma once

#include "body/rig.hpp"
#include "control/limb_control.hpp"

#include <cstddef>
#include <vector>

namespace ragdoll {

/// What a limb's body gets for a step from outside, world axes.
struct LimbPush {
	Vec3 force; ///< At the body's centre, N.
	Vec3 torque; ///< N m
};

/// Pulls limbs towards where the motion has them in the world, whatever their parents do.
///
/// The springs are taken at the end of the step, as if the limb were alone (Tan, Liu, Turk 2011, "Stable
/// proportional-derivative controllers", eq. 4), so that no strength makes them explode. A limb has to
/// carry what hangs on it: strength is by the mass and the inertia of the subtree.
class WorldDrive {
public:
	WorldDrive() = default;
	explicit WorldDrive(std::size_t p_limb_count) : _limbs(p_limb_count) {}

	/// Changes a limb's springs within a time, s.
	void set(std::size_t p_limb, const DriveStrength &p_angular, const DriveStrength &p_linear, float p_blend_s);
	void advance(float p_delta_s);
	/// Whether any limb is pulled.
	bool is_active() const { return _active > 0; }
	bool is_pulled(std::size_t p_limb) const { return _limbs[p_limb].angular.is_on || _limbs[p_limb].linear.is_on; }

	/// @param p_now, p_next the motion at the beginning and at the end of the step
	/// @param p_joints_now, p_joints_next where it has the limbs' joints then, m
	void compute(const Rig &p_rig, const RigState &p_state, const Pose &p_now, const Pose &p_next,
			const std::vector<Vec3> &p_joints_now, const std::vector<Vec3> &p_joints_next, float p_delta_s,
			std::vector<LimbPush> &r_pushes) const;

	void save(ArchiveWriter &p_archive) const;
	bool restore(ArchiveReader &p_archive);

private:
	struct Spring {
		Ramp strength{ 0.0f };
		Ramp damping_ratio{ 1.0f };
		Ramp most{ 0.0f };
		bool is_limited = false;
		bool is_on = false;

		void set(const DriveStrength &p_wanted, float p_blend_s);
		void advance(float p_delta_s);
		float limit() const;
	};
	struct Limb {
		Spring angular;
		Spring linear;
	};

	void count();

	std::vector<Limb> _limbs;
	std::size_t _active = 0;
};

} // namespace ragdoll
