// SPDX-License-Identifier: MIT
#pragma once

#include "motion_clip.hpp"

#include <array>
#include <vector>

namespace matching {

/// What is compared between a moment of a clip and what is wanted, in heights of the hips and seconds in the frame of
/// the person's way (Clavet 2016, Holden 2020): places and headings in a third, two thirds of and a whole second, the
/// ankles and how they move, how the hips move.
constexpr std::size_t FEATURES = 27;
/// Floats of a row: whole vectors.
constexpr std::size_t ROW = 32;
using Features = std::array<float, ROW>;

/// Where each part begins.
enum FeaturePart : std::size_t {
	PLACES = 0,
	DIRECTIONS = 6,
	ANKLES = 12,
	ANKLE_VELOCITIES = 18,
	HIPS_VELOCITY = 24
};

/// How far ahead a way is compared, s.
constexpr std::array<float, 3> AHEAD{ 1.0f / 3.0f, 2.0f / 3.0f, 1.0f };

/// Where somebody is going to be: on the ground, relative to where he is.
struct Way {
	std::array<float, 3> x{};
	std::array<float, 3> z{};
	std::array<float, 3> heading{};
};

/// Puts a way into a row, its places turned by an angle about +Y, rad.
void put_way(const Way &p_way, float p_turn, Features &r_row);
/// The rows of all frames of a clip.
std::vector<Features> features_of(const Clip &p_clip);

} // namespace matching
