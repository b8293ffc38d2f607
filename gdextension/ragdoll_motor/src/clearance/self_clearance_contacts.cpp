// SPDX-License-Identifier: MIT
// How SelfClearance finds contacts and pushes limbs apart.
#include "clearance/self_clearance.hpp"

#include <algorithm>

namespace ragdoll {

namespace {

// From the sweeps that self_clearance.cpp tells of.
constexpr float DONE = 5e-5f; // Depth that is left, m.
// Of a shift so much is given up, which contacts then have to renew: by the motion's own way, so that who holds still
// is not moved, and by no more than a speed, m/s.
constexpr float EASE_SHARE = 0.5f;
constexpr float EASE_SPEED = 0.2f;
// How fast it goes where the motion itself is clear, but not the way there, s.
constexpr float FADE_S = 0.05f;
constexpr float STRUGGLE = 0.005f; // Depth that is left, m.
constexpr float FAR = 0.03f; // Of shifts that may be on the wrong side of the body, m.
constexpr float MIN_LEVER = 0.1f; // Square of a lever below which a push would turn a limb too far.

} // namespace

bool SelfClearance::find_near(const Pose &p_pose, const std::vector<ClearancePair> &p_pairs, float p_margin) {
	_near.clear();
	bool meets = false;
	for (Chain &chain : _chains) {
		chain.is_free = true;
		chain.is_fading = false;
		chain.room = 1.0f;
		chain.looked = chain.shift;
		chain.moved = 0.0f;
	}
	for (const ClearancePair &pair : p_pairs) {
		const ClearancePart &mover = _body.parts[std::size_t(pair.mover)];
		const ClearancePart &other = _body.parts[std::size_t(pair.other)];
		const float margin = p_margin + _chains[std::size_t(mover.chain)].length +
				(other.chain >= 0 ? _chains[std::size_t(other.chain)].length : 0.0f);
		const float most = pair.reach + margin;
		const Vec3 apart = mover.solid.centre - other.solid.centre;
		if (apart.dot(apart) > most * most) {
			continue;
		}
		turn_axes(p_pose, pair.mover);
		turn_axes(p_pose, pair.other);
		const Vec3 middle = _places[std::size_t(pair.mover)].axis.at(0.5f);
		const Vec3 centre = _places[std::size_t(pair.other)].axis.at(0.5f);
		if (other.solid.find_distance(middle, centre) > mover.solid.reach + margin) {
			continue;
		}
		const Contact contact = meet(pair);
		meets |= contact.depth > DONE;
		if (contact.depth > -margin) {
			look(pair, contact);
			_near.push_back({ &pair, contact.depth });
		}
	}
	return meets;
}

void SelfClearance::look(const ClearancePair &p_pair, const Contact &p_contact) {
	Chain &chain = chain_of(p_pair.mover);
	Chain *second = p_pair.is_shared ? &chain_of(p_pair.other) : nullptr;
	const float room = -p_contact.depth * (second != nullptr ? 0.5f : 1.0f);
	chain.room = std::min(chain.room, room);
	bool is_far = chain.length > FAR;
	if (second != nullptr) {
		second->room = std::min(second->room, room);
		is_far |= second->length > FAR;
	}
	if (is_far && (chain.is_free || (second != nullptr && second->is_free)) && meet_unmoved(p_pair).depth > 0.0f) {
		chain.is_free = false;
		if (second != nullptr) {
			second->is_free = false;
		}
	}
}

void SelfClearance::let_go(bool p_legs, float p_delta_s) {
	for (std::size_t i = 0; i < _chains.size(); i++) {
		Chain &chain = _chains[i];
		if (_body.chains[i].is_leg != p_legs || chain.length == 0.0f) {
			continue;
		}
		// On the wrong side of the body: the way back is through it.
		chain.is_fading = chain.is_free && chain.length > FAR;
		// Where contacts contradict each other, giving up a shift would feed their struggle.
		const float calm = std::max(1.0f - _kept[i].left / STRUGGLE, 0.0f);
		const float most = std::min(EASE_SHARE * chain.way, EASE_SPEED * p_delta_s) * calm;
		const float eased =
				chain.is_fading ? std::exp(-p_delta_s / FADE_S) : 1.0f - most / std::max(chain.length, most);
		const float left = std::min(eased, 1.0f - chain.room / chain.length);
		chain.shift = left * chain.length > DONE ? chain.shift.scaled(left) : ChainShift();
		if (!chain.shift.is_none()) {
			keep_lengths(chain.upper, chain.lower, chain.shift);
		}
		move_chain(i);
	}
}

bool SelfClearance::push_apart(const Near &p_near) {
	const ClearancePair &p_pair = *p_near.pair;
	const float moved = chain_of(p_pair.mover).moved + (p_pair.is_shared ? chain_of(p_pair.other).moved : 0.0f);
	if (p_near.depth + moved < 0.0f) {
		return false;
	}
	if (!p_pair.is_shared && chain_of(p_pair.mover).is_fading) {
		return false;
	}
	const Contact nearest = meet(p_pair);
	if (nearest.depth < DONE) {
		return false;
	}
	chain_of(p_pair.mover).left = std::max(chain_of(p_pair.mover).left, nearest.depth);
	// Of limbs that lie along each other no single point is the nearest, or now one and now another: the ends come
	// first, always.
	bool is_end_pushed = false;
	for (const float end : { 0.0f, 1.0f }) {
		const Contact contact = meet_end(p_pair, end);
		if (contact.depth > DONE) {
			push(p_pair, contact);
			is_end_pushed = true;
		}
	}
	const Contact left = is_end_pushed ? meet(p_pair) : nearest;
	if (left.depth > DONE) {
		push(p_pair, left);
	}
	return true;
}

void SelfClearance::push(const ClearancePair &p_pair, const Contact &p_contact) {
	const ClearancePart &mover = _body.parts[std::size_t(p_pair.mover)];
	const ClearancePart &other = _body.parts[std::size_t(p_pair.other)];
	const Vec3 &normal = p_contact.approach.normal;
	const Lever own = find_lever(mover, p_contact.approach.share, normal);
	Lever others;
	if (p_pair.is_shared) {
		others = find_lever(other, p_contact.approach.other_share, normal);
	}
	const float weight = own.square() + others.square();
	if (weight < MIN_LEVER) {
		return;
	}
	const float size = p_contact.depth / weight;
	const auto move = [&](const ClearancePart &p_part, const Lever &p_lever, float p_size) {
		ChainShift &shift = _chains[std::size_t(p_part.chain)].shift;
		shift.middle = shift.middle + p_lever.upper * p_size;
		shift.end = shift.end + (p_lever.upper + p_lever.lower) * p_size;
		move_chain(std::size_t(p_part.chain));
	};
	move(mover, own, size);
	if (p_pair.is_shared) {
		move(other, others, -size);
	}
}

void SelfClearance::turn_axes(const Pose &p_pose, int p_part) {
	Place &place = _places[std::size_t(p_part)];
	if (place.step != _step) {
		LimbSolid &solid = _body.parts[std::size_t(p_part)].solid;
		solid.turn_axes(p_pose.orientations[std::size_t(solid.limb)]);
		place.step = _step;
		find_axis(std::size_t(p_part));
	}
}

void SelfClearance::find_axis(std::size_t p_part) {
	const ClearancePart &part = _body.parts[p_part];
	SolidAxis axis = part.solid.get_axis();
	if (part.chain >= 0) {
		const ChainShift &shift = _chains[std::size_t(part.chain)].shift;
		Vec3 low = shift.middle * part.low.middle + shift.end * part.low.end;
		Vec3 high = shift.middle * part.high.middle + shift.end * part.high.end;
		const TwoBoneChain &limbs = _body.chains[std::size_t(part.chain)];
		if (part.solid.limb != limbs.end) {
			const Bias &bias = _chains[std::size_t(part.chain)].biases[part.solid.limb == limbs.upper ? 0 : 1];
			low = low + bias.low;
			high = high + bias.high;
		}
		axis = { axis.from + low, axis.way + high - low };
	}
	_places[p_part].axis = axis;
}

void SelfClearance::move_chain(std::size_t p_chain) {
	Chain &chain = _chains[p_chain];
	chain.upper_way = (chain.upper + chain.shift.middle) * chain.upper_rate;
	chain.lower_way = (chain.lower + chain.shift.end - chain.shift.middle) * chain.lower_rate;
	chain.moved = ChainShift{ chain.shift.middle - chain.looked.middle, chain.shift.end - chain.looked.end }.length();
	for (const int part : _body.chain_parts[p_chain]) {
		if (_places[std::size_t(part)].step == _step) {
			find_axis(std::size_t(part));
		}
	}
}

AxisFreedom SelfClearance::get_freedom(const ClearancePair &p_pair) const {
	const ClearancePart &part = _body.parts[std::size_t(p_pair.mover)];
	const Chain &chain = _chains[std::size_t(part.chain)];
	return { chain.upper_way, chain.lower_way, part.low.end, part.high.end };
}

SelfClearance::Lever SelfClearance::find_lever(const ClearancePart &p_part, float p_share, const Vec3 &p_normal) const {
	const Chain &chain = _chains[std::size_t(p_part.chain)];
	const ChainShares shares = p_part.at(p_share);
	Lever lever;
	lever.upper = (p_normal - chain.upper_way * chain.upper_way.dot(p_normal)) * (shares.middle + shares.end);
	lever.lower = (p_normal - chain.lower_way * chain.lower_way.dot(p_normal)) * shares.end;
	return lever;
}

SelfClearance::Contact SelfClearance::weigh(const ClearancePair &p_pair, const Approach &p_approach) const {
	const LimbSolid &solid = _body.parts[std::size_t(p_pair.mover)].solid;
	const float allowed = std::max(overlap, p_pair.rest_overlap);
	return { p_approach, solid.find_thickness(p_approach.normal) - p_approach.distance - allowed };
}

SelfClearance::Contact SelfClearance::meet(const ClearancePair &p_pair) const {
	const SolidAxis &mover = _places[std::size_t(p_pair.mover)].axis;
	const SolidAxis &other = _places[std::size_t(p_pair.other)].axis;
	const LimbSolid &solid = _body.parts[std::size_t(p_pair.other)].solid;
	return weigh(p_pair, approach_axis(mover, get_freedom(p_pair), solid, other));
}

SelfClearance::Contact SelfClearance::meet_unmoved(const ClearancePair &p_pair) const {
	const LimbSolid &mover = _body.parts[std::size_t(p_pair.mover)].solid;
	const LimbSolid &other = _body.parts[std::size_t(p_pair.other)].solid;
	return weigh(p_pair, approach_axis(mover.get_axis(), get_freedom(p_pair), other, other.get_axis()));
}

SelfClearance::Contact SelfClearance::meet_end(const ClearancePair &p_pair, float p_end) const {
	const SolidAxis &mover = _places[std::size_t(p_pair.mover)].axis;
	const SolidAxis &other = _places[std::size_t(p_pair.other)].axis;
	const LimbSolid &solid = _body.parts[std::size_t(p_pair.other)].solid;
	Contact contact = weigh(p_pair, approach_point(mover.at(p_end), solid, other));
	contact.approach.share = p_end;
	return contact;
}

} // namespace ragdoll
