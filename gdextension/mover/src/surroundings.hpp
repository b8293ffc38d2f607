// SPDX-License-Identifier: MIT
#pragma once

#include <quaternion.hpp>

#include <array>
#include <cstdint>

/// A person without a suit who walks: an upright cylinder in the physics world. Godot's frame, Y up; m, s, rad.
namespace mover {

using kinematics::Quat;
using kinematics::Vec3;

/// How high somebody is, each with a cylinder of its own.
enum class Stance : std::uint32_t {
	STAND,
	CROUCH,
	PRONE
};
constexpr int STANCES = 3;
/// Height of each stance's cylinder, and the radius of all, m.
constexpr std::array<float, STANCES> HEIGHTS{ 1.8f, 1.2f, 0.6f };
constexpr float RADIUS = 0.3f;

/// What a cylinder meets.
struct Contact {
	/// Of the surface, towards the cylinder, length 1.
	Vec3 normal;
	/// Number of the moving body that it belongs to; 0: it never moves.
	std::uint32_t carrier = 0;
	bool is_ladder = false;
};

/// How far a cylinder gets.
struct Sweep {
	bool is_stopped = false;
	Vec3 travel;
	Vec3 left;
	std::array<Contact, 4> contacts;
	int count = 0;
};

/// Where a moving body is.
struct Frame {
	Vec3 origin;
	Quat turn;
};

/// The world around a walker, as it is in this tick: it gives the same answers to the same questions on the server,
/// where physics runs, and on a client, where it does not.
class Surroundings {
public:
	virtual ~Surroundings() = default;
	/// Moves the cylinder of a stance, whose foot's middle is at p_from, until something stops it.
	virtual void sweep(Stance p_stance, const Vec3 &p_from, const Vec3 &p_motion, Sweep &r_sweep) const = 0;
	/// Where a moving body is now. Returns false where there is none of that number any more.
	virtual bool find_frame(std::uint32_t p_carrier, Frame &r_frame) const = 0;
};

} // namespace mover
