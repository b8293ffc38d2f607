// SPDX-License-Identifier: MIT
#pragma once

#include "body/rig.hpp"

#include <cstddef>
#include <vector>

namespace ragdoll {

/// What the motor of each joint has to turn in the pose that the bodies have: the inertia of the limb
/// and of all that hangs on it. One pass from the leaves to the root, of composite bodies (Featherstone
/// 2008, Rigid Body Dynamics Algorithms, section 6.2).
class CompositeInertia {
public:
	CompositeInertia() = default;
	explicit CompositeInertia(std::size_t p_limb_count) :
			_composites(p_limb_count), _axes(p_limb_count), _moments(p_limb_count) {}

	void find(const Rig &p_rig, const RigState &p_state);
	/// Moments about the limb's joint and axes at the last find(), kg m^2.
	const Vec3 &operator[](std::size_t p_limb) const { return _moments[p_limb]; }

private:
	/// A limb's axes in the world.
	struct Axes {
		Vec3 x;
		Vec3 y;
		Vec3 z;
	};

	/// Some limbs as one body: its moments about the root's joint, world axes.
	struct Composite {
		float mass = 0.0f; ///< kg
		Vec3 first; ///< Mass times position of its centre, kg m.
		Vec3 diagonal; ///< xx, yy, zz of the inertia, kg m^2.
		Vec3 products; ///< yz, xz, xy of it.

		void add(const Composite &p_other);
		void set_body(const Vec3 &p_moments, const Axes &p_axes, const Vec3 &p_centre);
		Vec3 moments_about(const Vec3 &p_point, const Axes &p_axes) const;
	};

	std::vector<Composite> _composites;
	std::vector<Axes> _axes;
	std::vector<Vec3> _moments;
};

} // namespace ragdoll
