// SPDX-License-Identifier: MIT
#pragma once

#include "person_state.hpp"

namespace wire {

/// Where something is that consists of a position and N orientations: a person's limbs, or a body (1).
template <std::size_t N>
struct Frame {
	Vec3 position; ///< m
	std::array<Quat, N> turns{}; ///< Orientations in the world.
};

/// From one Frame to another: a displacement (m) and rotation vectors in the world (rad). Or so much per second.
template <std::size_t N>
struct Delta {
	Vec3 displacement;
	std::array<Vec3, N> turns{};
};

/// The frame, shifted by p_factor times a delta. Only the first p_count orientations are looked at, here
/// and below.
template <std::size_t N>
inline void apply(Frame<N> &r_frame, const Delta<N> &p_delta, float p_factor, std::size_t p_count) {
	r_frame.position = r_frame.position + p_delta.displacement * p_factor;
	for (std::size_t i = 0; i < p_count; i++) {
		r_frame.turns[i] = (kinematics::exp(p_delta.turns[i] * p_factor) * r_frame.turns[i]).normalized();
	}
}

/// What takes one frame to another, times a factor.
template <std::size_t N>
inline Delta<N> between(const Frame<N> &p_from, const Frame<N> &p_to, float p_factor, std::size_t p_count) {
	Delta<N> delta;
	delta.displacement = (p_to.position - p_from.position) * p_factor;
	for (std::size_t i = 0; i < p_count; i++) {
		delta.turns[i] = kinematics::log(p_to.turns[i] * p_from.turns[i].inverse()) * p_factor;
	}
	return delta;
}

/// p_first * p_a + p_second * p_b.
template <std::size_t N>
inline Delta<N> mix(const Delta<N> &p_first, float p_a, const Delta<N> &p_second, float p_b, std::size_t p_count) {
	Delta<N> delta;
	delta.displacement = p_first.displacement * p_a + p_second.displacement * p_b;
	for (std::size_t i = 0; i < p_count; i++) {
		delta.turns[i] = p_first.turns[i] * p_a + p_second.turns[i] * p_b;
	}
	return delta;
}

/// Shortens what is longer than these, m and rad (or so much per second).
template <std::size_t N>
inline void limit(Delta<N> &r_delta, float p_displacement, float p_turn, std::size_t p_count) {
	r_delta.displacement = r_delta.displacement.limited(p_displacement);
	for (std::size_t i = 0; i < p_count; i++) {
		r_delta.turns[i] = r_delta.turns[i].limited(p_turn);
	}
}

/// A frame that is given in that of a carrier, in the world.
template <std::size_t N>
inline Frame<N> carried(const Frame<1> &p_carrier, const Frame<N> &p_frame, std::size_t p_count) {
	Frame<N> frame;
	frame.position = p_carrier.position + p_carrier.turns[0].rotate(p_frame.position);
	for (std::size_t i = 0; i < p_count; i++) {
		frame.turns[i] = (p_carrier.turns[0] * p_frame.turns[i]).normalized();
	}
	return frame;
}

/// The inverse: a frame that is given in the world, in that of a carrier.
template <std::size_t N>
inline Frame<N> seen_from(const Frame<1> &p_carrier, const Frame<N> &p_frame, std::size_t p_count) {
	const Quat back = p_carrier.turns[0].inverse();
	Frame<N> frame;
	frame.position = back.rotate(p_frame.position - p_carrier.position);
	for (std::size_t i = 0; i < p_count; i++) {
		frame.turns[i] = (back * p_frame.turns[i]).normalized();
	}
	return frame;
}

} // namespace wire
