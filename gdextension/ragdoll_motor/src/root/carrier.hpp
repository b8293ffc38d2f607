// SPDX-License-Identifier: MIT
#pragma once

#include "base/archive.hpp"
#include "body/contact_point.hpp"
#include "body/rig.hpp"
#include "world/ground.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace ragdoll {

/// How far something is moved: a point p of the world goes to turn p + shift (m). People stay upright: the
/// turn is about the vertical.
struct Ride {
	Quat turn;
	Vec3 shift; ///< m
	bool moves = false;

	Vec3 apply(const Vec3 &p_at) const { return turn.rotate(p_at) + shift; }
};

/// Finds what carries somebody - a platform, a lift, a vehicle's deck - and how it moves.
///
/// Whatever the lowest limbs touch carries the person; the nearer to the ground a limb is, the more it counts. The body
/// that is touched is followed by its position, not by its velocity, so that nobody drifts on it. In the air one goes
/// on with it while it is still below, and slows down otherwise.
class Carrier {
public:
	/// Begins a step: looks at what is below.
	void advance(const Rig &p_rig, const std::vector<ContactPoint> &p_contacts, const RigState &p_state,
			const Ground &p_ground, float p_delta_s);
	/// Nothing carries the person.
	void clear() { *this = Carrier(); }

	/// How far it has moved since the last step, and will in this one if it goes on.
	const Ride &get_past() const { return _past; }
	const Ride &get_ahead() const { return _ahead; }
	/// How far the engine has put the person off the arc on which the ground turned in the last step, m: it carries
	/// along the tangent. Friction does not bring that back: in half a minute at 30 deg/s it comes to 7 cm for each
	/// metre from the pivot.
	const Vec3 &get_spiral() const { return _spiral; }

	void save(ArchiveWriter &p_archive) const;
	bool restore(ArchiveReader &p_archive);

private:
	static constexpr std::size_t SUPPORTS = 2;

	/// A body, where it was in the last step.
	struct Known {
		std::uint64_t body = 0;
		Quat orientation;
		Vec3 origin; // m
	};
	/// What is under one of the lowest limbs.
	struct Support {
		int limb = -1;
		Vec3 looked; // Where, m.
		Vec3 at; // The lowest point of the limb, m.
		float age_s = 0.0f;
		Footing footing;
		float height = 0.0f; // Over it, m.
	};

	void find_supports(const Rig &p_rig, const std::vector<ContactPoint> &p_contacts, const RigState &p_state);
	void look(const Ground &p_ground, float p_delta_s, Support &r_support);
	Ride find_ride(const Support &p_support) const;
	void remember();

	std::array<Support, SUPPORTS> _supports;
	std::array<Known, SUPPORTS> _known;
	Ride _past;
	Ride _ahead;
	Vec3 _spiral; // m
};

} // namespace ragdoll
