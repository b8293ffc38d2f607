// SPDX-License-Identifier: MIT
#pragma once

#include "surroundings.hpp"

#include <array>
#include <cstdint>

namespace mover {

/// What somebody is doing.
enum class Mode : std::uint32_t {
	/// On feet, or in the air.
	WALK,
	/// Gets onto something, or over it.
	VAULT,
	/// Hangs on a ladder.
	LADDER,
	/// Physics has the body: it lies, or gets up. The walker only follows.
	BODY,
};
constexpr int MODES = 4;

/// What a user wishes in a tick.
struct Wish {
	/// Where to, and how fast, m/s in the world.
	float x = 0.0f;
	float z = 0.0f;
	/// Where to face: the angle about +Y, rad, 0 towards +Z.
	float heading = 0.0f;
	bool jumps = false;
	Stance stance = Stance::STAND;
};

/// All that the next tick depends on. As numbers of 32 bits each it goes over the wire and is compared, to the bit.
struct State {
	/// Where the feet are, m.
	Vec3 position;
	/// Relative to the carrier, m/s.
	Vec3 velocity;
	float heading = 0.0f;
	std::uint32_t is_grounded = 0;
	Stance stance = Stance::STAND;
	Mode mode = Mode::WALK;
	/// Whether the wish to jump lasts since an earlier tick: it counts once.
	std::uint32_t has_jumped = 0;
	/// How far the body is still below the feet's ground, as on a step that it has just got onto; above it where this
	/// is below 0, m. Pictures and bodies rise by it, who climbs is slowed down by it.
	float lift = 0.0f;
	/// Of a vault: how long it lasts already, s, and from where to where it goes, m.
	float time = 0.0f;
	Vec3 from;
	Vec3 to;
	/// The way out of the ladder, length 1.
	Vec3 normal;
	/// The moving body below the feet, or 0, and where they and the heading are in its frame.
	std::uint32_t carrier = 0;
	Vec3 local;
	float local_heading = 0.0f;
	/// Something holds the body back: level, towards the body; its length, 0 to 1, is the share of a wish away from
	/// there that is not followed.
	Vec3 hold;

	/// How many numbers it is.
	static constexpr std::size_t WORDS = 29;
	using Words = std::array<std::uint32_t, WORDS>;
	Words words() const;
	/// Takes over numbers; returns false, and stays as it is, where they can be nobody's.
	bool read(const Words &p_words);
	/// A number of 16 bits that differs, nearly always, where anything differs.
	std::uint16_t check() const;
};

} // namespace mover
