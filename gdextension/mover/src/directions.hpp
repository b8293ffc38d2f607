// SPDX-License-Identifier: MIT
#pragma once

#include "mover_state.hpp"

#include <headings.hpp>

#include <algorithm>
#include <cmath>

/// Directions, angles and contacts as a mover reckons with them.
namespace mover {

using kinematics::facing_of;
using kinematics::level;
using kinematics::wrapped;

constexpr float FLOOR = 0.69f; // Normals that point up by this are ground: 46 degrees.
constexpr float LEAST = 1e-5f; // m
constexpr float GRID = 4096.0f; // Steps in a metre, and in a metre a second.

constexpr Vec3 DOWN{ 0.0f, -1.0f, 0.0f };
constexpr Vec3 UP{ 0.0f, 1.0f, 0.0f };

inline Vec3 normalized(const Vec3 &p_vector) {
	const float length = p_vector.length();
	return length > LEAST ? p_vector * (1.0f / length) : Vec3();
}

inline Vec3 slid(const Vec3 &p_vector, const Vec3 &p_normal) {
	return p_vector - p_normal * p_vector.dot(p_normal);
}

/// A level motion as it goes on up a slope, as far along it.
inline Vec3 uphill(const Vec3 &p_motion, const Vec3 &p_normal) {
	const float into = p_motion.dot(p_normal);
	const Vec3 along{ p_motion.x, p_motion.y - std::min(into, 0.0f) / p_normal.y, p_motion.z };
	return along.limited(p_motion.length());
}

/// Towards a value by at most a step.
inline Vec3 approached(const Vec3 &p_from, const Vec3 &p_to, float p_step) {
	return p_from + (p_to - p_from).limited(p_step);
}

inline Vec3 facing(float p_heading) {
	return { std::sin(p_heading), 0.0f, std::cos(p_heading) };
}

inline Vec3 rounded(const Vec3 &p_vector) {
	const auto number = [](float p_number) { return std::round(p_number * GRID) / GRID; };
	return { number(p_vector.x), number(p_vector.y), number(p_vector.z) };
}

inline State at_step(const State &p_state, const Vec3 &p_position) {
	State state = p_state;
	state.position = p_position;
	return state;
}

inline const Contact *floor_among(const Sweep &p_sweep) {
	for (int i = 0; i < p_sweep.count; i++) {
		if (p_sweep.contacts[std::size_t(i)].normal.y > FLOOR) {
			return &p_sweep.contacts[std::size_t(i)];
		}
	}
	return nullptr;
}

inline const Contact *wall_among(const Sweep &p_sweep, const Vec3 &p_motion) {
	for (int i = 0; i < p_sweep.count; i++) {
		const Contact &contact = p_sweep.contacts[std::size_t(i)];
		if (contact.normal.y < FLOOR && contact.normal.dot(p_motion) < 0.0f) {
			return &contact;
		}
	}
	return nullptr;
}

} // namespace mover
