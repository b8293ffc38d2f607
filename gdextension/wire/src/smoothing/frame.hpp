// SPDX-License-Identifier: MIT
#pragma once

#include "../person_state.hpp"

namespace wire {

/// Where something is that consists of a place and N orientations: a person's limbs, or a body (1).
template <std::size_t N>
struct Frame {
	Vec3 position; ///< m
	std::array<Quat, N> turns{}; ///< Orientations in the world.
};

/// From one Frame to another: a way (m) and rotation vectors in the world (rad). Or so much per second.
template <std::size_t N>
struct Shift {
	Vec3 way;
	std::array<Vec3, N> turns{};
};

/// The frame, shifted by p_factor times a shift. Only the first p_count orientations are looked at, here
/// and below.
template <std::size_t N>
inline void apply(Frame<N> &r_frame, const Shift<N> &p_shift, float p_factor, std::size_t p_count) {
	r_frame.position = r_frame.position + p_shift.way * p_factor;
	for (std::size_t i = 0; i < p_count; i++) {
		r_frame.turns[i] = (kinematics::exp(p_shift.turns[i] * p_factor) * r_frame.turns[i]).normalized();
	}
}

/// What takes one frame to another, times a factor.
template <std::size_t N>
inline Shift<N> between(const Frame<N> &p_from, const Frame<N> &p_to, float p_factor, std::size_t p_count) {
	Shift<N> shift;
	shift.way = (p_to.position - p_from.position) * p_factor;
	for (std::size_t i = 0; i < p_count; i++) {
		shift.turns[i] = kinematics::log(p_to.turns[i] * p_from.turns[i].inverse()) * p_factor;
	}
	return shift;
}

/// p_first * p_a + p_second * p_b.
template <std::size_t N>
inline Shift<N> mix(const Shift<N> &p_first, float p_a, const Shift<N> &p_second, float p_b, std::size_t p_count) {
	Shift<N> shift;
	shift.way = p_first.way * p_a + p_second.way * p_b;
	for (std::size_t i = 0; i < p_count; i++) {
		shift.turns[i] = p_first.turns[i] * p_a + p_second.turns[i] * p_b;
	}
	return shift;
}

/// Shortens what is longer than these, m and rad (or so much per second).
template <std::size_t N>
inline void limit(Shift<N> &r_shift, float p_way, float p_turn, std::size_t p_count) {
	r_shift.way = r_shift.way.limited(p_way);
	for (std::size_t i = 0; i < p_count; i++) {
		r_shift.turns[i] = r_shift.turns[i].limited(p_turn);
	}
}

} // namespace wire
