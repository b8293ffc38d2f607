// SPDX-License-Identifier: MIT
#pragma once

#include "base/vectors.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace ragdoll {

/// Most limbs that one ragdoll can have.
constexpr std::size_t MAX_LIMBS = 64;
/// Most contact points of one limb.
constexpr std::size_t MAX_CONTACT_POINTS = 64;

/// One limb as the thesis describes it (section 6.2): a pill or box in the rest pose, model space.
struct Limb {
	enum Type : int { // Of a fixed size: a file may hold any number.
		PILL,
		BOX,
	};

	std::string bone;
	std::string parent_bone; // Empty for the root.
	std::string group;
	Type type = PILL;
	Vec3 position;
	Quat orientation;
	float radius = 0.05f;
	float length = 0.1f; // Of a pill's cylinder, without its caps.
	Vec3 size{ 0.1f, 0.1f, 0.1f };
	Vec3 anchor;
	Quat rest_orientation;
	Quat reset_orientation;
	float mass_fraction = 0.0f;
	float max_torque = 100.0f;
	std::vector<Vec3> contact_points;
	float contact_radius = 0.0f;
	Vec3 min_angles;
	Vec3 max_angles;
};

/// Principal moments of inertia about the centre, kg m^2, in the shape's own axes.
Vec3 shape_inertia(const Limb &p_limb, float p_mass);

/// Moments of inertia about the body's axes (rest_orientation), kg m^2: the diagonal of the tensor.
/// What lies beside it is small for shapes that follow their bones.
Vec3 body_inertia(const Limb &p_limb, float p_mass);

/// The joint's frame in model space in the reset pose: X is the model's axis that runs along the
/// limb, away from the joint; Y is the front for upright limbs, up for the others; Z = X x Y is the
/// axis of flexion.
Quat joint_axes(const Limb &p_limb);

/// Why this cannot be a limb, or an empty text.
std::string find_fault(const Limb &p_limb);

/// Why this cannot be a ragdoll of a mass (kg), or an empty text.
std::string find_fault(const std::vector<Limb> &p_limbs, double p_mass);

} // namespace ragdoll
