// SPDX-License-Identifier: MIT
#include "clearance/self_clearance.hpp"

#include <algorithm>

namespace ragdoll {

namespace {

// All of these are from sweeps over 400 to 1,200 drawn poses that arms enter within a second (as those of
// tests/test_self_clearance.cpp): so many passes and no fewer leave less than 1 % of them deeper than 15 mm; a shift
// that goes faster turns limbs by more than 0.6 rad in a tick, a slower one leaves arms 50 mm deep on the way.
// Passes over all contacts: from how the step before ended, and from nothing.
constexpr int PASSES = 4;
constexpr int FIRST_PASSES = 40;
// Rounds that follow, as a turn tells only then where shapes beside the joints come to lie, and the time of each, s.
constexpr int FIRST_ROUNDS = 3;
constexpr float FIRST_S = 0.01f;
// Pairs with wider gaps than this (m) are not looked at in the passes.
constexpr float NEAR = 0.01f;
constexpr float FIRST_NEAR = 0.3f;
constexpr float FASTEST = 4.0f; // Of a shift, m/s.

} // namespace

SelfClearance::SelfClearance(const Rig &p_rig) :
		_body(p_rig),
		_limb_count(p_rig.size()),
		_chains(_body.chains.size()),
		_kept(_body.chains.size()),
		_places(_body.parts.size()) {
	for (std::size_t i = 0; i < _chains.size(); i++) {
		_chains[i].upper_rate = 1.0f / p_rig[std::size_t(_body.chains[i].lower)].anchor.length();
		_chains[i].lower_rate = 1.0f / p_rig[std::size_t(_body.chains[i].end)].anchor.length();
	}
	_near.reserve(std::max(_body.leg_pairs.size(), _body.arm_pairs.size()));
}

void SelfClearance::advance(const Rig &p_rig, bool p_begins, float p_delta_s, Pose &r_now, Pose &r_next) {
	if (_body.parts.empty() || overlap >= NO_LIMIT) {
		_has_begun = false;
		return;
	}
	if (p_begins || !_has_begun) {
		solve_anew(p_rig, r_now);
	} else {
		for (std::size_t i = 0; i < _chains.size(); i++) {
			if (_kept[i].is_moved == 0) {
				continue;
			}
			const TwoBoneChain &limbs = _body.chains[i];
			Quat &upper = r_now.orientations[std::size_t(limbs.upper)];
			Quat &lower = r_now.orientations[std::size_t(limbs.lower)];
			const Quat &above = r_now.orientations[std::size_t(p_rig[std::size_t(limbs.upper)].parent)];
			upper = (above * _kept[i].turn.upper * above.inverse() * upper).normalized();
			lower = (above * _kept[i].turn.lower * above.inverse() * lower).normalized();
		}
	}
	_has_begun = true;
	solve(p_rig, false, p_delta_s, r_next);
}

void SelfClearance::clear(const Rig &p_rig, Pose &r_pose) {
	_has_begun = false;
	if (!_body.parts.empty() && overlap < NO_LIMIT) {
		solve_anew(p_rig, r_pose);
	}
}

void SelfClearance::solve_anew(const Rig &p_rig, Pose &r_pose) {
	_wanted = r_pose;
	solve(p_rig, true, 0.0f, r_pose);
	for (int round = 0; round < FIRST_ROUNDS; round++) {
		r_pose = _wanted;
		solve(p_rig, false, FIRST_S, r_pose);
	}
}

void SelfClearance::solve(const Rig &p_rig, bool p_begins, float p_delta_s, Pose &r_pose) {
	begin(p_rig, p_begins, r_pose);
	// Arms keep clear of where the legs are then.
	solve_pairs(r_pose, _body.leg_pairs, p_begins, p_delta_s);
	solve_pairs(r_pose, _body.arm_pairs, p_begins, p_delta_s);
	keep(p_rig, p_begins, p_delta_s, r_pose);
}

void SelfClearance::begin(const Rig &p_rig, bool p_begins, const Pose &p_pose) {
	p_rig.joint_positions(p_pose, _joints);
	_step++;
	for (ClearancePart &part : _body.parts) {
		const std::size_t limb = std::size_t(part.solid.limb);
		part.solid.place(p_pose.orientations[limb], _joints[limb]);
	}
	for (std::size_t i = 0; i < _chains.size(); i++) {
		Chain &chain = _chains[i];
		const TwoBoneChain &limbs = _body.chains[i];
		const Vec3 &middle = _joints[std::size_t(limbs.lower)];
		chain.upper = middle - _joints[std::size_t(limbs.upper)];
		chain.lower = _joints[std::size_t(limbs.end)] - middle;
		chain.upper_way = chain.upper * chain.upper_rate;
		chain.lower_way = chain.lower * chain.lower_rate;
		chain.shift = {};
		chain.biases[0] = {};
		chain.biases[1] = {};
		chain.length = 0.0f;
		chain.left = 0.0f;
		if (!p_begins && _kept[i].is_moved != 0) {
			const int above = p_rig[std::size_t(limbs.upper)].parent;
			const Quat &turn = p_pose.orientations[std::size_t(above)];
			chain.shift = _kept[i].shift.turned(turn);
			chain.biases[0] = { turn.rotate(_kept[i].upper.low), turn.rotate(_kept[i].upper.high) };
			chain.biases[1] = { turn.rotate(_kept[i].lower.low), turn.rotate(_kept[i].lower.high) };
			keep_lengths(chain.upper, chain.lower, chain.shift);
			chain.upper_way = (chain.upper + chain.shift.middle) * chain.upper_rate;
			chain.lower_way = (chain.lower + chain.shift.end - chain.shift.middle) * chain.lower_rate;
			chain.length = chain.shift.length();
			const ChainShift before = _kept[i].wanted.turned(turn);
			chain.way = ChainShift{ chain.upper - before.middle, chain.upper + chain.lower - before.end }.length();
		}
	}
}

void SelfClearance::solve_pairs(
		const Pose &p_pose, const std::vector<ClearancePair> &p_pairs, bool p_begins, float p_delta_s) {
	if (p_pairs.empty() || !has_work(p_pose, p_pairs, p_begins)) {
		return;
	}
	const bool is_leg = _body.chains[std::size_t(_body.parts[std::size_t(p_pairs[0].mover)].chain)].is_leg;
	let_go(is_leg, p_delta_s);
	for (int pass = 0; pass < (p_begins ? FIRST_PASSES : PASSES); pass++) {
		bool is_pushed = false;
		for (std::size_t i = 0; i < _chains.size(); i++) {
			_chains[i].left = _body.chains[i].is_leg == is_leg ? 0.0f : _chains[i].left;
		}
		for (const Near &near : _near) {
			is_pushed |= push_apart(near);
		}
		if (!is_pushed) {
			return;
		}
		for (std::size_t i = 0; i < _chains.size(); i++) {
			if (_body.chains[i].is_leg == is_leg && !_chains[i].shift.is_none()) {
				keep_lengths(_chains[i].upper, _chains[i].lower, _chains[i].shift);
				move_chain(i);
			}
		}
	}
}

bool SelfClearance::has_work(const Pose &p_pose, const std::vector<ClearancePair> &p_pairs, bool p_begins) {
	const ClearancePart &first = _body.parts[std::size_t(p_pairs[0].mover)];
	bool is_moved = false;
	for (std::size_t i = 0; i < _chains.size(); i++) {
		is_moved |= _chains[i].length > 0.0f && _body.chains[i].is_leg == _body.chains[std::size_t(first.chain)].is_leg;
	}
	// Mostly nothing touches: what is only near matters where something does.
	const bool meets = find_near(p_pose, p_pairs, p_begins ? FIRST_NEAR : (is_moved ? NEAR : 0.0f));
	if (meets && !is_moved && !p_begins) {
		find_near(p_pose, p_pairs, NEAR);
	}
	return meets || is_moved;
}

void SelfClearance::keep(const Rig &p_rig, bool p_begins, float p_delta_s, Pose &r_pose) {
	for (std::size_t i = 0; i < _chains.size(); i++) {
		Chain &chain = _chains[i];
		Kept &kept = _kept[i];
		const std::size_t above = std::size_t(p_rig[std::size_t(_body.chains[i].upper)].parent);
		if (!p_begins && (!chain.shift.is_none() || kept.is_moved != 0)) {
			const ChainShift before = kept.is_moved != 0 ? kept.shift.turned(r_pose.orientations[above]) : ChainShift();
			const float most = FASTEST * p_delta_s;
			chain.shift.middle = before.middle + (chain.shift.middle - before.middle).limited(most);
			chain.shift.end = before.end + (chain.shift.end - before.end).limited(most);
		}
		kept.is_moved = chain.shift.is_none() ? 0 : 1;
		if (kept.is_moved != 0) {
			keep_turn(p_rig, i, r_pose);
		}
	}
}

void SelfClearance::keep_turn(const Rig &p_rig, std::size_t p_chain, Pose &r_pose) {
	const Chain &chain = _chains[p_chain];
	const TwoBoneChain &limbs = _body.chains[p_chain];
	const Quat into = r_pose.orientations[std::size_t(p_rig[std::size_t(limbs.upper)].parent)].inverse();
	const ChainTurn turn = turn_chain(p_rig, limbs, chain.shift, r_pose);
	Kept &kept = _kept[p_chain];
	kept.shift = chain.shift.turned(into);
	kept.wanted = ChainShift{ chain.upper, chain.upper + chain.lower }.turned(into);
	kept.left = chain.left;
	kept.turn = { into * turn.upper * into.inverse(), into * turn.lower * into.inverse() };
	const Quat &upper = r_pose.orientations[std::size_t(limbs.upper)];
	const Vec3 &first = _joints[std::size_t(limbs.upper)];
	const Vec3 middle = first + upper.rotate(p_rig[std::size_t(limbs.lower)].anchor);
	for (const int index : _body.chain_parts[p_chain]) {
		const ClearancePart &part = _body.parts[std::size_t(index)];
		if (part.solid.limb == limbs.end || _places[std::size_t(index)].step != _step) {
			continue;
		}
		const bool is_upper = part.solid.limb == limbs.upper;
		const Quat &now = r_pose.orientations[std::size_t(part.solid.limb)];
		const Bias bias = find_bias(part, now, is_upper ? first : middle);
		Bias &own = is_upper ? kept.upper : kept.lower;
		own = Bias{ into.rotate(bias.low), into.rotate(bias.high) };
	}
}

SelfClearance::Bias SelfClearance::find_bias(
		const ClearancePart &p_part, const Quat &p_orientation, const Vec3 &p_joint) const {
	const ChainShift &shift = _chains[std::size_t(p_part.chain)].shift;
	const SolidAxis before = p_part.solid.get_axis();
	const SolidAxis after = p_part.solid.find_axis(p_orientation, p_joint);
	const Vec3 low = shift.middle * p_part.low.middle + shift.end * p_part.low.end;
	const Vec3 high = shift.middle * p_part.high.middle + shift.end * p_part.high.end;
	return { after.from - before.from - low, after.at(1.0f) - before.at(1.0f) - high };
}

std::vector<float> SelfClearance::find_turns() const {
	std::vector<float> turns(_limb_count, 0.0f);
	for (std::size_t i = 0; i < _kept.size(); i++) {
		if (_kept[i].is_moved != 0) {
			turns[std::size_t(_body.chains[i].upper)] = log(_kept[i].turn.upper).length();
			turns[std::size_t(_body.chains[i].lower)] = log(_kept[i].turn.lower).length();
		}
	}
	return turns;
}

void SelfClearance::save(ArchiveWriter &p_archive) const {
	p_archive.put(_has_begun);
	p_archive.put_all(_kept);
}

bool SelfClearance::restore(ArchiveReader &p_archive) {
	return p_archive.get(_has_begun) && p_archive.get_all(_kept);
}

} // namespace ragdoll
