// SPDX-License-Identifier: MIT
#pragma once

#include "base/archive.hpp"
#include "body/rig.hpp"
#include "joint/actuation.hpp"
#include "world/obstacles.hpp"

#include <cstdint>
#include <vector>

namespace ragdoll {

/// Brings limbs back whose axis runs into something firm: a blow, or the weight of the body, has pressed them into it.
///
/// The engine pushes what is in a thin thing out by the shortest way, which may be the far side. A limb is turned
/// about its joint until it lies along the surface, with all that hangs on it. Looked at is one limb a step, in turn.
class SurfaceGuard {
public:
	/// A limb's axis is looked at from its joint to so many times its middle.
	static constexpr float LENGTH = 1.8f;
	/// How high over the surface the limb's end is laid, m: less than limbs are thick, so that they lie on it.
	static constexpr float HEIGHT = 0.03f;
	/// How deep its end is in it at least, m: what is less the engine's contacts push out, and who leans a hand on
	/// something would be jolted.
	static constexpr float DEEP = 0.04f;

	explicit SurfaceGuard(const Rig &p_rig);

	/// Begins a step. Returns whether a limb has been turned.
	/// @param p_table limbs that are put somewhere go through everything, as is wanted
	bool advance(const Rig &p_rig, const ActuationTable &p_table, const Obstacles *p_obstacles, RigState &r_state);

	void save(ArchiveWriter &p_archive) const { p_archive.put(_limb); }
	bool restore(ArchiveReader &p_archive) { return p_archive.get(_limb) && _limb < _count; }

private:
	void turn(const Rig &p_rig, std::size_t p_limb, const Quat &p_turn, RigState &r_state);

	std::uint32_t _count;
	std::uint32_t _limb = 0; // That was looked at last.
	std::vector<std::uint8_t> _moves; // Whether a limb hangs on the one that is turned.
};

} // namespace ragdoll
