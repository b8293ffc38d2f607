// SPDX-License-Identifier: MIT
#include "root/carrier.hpp"

#include <algorithm>
#include <cmath>

namespace ragdoll {

namespace {

constexpr float TOUCHES = 0.1f; // What is so near to the ground (m) stands on it: a soft root may hover.
constexpr float LESS = 0.04f; // A limb that is higher than the other one by this (m) carries nothing.
constexpr float FURTHEST = 0.5f; // What moves further than this in a step (m) was put elsewhere.
constexpr float LOOK_BELOW_AGAIN_S = 0.05f; // What is below does not move: that is known for so long,
constexpr float SAME_GROUND = 0.05f; // and for so far, m.
constexpr float FLOAT_S = 0.5f; // How fast a body in the air is carried on less and less, s.

/// The part of a rotation about the vertical.
Quat heading_of(const Quat &p_turn) {
	// With w above 0, so that the angle is the short way round.
	const float size = std::sqrt(p_turn.y * p_turn.y + p_turn.w * p_turn.w);
	const float length = p_turn.w < 0.0f ? -size : size;
	return size > 1e-6f ? Quat{ 0.0f, p_turn.y / length, 0.0f, p_turn.w / length } : Quat();
}

/// A ride that takes a point somewhere and turns about it.
Ride ride_about(const Quat &p_turn, const Vec3 &p_from, const Vec3 &p_to) {
	return { p_turn, p_to - p_turn.rotate(p_from), true };
}

// Value by value: what lies between them in memory is of no use in a replay.
void put(ArchiveWriter &p_archive, const Ride &p_ride) {
	p_archive.put(p_ride.turn);
	p_archive.put(p_ride.shift);
	p_archive.put(p_ride.moves);
}

bool get(ArchiveReader &p_archive, Ride &r_ride) {
	return p_archive.get(r_ride.turn) && p_archive.get(r_ride.shift) && p_archive.get(r_ride.moves) &&
			r_ride.turn.is_finite() && r_ride.shift.is_finite();
}

void put(ArchiveWriter &p_archive, const Footing &p_footing) {
	p_archive.put(p_footing.height);
	p_archive.put(p_footing.is_loose);
	p_archive.put(p_footing.velocity);
	p_archive.put(p_footing.turning);
	p_archive.put(p_footing.pivot);
	p_archive.put(p_footing.body);
	p_archive.put(p_footing.orientation);
	p_archive.put(p_footing.origin);
}

bool get(ArchiveReader &p_archive, Footing &r_footing) {
	return p_archive.get(r_footing.height) && p_archive.get(r_footing.is_loose) && p_archive.get(r_footing.velocity) &&
			p_archive.get(r_footing.turning) && p_archive.get(r_footing.pivot) && p_archive.get(r_footing.body) &&
			p_archive.get(r_footing.orientation) && p_archive.get(r_footing.origin);
}

} // namespace

void Carrier::find_supports(const Rig &p_rig, const std::vector<ContactPoint> &p_contacts, const RigState &p_state) {
	std::array<Support, SUPPORTS> lowest;
	std::array<float, SUPPORTS> heights = { 1e9f, 1e9f };
	for (const ContactPoint &contact : p_contacts) {
		const std::size_t limb = std::size_t(contact.limb);
		const Vec3 at = p_rig.joint_of(p_state, limb) + p_state.orientations[limb].rotate(contact.local);
		const float height = at.y - contact.radius;
		const bool is_known = lowest[0].limb == contact.limb;
		const std::size_t slot = height < heights[0] ? 0 : 1;
		if (height >= heights[slot] || (slot == 1 && is_known)) {
			continue;
		}
		if (slot == 0 && !is_known) {
			lowest[1] = lowest[0];
			heights[1] = heights[0];
		}
		lowest[slot].limb = contact.limb;
		lowest[slot].at = { at.x, height, at.z };
		heights[slot] = height;
	}
	for (Support &support : lowest) {
		const Vec3 at = support.at;
		for (const Support &before : _supports) {
			support = before.limb == support.limb ? before : support;
		}
		support.at = at;
	}
	_supports = lowest;
}

void Carrier::look(const Ground &p_ground, float p_delta_s, Support &r_support) {
	r_support.age_s += p_delta_s;
	const bool is_new = std::isnan(r_support.footing.height) || r_support.age_s > LOOK_BELOW_AGAIN_S;
	const float moved = level(r_support.at - r_support.looked).length();
	if (is_new || r_support.footing.body != 0 || moved > SAME_GROUND) {
		r_support.footing = p_ground.find(r_support.at, TOUCHES);
		r_support.looked = r_support.at;
		r_support.age_s = 0.0f;
	}
	r_support.height = r_support.at.y - r_support.footing.height;
}

Ride Carrier::find_ride(const Support &p_support) const {
	const Footing &now = p_support.footing;
	if (now.body == 0) {
		return Ride();
	}
	for (const Known &before : _known) {
		if (before.body == now.body) {
			const Quat turn = now.orientation * before.orientation.inverse();
			const Vec3 to = turn.rotate(p_support.at - before.origin) + now.origin;
			const bool is_put = (to - p_support.at).length() > FURTHEST;
			return is_put ? Ride() : ride_about(heading_of(turn), p_support.at, to);
		}
	}
	return Ride();
}

void Carrier::remember() {
	std::array<Known, SUPPORTS> known;
	for (std::size_t i = 0; i < SUPPORTS; i++) {
		// Only what is below in every step: where it was long ago tells nothing.
		const Footing &footing = _supports[i].footing;
		known[i] = { footing.body, footing.orientation, footing.origin };
	}
	_known = known;
}

void Carrier::advance(const Rig &p_rig, const std::vector<ContactPoint> &p_contacts, const RigState &p_state,
		const Ground &p_ground, float p_delta_s) {
	find_supports(p_rig, p_contacts, p_state);
	float lowest = 1e9f;
	for (Support &support : _supports) {
		if (support.limb >= 0) {
			look(p_ground, p_delta_s, support);
			lowest = std::isfinite(support.height) ? std::min(lowest, support.height) : lowest;
		}
	}
	Vec3 from;
	Vec3 to;
	Vec3 spiral;
	float heading = 0.0f;
	float sum = 0.0f;
	for (const Support &support : _supports) {
		const bool is_below = support.limb >= 0 && std::isfinite(support.height);
		const float weight = is_below ? std::max(1.0f - (support.height - lowest) / LESS, 0.0f) : 0.0f;
		const Ride ride = weight > 0.0f ? find_ride(support) : Ride();
		from = from + support.at * weight;
		to = to + ride.apply(support.at) * weight;
		const float turned = 2.0f * std::atan2(ride.turn.y, ride.turn.w);
		const Vec3 arm = level(support.at - support.footing.pivot);
		const Vec3 tangent = Vec3{ 0.0f, turned, 0.0f }.cross(arm);
		spiral = spiral + (turned != 0.0f ? arm + tangent - ride.turn.rotate(arm) : Vec3()) * weight;
		heading += turned * weight;
		sum += weight;
	}
	remember();
	// Over something else than before, in the air: what carried the person fades.
	const bool is_carried = sum > 0.0f && (lowest < TOUCHES || (to - from).length() > 0.0f);
	const bool touches = is_carried && lowest < TOUCHES;
	_spiral = touches ? spiral * (1.0f / sum) : Vec3();
	if (is_carried) {
		const Quat turn = exp({ 0.0f, heading / sum, 0.0f });
		_past = ride_about(turn, from * (1.0f / sum), to * (1.0f / sum));
		_past.moves = (to - from).length() > 0.0f || heading != 0.0f;
		_ahead = _past;
		return;
	}
	const Vec3 at = p_state.root;
	const Vec3 moved = (_ahead.apply(at) - at) * std::exp(-p_delta_s / FLOAT_S);
	_ahead = { Quat(), moved, moved.length() > 1e-5f };
	_past = _ahead;
}

void Carrier::save(ArchiveWriter &p_archive) const {
	for (const Support &support : _supports) {
		p_archive.put(support.limb);
		p_archive.put(support.looked);
		p_archive.put(support.at);
		p_archive.put(support.age_s);
		put(p_archive, support.footing);
		p_archive.put(support.height);
	}
	for (const Known &known : _known) {
		p_archive.put(known.body);
		p_archive.put(known.orientation);
		p_archive.put(known.origin);
	}
	put(p_archive, _past);
	put(p_archive, _ahead);
	p_archive.put(_spiral);
}

bool Carrier::restore(ArchiveReader &p_archive) {
	for (Support &support : _supports) {
		if (!p_archive.get(support.limb) || !p_archive.get(support.looked) || !p_archive.get(support.at) ||
				!p_archive.get(support.age_s) || !get(p_archive, support.footing) || !p_archive.get(support.height)) {
			return false;
		}
	}
	for (Known &known : _known) {
		if (!p_archive.get(known.body) || !p_archive.get(known.orientation) || !p_archive.get(known.origin)) {
			return false;
		}
	}
	return get(p_archive, _past) && get(p_archive, _ahead) && p_archive.get(_spiral) && _spiral.is_finite();
}

} // namespace ragdoll
