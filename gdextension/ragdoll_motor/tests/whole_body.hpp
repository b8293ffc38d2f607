// SPDX-License-Identifier: MIT
#pragma once

#include "body/rig.hpp"

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

} // namespace whole_body
