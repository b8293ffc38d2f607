// SPDX-License-Identifier: MIT
#include "clearance/self_clearance.hpp"

#include <algorithm>

namespace ragdoll {

namespace {

// Passes over all contacts: from how the step before ended, and from nothing.
constexpr int PASSES = 4;
constexpr int FIRST_PASSES = 40;
constexpr float DONE = 2e-4f; // Depth that is left, m.
// How fast a shift is given up that contacts then have to renew, which brings it to the shortest, s.
constexpr float EASE_S = 0.2f;
// How fast it goes where the motion itself is clear, but not the way there, s.
constexpr float FADE_S = 0.05f;
constexpr float FAR = 0.03f; // Longer shifts than this (m) have no place where the motion is clear.
constexpr float FASTEST = 4.0f; // Of a shift, m/s.
constexpr float LEAST_LEVER = 0.1f; // Square of a lever below which a push would turn a limb too far.
constexpr float JOINED = 0.03f; // Where another limb is within this of the place this far outside (m), a face is closed.

} // namespace

SelfClearance::SelfClearance(const Rig &p_rig) : _limb_count(p_rig.size()) {
	for (const TwoBoneChain &limbs : find_chains(p_rig)) {
		_chains.emplace_back();
		_chains.back().limbs = limbs;
	}
	make_parts(p_rig);
	if (_parts.empty()) {
		_chains.clear();
		return;
	}
	Pose rest;
	for (std::size_t i = 0; i < p_rig.size(); i++) {
		rest.orientations.push_back(p_rig[i].rest);
	}
	place(p_rig, rest);
	for (Part &part : _parts) {
		part.solid.turn_axes(rest.orientations[std::size_t(part.solid.limb)]);
	}
	close_faces(p_rig);
	make_pairs(p_rig);
}

void SelfClearance::make_parts(const Rig &p_rig) {
	for (std::size_t i = 0; i < p_rig.size(); i++) {
		if (p_rig[i].shape.type == LimbShape::Type::NONE) {
			continue;
		}
		Part part;
		part.solid = LimbSolid(p_rig, i);
		for (std::size_t c = 0; c < _chains.size(); c++) {
			const TwoBoneChain &limbs = _chains[c].limbs;
			const bool is_end = int(i) == limbs.end;
			if (!is_end && int(i) != limbs.upper && int(i) != limbs.lower) {
				continue;
			}
			part.chain = int(c);
			part.low = part.high = { 0.0f, 1.0f }; // An end is not turned.
			if (!is_end) {
				const Vec3 along = p_rig[std::size_t(int(i) == limbs.upper ? limbs.lower : limbs.end)].anchor;
				const Vec3 half = part.solid.get_local_half();
				const float square = along.dot(along);
				const float low = std::clamp((p_rig[i].centre - half).dot(along) / square, 0.0f, 1.0f);
				const float high = std::clamp((p_rig[i].centre + half).dot(along) / square, 0.0f, 1.0f);
				const bool is_upper = int(i) == limbs.upper;
				part.low = is_upper ? Shares{ low, 0.0f } : Shares{ 1.0f - low, low };
				part.high = is_upper ? Shares{ high, 0.0f } : Shares{ 1.0f - high, high };
			}
		}
		_parts.push_back(part);
	}
}

void SelfClearance::close_faces(const Rig & /*p_rig*/) {
	for (Part &part : _parts) {
		for (int face = 0; face < 6 && part.solid.is_box && part.chain < 0; face++) {
			const int axis = face / 2;
			const float half = axis == 0 ? part.solid.half.x : (axis == 1 ? part.solid.half.y : part.solid.half.z);
			const float out = half + JOINED;
			const Vec3 middle = part.solid.centre + part.solid.axes[axis] * (face % 2 == 0 ? -out : out);
			for (const Part &other : _parts) {
				const bool is_arm = other.chain >= 0 && !_chains[std::size_t(other.chain)].limbs.is_leg;
				part.solid.is_closed[face] |= &other != &part && !is_arm &&
						approach_point(middle, other.solid, axis_of(other, false)).distance < JOINED;
			}
		}
	}
}

bool SelfClearance::can_meet(const Rig &p_rig, const Part &p_mover, const Part &p_other) const {
	if (p_mover.chain < 0 || p_mover.chain == p_other.chain) {
		return false;
	}
	const TwoBoneChain &limbs = _chains[std::size_t(p_mover.chain)].limbs;
	const bool is_upper = p_mover.solid.limb == limbs.upper;
	const bool is_other_leg = p_other.chain >= 0 && _chains[std::size_t(p_other.chain)].limbs.is_leg;
	if (limbs.is_leg) {
		return is_other_leg && p_mover.solid.limb != limbs.end &&
				p_other.solid.limb != _chains[std::size_t(p_other.chain)].limbs.end;
	}
	// What hangs on the end, or on which the chain hangs, is moved with it, or is joined to it.
	for (int above = p_other.solid.limb; above >= 0; above = p_rig[std::size_t(above)].parent) {
		if (above == limbs.end) {
			return false;
		}
	}
	return !is_upper;
}

void SelfClearance::make_pairs(const Rig &p_rig) {
	for (std::size_t i = 0; i < _parts.size(); i++) {
		for (std::size_t j = 0; j < _parts.size(); j++) {
			Pair pair;
			pair.mover = int(i);
			pair.other = int(j);
			if (!can_meet(p_rig, _parts[i], _parts[j])) {
				continue;
			}
			const bool is_leg = _chains[std::size_t(_parts[i].chain)].limbs.is_leg;
			pair.is_shared = _parts[j].chain >= 0 && _chains[std::size_t(_parts[j].chain)].limbs.is_leg == is_leg;
			// Each pair once: the pill is the mover; of two boxes, or two pills, the first.
			const bool is_twice = pair.is_shared && can_meet(p_rig, _parts[j], _parts[i]);
			const bool is_same = _parts[i].solid.is_box == _parts[j].solid.is_box;
			if (is_twice && (is_same ? j < i : _parts[i].solid.is_box)) {
				continue;
			}
			pair.rest_overlap = std::max(meet(pair, false).depth + overlap, 0.0f);
			(is_leg ? _leg_pairs : _arm_pairs).push_back(pair);
		}
	}
	_near.reserve(std::max(_leg_pairs.size(), _arm_pairs.size()));
}

void SelfClearance::advance(const Rig &p_rig, bool p_begins, float p_delta_s, Pose &r_now, Pose &r_next) {
	if (_chains.empty()) {
		return;
	}
	if (p_begins || !_has_begun) {
		solve(p_rig, true, p_delta_s, r_now);
	}
	_has_begun = true;
	for (Chain &chain : _chains) {
		const TwoBoneChain &limbs = chain.limbs;
		chain.turned[0] = r_now.orientations[std::size_t(limbs.upper)];
		chain.turned[1] = r_now.orientations[std::size_t(limbs.lower)];
		if (!chain.kept.is_none()) {
			const int parent = p_rig[std::size_t(limbs.upper)].parent;
			turn_chain(p_rig, limbs, chain.kept.turned(r_now.orientations[std::size_t(parent)]), r_now);
		}
		chain.moved[0] = r_now.orientations[std::size_t(limbs.upper)];
		chain.moved[1] = r_now.orientations[std::size_t(limbs.lower)];
	}
	solve(p_rig, false, p_delta_s, r_next);
	turn(p_rig, r_next);
}

void SelfClearance::clear(const Rig &p_rig, Pose &r_pose) {
	_has_begun = false;
	if (!_chains.empty()) {
		solve(p_rig, true, 0.0f, r_pose);
		turn(p_rig, r_pose);
	}
}

void SelfClearance::place(const Rig &p_rig, const Pose &p_pose) {
	p_rig.joint_positions(p_pose, _joints);
	for (Part &part : _parts) {
		const std::size_t limb = std::size_t(part.solid.limb);
		part.solid.place(p_pose.orientations[limb], _joints[limb]);
	}
	_placed++;
}

void SelfClearance::solve(const Rig &p_rig, bool p_begins, float p_delta_s, Pose &r_pose) {
	place(p_rig, r_pose);
	for (Chain &chain : _chains) {
		const int parent = p_rig[std::size_t(chain.limbs.upper)].parent;
		const Vec3 &middle = _joints[std::size_t(chain.limbs.lower)];
		chain.upper = middle - _joints[std::size_t(chain.limbs.upper)];
		chain.lower = _joints[std::size_t(chain.limbs.end)] - middle;
		chain.shift = {};
		if (!p_begins && !chain.kept.is_none()) {
			chain.shift = chain.kept.turned(r_pose.orientations[std::size_t(parent)]);
		}
		chain.before = chain.shift;
	}
	solve_pairs(r_pose, _leg_pairs, p_begins, p_delta_s);
	solve_pairs(r_pose, _arm_pairs, p_begins, p_delta_s);
	for (Chain &chain : _chains) {
		const int parent = p_rig[std::size_t(chain.limbs.upper)].parent;
		if (!p_begins && !chain.shift.is_none()) {
			const float most = FASTEST * p_delta_s;
			chain.shift.middle = chain.before.middle + (chain.shift.middle - chain.before.middle).limited(most);
			chain.shift.end = chain.before.end + (chain.shift.end - chain.before.end).limited(most);
		}
		chain.kept = {};
		if (!chain.shift.is_none()) {
			chain.kept = chain.shift.turned(r_pose.orientations[std::size_t(parent)].inverse());
		}
	}
}

void SelfClearance::find_ways(Chain &r_chain) {
	const Vec3 upper = r_chain.upper + r_chain.shift.middle;
	const Vec3 lower = r_chain.lower + r_chain.shift.end - r_chain.shift.middle;
	r_chain.upper_way = upper * (1.0f / std::max(upper.length(), 1e-6f));
	r_chain.lower_way = lower * (1.0f / std::max(lower.length(), 1e-6f));
}

void SelfClearance::solve_pairs(
		const Pose &p_pose, const std::vector<Pair> &p_pairs, bool p_begins, float p_delta_s) {
	if (p_pairs.empty()) {
		return;
	}
	const bool is_leg = _chains[std::size_t(_parts[std::size_t(p_pairs[0].mover)].chain)].limbs.is_leg;
	for (Chain &chain : _chains) {
		find_ways(chain);
	}
	const bool meets = find_near(p_pose, p_pairs);
	let_go(is_leg, p_delta_s);
	if (!meets) {
		return;
	}
	for (int pass = 0; pass < (p_begins ? FIRST_PASSES : PASSES); pass++) {
		bool is_pushed = false;
		for (const Pair &pair : _near) {
			is_pushed |= push_apart(pair);
		}
		if (!is_pushed) {
			return;
		}
		for (Chain &chain : _chains) {
			if (chain.limbs.is_leg == is_leg && !chain.shift.is_none()) {
				keep_lengths(chain.upper, chain.lower, chain.shift);
				find_ways(chain);
			}
		}
	}
}

bool SelfClearance::find_near(const Pose &p_pose, const std::vector<Pair> &p_pairs) {
	_near.clear();
	for (Chain &chain : _chains) {
		chain.is_free = true;
		chain.is_fading = false;
		chain.room = 1.0f;
	}
	bool meets = false;
	for (const Pair &pair : p_pairs) {
		Part &mover = _parts[std::size_t(pair.mover)];
		Part &other = _parts[std::size_t(pair.other)];
		Chain &chain = _chains[std::size_t(mover.chain)];
		Chain *second = pair.is_shared ? &_chains[std::size_t(other.chain)] : nullptr;
		const float shift = chain.shift.length() + (other.chain >= 0 ? _chains[other.chain].shift.length() : 0.0f);
		const float most = mover.solid.reach + other.solid.reach + shift;
		const Vec3 apart = mover.solid.centre - other.solid.centre;
		if (apart.dot(apart) > most * most) {
			continue;
		}
		for (Part *part : { &mover, &other }) {
			if (part->placed != _placed) {
				part->solid.turn_axes(p_pose.orientations[std::size_t(part->solid.limb)]);
				part->placed = _placed;
			}
		}
		const float depth = meet(pair, false).depth;
		meets |= depth > 0.0f;
		if (depth > 0.0f) {
			chain.is_free = false;
			if (second != nullptr) {
				second->is_free = false;
			}
		}
		if (depth < -2.0f * shift - 0.1f) {
			continue; // Nothing that is pushed comes so far.
		}
		_near.push_back(pair);
		if (shift > 0.0f) {
			const float room = -meet(pair, true).depth * (second != nullptr ? 0.5f : 1.0f);
			chain.room = std::min(chain.room, room);
			if (second != nullptr) {
				second->room = std::min(second->room, room);
			}
		}
	}
	return meets;
}

void SelfClearance::let_go(bool p_legs, float p_delta_s) {
	for (Chain &chain : _chains) {
		if (chain.limbs.is_leg != p_legs || chain.shift.is_none()) {
			continue;
		}
		const float length = chain.shift.length();
		// On the wrong side of the body: the way back is through it.
		chain.is_fading = chain.is_free && length > FAR;
		const float eased = std::exp(-p_delta_s / (chain.is_free ? FADE_S : EASE_S));
		const float left = std::min(eased, 1.0f - chain.room / length);
		chain.shift = left * length > DONE ? chain.shift.scaled(left) : ChainShift();
	}
}

bool SelfClearance::push_apart(const Pair &p_pair) {
	const Chain &chain = _chains[std::size_t(_parts[std::size_t(p_pair.mover)].chain)];
	if (chain.is_fading && !p_pair.is_shared) {
		return false;
	}
	const Contact nearest = meet(p_pair, true);
	if (nearest.depth < DONE) {
		return false;
	}
	push(p_pair, nearest);
	// Both ends besides: of limbs that lie along each other no single point is the nearest.
	for (const float end : { 0.0f, 1.0f }) {
		const Contact contact = meet_end(p_pair, end);
		if (contact.depth > DONE) {
			push(p_pair, contact);
		}
	}
	return true;
}

SelfClearance::Lever SelfClearance::find_lever(const Part &p_part, float p_share, const Vec3 &p_normal) const {
	const Chain &chain = _chains[std::size_t(p_part.chain)];
	const Shares shares{ p_part.low.middle + (p_part.high.middle - p_part.low.middle) * p_share,
		p_part.low.end + (p_part.high.end - p_part.low.end) * p_share };
	Lever lever;
	lever.upper = (p_normal - chain.upper_way * chain.upper_way.dot(p_normal)) * (shares.middle + shares.end);
	lever.lower = (p_normal - chain.lower_way * chain.lower_way.dot(p_normal)) * shares.end;
	return lever;
}

void SelfClearance::push(const Pair &p_pair, const Contact &p_contact) {
	const Part &mover = _parts[std::size_t(p_pair.mover)];
	const Part &other = _parts[std::size_t(p_pair.other)];
	const Vec3 &normal = p_contact.approach.normal;
	const Lever own = find_lever(mover, p_contact.approach.share, normal);
	Lever others;
	if (p_pair.is_shared) {
		others = find_lever(other, p_contact.approach.other_share, normal);
	}
	const float weight = own.square() + others.square();
	if (weight < LEAST_LEVER) {
		return;
	}
	const float size = p_contact.depth / weight;
	const auto move = [&](const Part &p_part, const Lever &p_lever, float p_size) {
		ChainShift &shift = _chains[std::size_t(p_part.chain)].shift;
		shift.middle = shift.middle + p_lever.upper * p_size;
		shift.end = shift.end + (p_lever.upper + p_lever.lower) * p_size;
	};
	move(mover, own, size);
	if (p_pair.is_shared) {
		move(other, others, -size);
	}
}

void SelfClearance::turn(const Rig &p_rig, Pose &r_pose) {
	for (const Chain &chain : _chains) {
		if (!chain.shift.is_none()) {
			turn_chain(p_rig, chain.limbs, chain.shift, r_pose);
		}
	}
}

Vec3 SelfClearance::shift_of(const Part &p_part, const Shares &p_shares) const {
	const ChainShift &shift = _chains[std::size_t(p_part.chain)].shift;
	return shift.middle * p_shares.middle + shift.end * p_shares.end;
}

SolidAxis SelfClearance::axis_of(const Part &p_part, bool p_moved) const {
	const Vec3 half = p_part.solid.axes[1] * p_part.solid.half.y;
	if (!p_moved || p_part.chain < 0) {
		return { p_part.solid.centre - half, half * 2.0f };
	}
	const Vec3 low = shift_of(p_part, p_part.low);
	return { p_part.solid.centre - half + low, half * 2.0f + shift_of(p_part, p_part.high) - low };
}

SelfClearance::Contact SelfClearance::weigh(const Pair &p_pair, const Approach &p_approach) const {
	const LimbSolid &solid = _parts[std::size_t(p_pair.mover)].solid;
	const float allowed = std::max(overlap, p_pair.rest_overlap);
	return { p_approach, solid.thickness(p_approach.normal) - p_approach.distance - allowed };
}

SelfClearance::Contact SelfClearance::meet(const Pair &p_pair, bool p_moved) const {
	const Part &other = _parts[std::size_t(p_pair.other)];
	const SolidAxis mover = axis_of(_parts[std::size_t(p_pair.mover)], p_moved);
	const Part &part = _parts[std::size_t(p_pair.mover)];
	const Chain &chain = _chains[std::size_t(part.chain)];
	const AxisFreedom freedom{ chain.upper_way, chain.lower_way, part.low.end, part.high.end };
	return weigh(p_pair, approach_axis(mover, freedom, other.solid, axis_of(other, p_moved)));
}

SelfClearance::Contact SelfClearance::meet_end(const Pair &p_pair, float p_end) const {
	const Part &other = _parts[std::size_t(p_pair.other)];
	const SolidAxis mover = axis_of(_parts[std::size_t(p_pair.mover)], true);
	Contact contact = weigh(p_pair, approach_point(mover.at(p_end), other.solid, axis_of(other, true)));
	contact.approach.share = p_end;
	return contact;
}

std::vector<float> SelfClearance::find_turns() const {
	std::vector<float> turns(_limb_count, 0.0f);
	for (const Chain &chain : _chains) {
		turns[std::size_t(chain.limbs.upper)] = angle_between(chain.turned[0], chain.moved[0]);
		turns[std::size_t(chain.limbs.lower)] = angle_between(chain.turned[1], chain.moved[1]);
	}
	return turns;
}

void SelfClearance::save(ArchiveWriter &p_archive) const {
	p_archive.put(_has_begun);
	for (const Chain &chain : _chains) {
		p_archive.put(chain.kept);
	}
}

bool SelfClearance::restore(ArchiveReader &p_archive) {
	if (!p_archive.get(_has_begun)) {
		return false;
	}
	for (Chain &chain : _chains) {
		if (!p_archive.get(chain.kept)) {
			return false;
		}
	}
	return true;
}

} // namespace ragdoll
