// SPDX-License-Identifier: MIT
#pragma once

#include "pose.hpp"

#include <string>
#include <vector>

namespace matching {

/// Frames a second of a set.
constexpr float RATE = 60.0f;

/// How somebody holds himself.
enum Stance {
	STAND,
	CROUCH,
	PRONE,
	LADDER,
	VAULT,
	STANCES
};

/// A moment of a clip, in heights of the hips and seconds, in the frame of the person's way: its origin is on the
/// ground where the hips are on average, its +Z is where he faces on average.
struct ClipFrame {
	Pose pose;
	float velocity_x = 0.0f; ///< Of the frame, in itself.
	float velocity_z = 0.0f;
	float turn_rate = 0.0f; ///< rad/s.
	uint8_t contacts = 0; ///< Which feet's balls stand: 1 left, 2 right.
};

/// A piece of motion.
struct Clip {
	std::string name;
	Stance stance = STAND;
	float ankle_height = 0.09f; ///< Of a foot that stands, in heights of the hips.
	float foot = 0.15f; ///< From ankle to ball, in heights of the hips.
	std::vector<ClipFrame> frames;
};

/// Turns the feet about their length so that those that stand are level: the rest pose of many recordings has the legs
/// apart, and their feet stand on an edge in any other body.
void level_feet(Clip &r_clip);
/// A clip as seen in a mirror.
Clip mirror(const Clip &p_clip);
/// A clip backwards in time: who walks forward walks backwards.
Clip reverse(const Clip &p_clip);

} // namespace matching
