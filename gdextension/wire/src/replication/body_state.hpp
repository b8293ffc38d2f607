// SPDX-License-Identifier: MIT
#pragma once

#include "updates.hpp"

namespace wire {

/// Where a rigid body is, on the lattice that server and clients share.
struct BodyState {
	std::array<int32_t, 3> position{}; ///< mm
	std::array<int16_t, 3> velocity{}; ///< In units of 1 / BODY_VELOCITY_SCALE m/s.
	std::array<int16_t, 3> spin{}; ///< In units of 1 / BODY_SPIN_SCALE rad/s, in the world's axes.
	RotationCode turn; ///< Components times BODY_TURN_SCALE.
	bool at_rest = false; ///< Velocity and spin are 0 then.
};

constexpr int BODY_VELOCITY_SCALE = 64;
constexpr int BODY_SPIN_SCALE = 16;
/// Turns are off by less than 0.8 degrees, mostly by 0.2.
constexpr int BODY_TURN_SCALE = 255;
/// Positions beyond this (m) are cut off.
constexpr float FARTHEST_M = 1e5f;

/// The nearest state of the lattice. What is not finite becomes 0, or no rotation.
BodyState quantise_body(const BodyUpdate &p_body);
/// What a receiver makes of a state.
void restore_body(const BodyState &p_state, BodyUpdate &r_body);

/// Where a body would be so many ticks after a state, if it went on evenly from that state's velocity
/// to another's. Whole numbers only: every machine comes to the same.
std::array<int32_t, 3> foresee_position(
		const BodyState &p_base, const std::array<int16_t, 3> &p_velocity, int p_ticks, int p_tick_rate);
/// The same for the orientation, in the terms of the component that is left out there.
std::array<int16_t, 3> foresee_turn(
		const BodyState &p_base, const std::array<int16_t, 3> &p_spin, int p_ticks, int p_tick_rate, int p_dropped);

} // namespace wire
