// SPDX-License-Identifier: MIT
#pragma once

#include "body/leg.hpp"
#include "body/rig.hpp"

#include <array>
#include <vector>

namespace ragdoll {

constexpr Vec3 UP{ 0.0f, 1.0f, 0.0f };

/// A pose by the angles of the joints, rad; all 0 for somebody who stands with hanging arms. Of pairs the first is
/// the left one. What bends ahead (a thigh, a trunk, an elbow) or up (toes, hand) does so with a positive angle; a
/// knee bends back.
struct JointAngles {
	float pitch = 0.0f; ///< How far the hips lean ahead in the world: 90 degrees face down, -90 face up.
	float spine = 0.0f; ///< All joints from the hips to the shoulders together.
	float neck = 0.0f; ///< Back.
	std::array<float, 2> thigh{};
	std::array<float, 2> thigh_out{};
	std::array<float, 2> knee{};
	std::array<float, 2> ankle{};
	std::array<float, 2> arm{};
	std::array<float, 2> arm_out{};
	std::array<float, 2> elbow{};
	std::array<float, 2> wrist{};

	JointAngles mirrored() const;
};

/// The arms of a body: limbs that hang beside others above the legs, and carry limbs themselves.
std::vector<std::size_t> find_arms(const Rig &p_rig);

/// Which limb of a body is which, and about what its joints bend: poses by angles for a body of any build.
class Anatomy {
public:
	Anatomy() = default;
	/// Knows nothing (is_known()) of bodies that have other than two legs.
	Anatomy(const Rig &p_rig, const std::vector<Leg> &p_legs, const std::vector<std::size_t> &p_arms);

	bool is_known() const { return _known; }
	/// World orientations of all limbs.
	/// @param p_heading from the rest pose's axes to where the face is to look, about the vertical
	void pose(const JointAngles &p_angles, const Quat &p_heading, std::vector<Quat> &r_orientations) const;
	/// Orientation of the hips alone.
	Quat get_hips(const JointAngles &p_angles, const Quat &p_heading) const;
	/// The directions of somebody's hips in the world.
	Vec3 get_left(const Quat &p_hips) const { return turn_of(p_hips).rotate(_left); }
	Vec3 get_ahead(const Quat &p_hips) const { return turn_of(p_hips).rotate(_ahead); }
	Vec3 get_up(const Quat &p_hips) const { return turn_of(p_hips).rotate(UP); }
	/// Where a heading looks, horizontal.
	Vec3 get_view(const Quat &p_heading) const { return p_heading.rotate(_ahead); }
	/// The heading that looks in a direction.
	Quat find_heading(const Vec3 &p_ahead) const;
	/// Where a foot points, world axes; horizontal where it stands on level ground.
	Vec3 get_toes(std::size_t p_foot, const Quat &p_orientation) const {
		return (p_orientation * _limbs[p_foot].neutral.inverse()).rotate(_ahead);
	}
	bool is_foot(std::size_t p_limb) const { return _limbs[p_limb].part == Part::FOOT; }

private:
	enum class Part : int {
		OTHER,
		SPINE,
		HEAD,
		THIGH,
		SHIN,
		FOOT,
		UPPER_ARM,
		FOREARM,
		HAND
	};
	struct Limb {
		Part part = Part::OTHER;
		int parent = -1;
		std::size_t side = 0; // 0 is the left one.
		Quat neutral; // Orientation where all angles are 0.
	};

	Quat turn_of(const Quat &p_hips) const { return p_hips * _limbs[0].neutral.inverse(); }
	void find_axes(const Rig &p_rig, const std::vector<Leg> &p_legs);
	void add_leg(const Rig &p_rig, const Leg &p_leg);
	void add_arm(const Rig &p_rig, std::size_t p_first);
	void add_trunk(const Rig &p_rig, const std::vector<std::size_t> &p_arms);
	/// A limb that points straight down where all angles are 0.
	void hang(const Rig &p_rig, int p_limb, Part p_part, std::size_t p_side, const Vec3 &p_along);
	Quat find_turn(const Limb &p_limb, const JointAngles &p_angles) const;

	std::vector<Limb> _limbs;
	Vec3 _left; // In the rest pose.
	Vec3 _ahead;
	float _spine_share = 0.0f; // Of the spine's bend, for each joint.
	bool _known = false;
};

} // namespace ragdoll
