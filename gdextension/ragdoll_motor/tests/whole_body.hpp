// SPDX-License-Identifier: MIT
#pragma once

#include "body/leg.hpp"
#include "body/rig.hpp"

#include <algorithm>
#include <vector>

/// A whole body with shapes for tests, of the measures of a broad adult in gear: it faces Z, its left is X, and its
/// rest pose has the arms stretched to the sides.
namespace whole_body {

enum Part : int {
	HIPS,
	SPINE,
	CHEST,
	HEAD,
	LEFT_UPPER_ARM,
	LEFT_LOWER_ARM,
	LEFT_HAND,
	RIGHT_UPPER_ARM,
	RIGHT_LOWER_ARM,
	RIGHT_HAND,
	LEFT_UPPER_LEG,
	LEFT_LOWER_LEG,
	LEFT_FOOT,
	RIGHT_UPPER_LEG,
	RIGHT_LOWER_LEG,
	RIGHT_FOOT,
	COUNT,
};

inline ragdoll::Segment part(int p_parent, const ragdoll::Vec3 &p_anchor, const ragdoll::Vec3 &p_centre, int p_group) {
	ragdoll::Segment limb;
	limb.parent = p_parent;
	limb.anchor = p_anchor;
	limb.centre = p_centre;
	limb.group = p_group;
	limb.mass = 5.0f;
	limb.max_torque = 100.0f;
	return limb;
}

inline ragdoll::LimbShape box(const ragdoll::Vec3 &p_size) {
	return { ragdoll::LimbShape::Type::BOX, ragdoll::Quat(), p_size * 0.5f };
}

/// A pill along a direction.
inline ragdoll::LimbShape pill(float p_radius, float p_length, bool p_is_level) {
	const ragdoll::Quat level = ragdoll::exp({ 0.0f, 0.0f, -0.5f * ragdoll::PI });
	return { ragdoll::LimbShape::Type::PILL, p_is_level ? level : ragdoll::Quat(),
		{ p_radius, 0.5f * p_length, p_radius } };
}

/// @param p_scale of all sizes
inline std::vector<ragdoll::Segment> limbs(float p_scale = 1.0f) {
	std::vector<ragdoll::Segment> result;
	const auto add = [&](ragdoll::Segment p_limb, ragdoll::LimbShape p_shape) {
		p_limb.anchor = p_limb.anchor * p_scale;
		p_limb.centre = p_limb.centre * p_scale;
		p_limb.shape = p_shape;
		p_limb.shape.half = p_shape.half * p_scale;
		result.push_back(p_limb);
	};
	add(part(-1, {}, { 0.0f, 0.005f, 0.01f }, 0), box({ 0.384f, 0.178f, 0.249f }));
	add(part(HIPS, { 0.0f, 0.094f, 0.015f }, { 0.0f, 0.049f, 0.01f }, 0), box({ 0.323f, 0.097f, 0.263f }));
	add(part(SPINE, { 0.0f, 0.097f, -0.019f }, { 0.0f, 0.171f, 0.015f }, 0), box({ 0.362f, 0.343f, 0.34f }));
	add(part(CHEST, { 0.0f, 0.387f, 0.013f }, { 0.0f, 0.104f, 0.038f }, 1), pill(0.101f, 0.05f, false));
	for (const float side : { 1.0f, -1.0f }) {
		const int group = side > 0.0f ? 2 : 3;
		const int first = int(result.size());
		add(part(CHEST, { 0.209f * side, 0.236f, 0.013f }, { 0.131f * side, 0.0f, 0.0f }, group),
				pill(0.075f, 0.257f, true));
		add(part(first, { 0.261f * side, 0.0f, 0.0f }, { 0.126f * side, -0.01f, 0.014f }, group),
				pill(0.057f, 0.249f, true));
		add(part(first + 1, { 0.274f * side, 0.0f, 0.0f }, { 0.109f * side, 0.0f, 0.0f }, group),
				box({ 0.176f, 0.065f, 0.115f }));
	}
	for (const float side : { 1.0f, -1.0f }) {
		const int group = side > 0.0f ? 4 : 5;
		const int first = int(result.size());
		add(part(HIPS, { 0.113f * side, -0.046f, -0.018f }, { 0.0f, -0.22f, 0.0f }, group),
				pill(0.097f, 0.441f, false));
		add(part(first, { 0.02f * side, -0.44f, 0.0f }, { 0.0f, -0.2f, 0.0f }, group), pill(0.078f, 0.406f, false));
		add(part(first + 1, { 0.02f * side, -0.455f, 0.0f }, { 0.0f, -0.045f, 0.047f }, group),
				box({ 0.112f, 0.082f, 0.211f }));
		result.back().is_foot = true;
	}
	return result;
}

/// The rest pose.
inline ragdoll::Pose rest() {
	ragdoll::Pose pose;
	pose.orientations.assign(COUNT, ragdoll::Quat());
	return pose;
}

/// Brings the wrist of an arm to a place relative to the shoulder, in lengths of the arm, the elbow towards a
/// direction, the fingers in another. For the left arm; the right one is mirrored.
inline void bend_arm(const ragdoll::Rig &p_rig, bool p_left, ragdoll::Vec3 p_wrist, ragdoll::Vec3 p_elbow,
		ragdoll::Vec3 p_fingers, ragdoll::Pose &r_pose) {
	using namespace ragdoll;
	const float side = p_left ? 1.0f : -1.0f;
	const std::size_t upper = p_left ? LEFT_UPPER_ARM : RIGHT_UPPER_ARM;
	const float a = p_rig[upper + 1].anchor.length();
	const float b = p_rig[upper + 2].anchor.length();
	for (Vec3 *vector : { &p_wrist, &p_elbow, &p_fingers }) {
		vector->x *= side;
	}
	const float reach = std::clamp(p_wrist.length() * (a + b), 0.2f * a, 0.999f * (a + b));
	const Vec3 ahead = p_wrist * (1.0f / p_wrist.length());
	const Vec3 across = p_elbow - ahead * p_elbow.dot(ahead);
	const float along = (a * a - b * b + reach * reach) / (2.0f * reach);
	const float away = std::sqrt(std::max(a * a - along * along, 0.0f));
	const Vec3 elbow = ahead * along + across * (away / across.length());
	const Vec3 forearm = ahead * reach - elbow;
	r_pose.orientations[upper] = rotation_between({ side, 0.0f, 0.0f }, elbow);
	r_pose.orientations[upper + 1] = rotation_between(elbow, forearm) * r_pose.orientations[upper];
	r_pose.orientations[upper + 2] = rotation_between(forearm, p_fingers) * r_pose.orientations[upper + 1];
}

/// Standing with arms that hang a little away from the body.
inline ragdoll::Pose standing(const ragdoll::Rig &p_rig) {
	ragdoll::Pose pose = rest();
	for (const bool left : { true, false }) {
		bend_arm(p_rig, left, { 0.5f, -0.8f, 0.2f }, { 0.0f, 0.0f, -1.0f }, { 0.1f, -1.0f, 0.1f }, pose);
	}
	return pose;
}

/// How deep points of a limb's axis, thick by its radius (of boxes: half of the least size), lie in another limb, m.
inline float find_depth(
		const ragdoll::Rig &p_rig, const ragdoll::Pose &p_pose, std::size_t p_limb, std::size_t p_other) {
	using namespace ragdoll;
	std::vector<Vec3> joints;
	p_rig.joint_positions(p_pose, joints);
	const LimbShape &shape = p_rig[p_limb].shape;
	const LimbShape &other = p_rig[p_other].shape;
	const bool is_box = shape.type == LimbShape::Type::BOX;
	const Vec3 half = is_box ? Vec3{ shape.half.x, 0.0f, 0.0f } : Vec3{ 0.0f, shape.half.y, 0.0f };
	const float radius = is_box ? shape.half.y : shape.half.x;
	const Quat turn = p_pose.orientations[p_limb] * shape.turn;
	const Quat into = (p_pose.orientations[p_other] * other.turn).inverse();
	const Vec3 centre = joints[p_limb] + p_pose.orientations[p_limb].rotate(p_rig[p_limb].centre) - joints[p_other] -
			p_pose.orientations[p_other].rotate(p_rig[p_other].centre);
	float deepest = -1.0f;
	for (int point = 0; point < 9; point++) {
		const Vec3 at = into.rotate(centre + turn.rotate(half * (float(point) / 4.0f - 1.0f)));
		Vec3 out{ std::fabs(at.x) - other.half.x, std::fabs(at.y) - other.half.y, std::fabs(at.z) - other.half.z };
		float outside = std::min(std::max({ out.x, out.y, out.z }), 0.0f);
		if (other.type == LimbShape::Type::PILL) {
			out = { at.x, at.y - std::clamp(at.y, -other.half.y, other.half.y), at.z };
			outside = -other.half.x;
		}
		for (float *axis : { &out.x, &out.y, &out.z }) {
			*axis = other.type == LimbShape::Type::PILL ? *axis : std::max(*axis, 0.0f);
		}
		deepest = std::max(deepest, radius - out.length() - outside);
	}
	return deepest;
}

/// The deepest of forearms and hands in trunk, head, legs and the other arm, m.
inline float find_depth(const ragdoll::Rig &p_rig, const ragdoll::Pose &p_pose) {
	float deepest = 0.0f;
	for (const Part limb : { LEFT_LOWER_ARM, LEFT_HAND, RIGHT_LOWER_ARM, RIGHT_HAND }) {
		for (int other = HIPS; other < COUNT; other++) {
			const bool is_left = limb <= LEFT_HAND;
			const bool is_own = is_left ? other >= LEFT_UPPER_ARM && other <= LEFT_HAND
										: other >= RIGHT_UPPER_ARM && other <= RIGHT_HAND;
			if (!is_own && other != LEFT_FOOT && other != RIGHT_FOOT) {
				deepest = std::max(deepest, find_depth(p_rig, p_pose, limb, std::size_t(other)));
			}
		}
	}
	return deepest;
}

} // namespace whole_body
