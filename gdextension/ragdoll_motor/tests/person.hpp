// SPDX-License-Identifier: MIT
#pragma once

#include "body/leg.hpp"
#include "body/rig.hpp"
#include "state_of.hpp"

#include <vector>

/// A body with all limbs, for tests of what bends them. It stands upright along Y, looks along Z, its left side is
/// towards X, and its arms are held out.
namespace person {

using fixtures::state_of;

enum Limb : int {
	HIPS,
	SPINE,
	HEAD,
	LEFT_ARM,
	LEFT_FOREARM,
	LEFT_HAND,
	RIGHT_ARM,
	RIGHT_FOREARM,
	RIGHT_HAND,
	LEFT_THIGH,
	LEFT_SHIN,
	LEFT_FOOT,
	RIGHT_THIGH,
	RIGHT_SHIN,
	RIGHT_FOOT,
	COUNT
};

inline std::vector<ragdoll::Segment> limbs() {
	std::vector<ragdoll::Segment> result(COUNT);
	const auto add = [&](int p_limb, int p_parent, ragdoll::Vec3 p_anchor, ragdoll::Vec3 p_centre, float p_mass) {
		result[std::size_t(p_limb)].parent = p_parent;
		result[std::size_t(p_limb)].anchor = p_anchor;
		result[std::size_t(p_limb)].centre = p_centre;
		result[std::size_t(p_limb)].mass = p_mass;
		result[std::size_t(p_limb)].inertia = { 0.1f, 0.1f, 0.1f };
		result[std::size_t(p_limb)].max_torque = 300.0f;
	};
	add(HIPS, -1, {}, {}, 12.0f);
	add(SPINE, HIPS, { 0.0f, 0.1f, 0.0f }, { 0.0f, 0.2f, 0.0f }, 30.0f);
	add(HEAD, SPINE, { 0.0f, 0.5f, 0.0f }, { 0.0f, 0.1f, 0.0f }, 5.0f);
	for (const int first : { int(LEFT_ARM), int(RIGHT_ARM) }) {
		const float out = first == LEFT_ARM ? 1.0f : -1.0f;
		add(first, SPINE, { 0.2f * out, 0.4f, 0.0f }, { 0.15f * out, 0.0f, 0.0f }, 2.0f);
		add(first + 1, first, { 0.3f * out, 0.0f, 0.0f }, { 0.12f * out, 0.0f, 0.0f }, 1.5f);
		add(first + 2, first + 1, { 0.25f * out, 0.0f, 0.0f }, { 0.08f * out, 0.0f, 0.0f }, 0.5f);
	}
	for (const int first : { int(LEFT_THIGH), int(RIGHT_THIGH) }) {
		const float out = first == LEFT_THIGH ? 1.0f : -1.0f;
		add(first, HIPS, { 0.1f * out, 0.0f, 0.0f }, { 0.0f, -0.2f, 0.0f }, 8.0f);
		add(first + 1, first, { 0.0f, -0.45f, 0.0f }, { 0.0f, -0.2f, 0.0f }, 4.0f);
		add(first + 2, first + 1, { 0.0f, -0.45f, 0.0f }, { 0.0f, -0.05f, 0.08f }, 1.0f);
		result[std::size_t(first) + 2].is_foot = true;
	}
	return result;
}

inline std::vector<ragdoll::ContactPoint> soles() {
	std::vector<ragdoll::ContactPoint> result;
	for (const int foot : { int(LEFT_FOOT), int(RIGHT_FOOT) }) {
		result.push_back({ foot, { 0.0f, -0.09f, -0.05f }, 0.01f, true });
		result.push_back({ foot, { 0.0f, -0.09f, 0.15f }, 0.01f, true });
	}
	return result;
}

/// Stretched out, turned from standing.
inline ragdoll::Pose turned(const ragdoll::Quat &p_turn) {
	ragdoll::Pose pose;
	pose.orientations.assign(COUNT, p_turn);
	pose.root = { 0.0f, 0.15f, 0.0f };
	return pose;
}

} // namespace person
