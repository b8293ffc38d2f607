// SPDX-License-Identifier: MIT
#include "balance/anatomy.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ragdoll {

namespace {

constexpr std::size_t WITHOUT_SHOULDER = 3; // Upper arm, forearm, hand.

Vec3 at_rest(const Rig &p_rig, int p_limb, const Vec3 &p_local) {
	return p_rig[std::size_t(p_limb)].rest.rotate(p_local);
}

/// The last limb that hangs on a limb, or -1.
int find_child(const Rig &p_rig, int p_limb) {
	int child = -1;
	for (std::size_t i = 1; i < p_rig.size(); i++) {
		child = p_rig[i].parent == p_limb ? int(i) : child;
	}
	return child;
}

} // namespace

JointAngles JointAngles::mirrored() const {
	JointAngles result = *this;
	for (std::array<float, 2> *pair : { &result.thigh, &result.thigh_out, &result.knee, &result.ankle, &result.arm,
				 &result.arm_out, &result.elbow, &result.wrist }) {
		std::swap((*pair)[0], (*pair)[1]);
	}
	return result;
}

std::vector<std::size_t> find_arms(const Rig &p_rig) {
	std::vector<int> hanging(p_rig.size(), 0);
	for (std::size_t i = 1; i < p_rig.size(); i++) {
		hanging[std::size_t(p_rig[i].parent)] += p_rig.is_in_leg(i) ? 0 : 1;
	}
	std::vector<std::size_t> arms;
	for (std::size_t i = 1; i < p_rig.size(); i++) {
		if (!p_rig.is_in_leg(i) && hanging[i] > 0 && hanging[std::size_t(p_rig[i].parent)] > 1) {
			arms.push_back(i);
		}
	}
	return arms;
}

Anatomy::Anatomy(const Rig &p_rig, const std::vector<Leg> &p_legs, const std::vector<std::size_t> &p_arms) :
		_limbs(p_rig.size()) {
	for (std::size_t i = 0; i < p_rig.size(); i++) {
		_limbs[i].parent = p_rig[i].parent;
		_limbs[i].neutral = p_rig[i].rest;
	}
	if (p_legs.size() != 2) {
		return;
	}
	_known = true;
	find_axes(p_rig, p_legs);
	for (const Leg &leg : p_legs) {
		add_leg(p_rig, leg);
	}
	for (const std::size_t arm : p_arms) {
		add_arm(p_rig, arm);
	}
	add_trunk(p_rig, p_arms);
}

void Anatomy::find_axes(const Rig &p_rig, const std::vector<Leg> &p_legs) {
	const Vec3 between = p_rig[std::size_t(p_legs[0].thigh)].anchor - p_rig[std::size_t(p_legs[1].thigh)].anchor;
	_left = level(at_rest(p_rig, 0, between));
	_left = _left * (1.0f / std::max(_left.length(), 1e-6f));
	// Turned so that ahead is where the feet point.
	const int foot = p_legs[0].foot;
	if (_left.cross(UP).dot(at_rest(p_rig, foot, p_rig[std::size_t(foot)].centre)) < 0.0f) {
		_left = _left * -1.0f;
	}
	_ahead = _left.cross(UP);
}

void Anatomy::hang(const Rig &p_rig, int p_limb, Part p_part, std::size_t p_side, const Vec3 &p_along) {
	Limb &limb = _limbs[std::size_t(p_limb)];
	limb.part = p_part;
	limb.side = p_side;
	limb.neutral = rotation_between(at_rest(p_rig, p_limb, p_along), UP * -1.0f) * p_rig[std::size_t(p_limb)].rest;
}

void Anatomy::add_leg(const Rig &p_rig, const Leg &p_leg) {
	const Vec3 at = at_rest(p_rig, 0, p_rig[std::size_t(p_leg.thigh)].anchor);
	const std::size_t side = at.dot(_left) > 0.0f ? 0 : 1;
	hang(p_rig, p_leg.thigh, Part::THIGH, side, p_rig[std::size_t(p_leg.shin)].anchor);
	hang(p_rig, p_leg.shin, Part::SHIN, side, p_rig[std::size_t(p_leg.foot)].anchor);
	_limbs[std::size_t(p_leg.foot)].part = Part::FOOT;
	_limbs[std::size_t(p_leg.foot)].side = side;
}

void Anatomy::add_arm(const Rig &p_rig, std::size_t p_first) {
	std::vector<int> chain;
	for (int limb = int(p_first); limb >= 0; limb = find_child(p_rig, limb)) {
		chain.push_back(limb);
	}
	const Vec3 at = at_rest(p_rig, p_rig[p_first].parent, p_rig[p_first].anchor);
	const std::size_t side = at.dot(_left) > 0.0f ? 0 : 1;
	const std::size_t shoulders = chain.size() > WITHOUT_SHOULDER ? 1 : 0;
	for (std::size_t i = shoulders; i < chain.size(); i++) {
		const Segment &limb = p_rig[std::size_t(chain[i])];
		const Vec3 along = i + 1 < chain.size() ? p_rig[std::size_t(chain[i + 1])].anchor : limb.centre;
		const std::size_t place = std::min<std::size_t>(i - shoulders, 2);
		hang(p_rig, chain[i], Part(int(Part::UPPER_ARM) + int(place)), side, along);
	}
}

void Anatomy::add_trunk(const Rig &p_rig, const std::vector<std::size_t> &p_arms) {
	int joints = 0;
	for (const std::size_t arm : p_arms) {
		for (int limb = p_rig[arm].parent; limb > 0; limb = p_rig[std::size_t(limb)].parent) {
			Part &part = _limbs[std::size_t(limb)].part;
			joints += part == Part::SPINE ? 0 : 1;
			part = Part::SPINE;
		}
	}
	_spine_share = joints > 0 ? 1.0f / float(joints) : 0.0f;
	for (std::size_t i = 1; i < p_rig.size(); i++) {
		if (_limbs[i].part == Part::OTHER && _limbs[std::size_t(p_rig[i].parent)].part == Part::SPINE) {
			_limbs[i].part = Part::HEAD;
		}
	}
}

Quat Anatomy::find_heading(const Vec3 &p_ahead) const {
	return exp(UP * std::atan2(_ahead.cross(p_ahead).y, _ahead.dot(p_ahead)));
}

Quat Anatomy::get_hips(const JointAngles &p_angles, const Quat &p_heading) const {
	return p_heading * exp(_left * p_angles.pitch) * _limbs[0].neutral;
}

Quat Anatomy::find_turn(const Limb &p_limb, const JointAngles &p_angles) const {
	const std::size_t side = p_limb.side;
	const Vec3 out = side == 0 ? _ahead : _ahead * -1.0f;
	switch (p_limb.part) {
		case Part::SPINE:
			return exp(_left * (p_angles.spine * _spine_share));
		case Part::HEAD:
			return exp(_left * -p_angles.neck);
		case Part::THIGH:
			return exp(_left * -p_angles.thigh[side]) * exp(out * p_angles.thigh_out[side]);
		case Part::SHIN:
			return exp(_left * p_angles.knee[side]);
		case Part::FOOT:
			return exp(_left * -p_angles.ankle[side]);
		case Part::UPPER_ARM:
			return exp(_left * -p_angles.arm[side]) * exp(out * p_angles.arm_out[side]);
		case Part::FOREARM:
			return exp(_left * -p_angles.elbow[side]);
		case Part::HAND:
			return exp(_left * -p_angles.wrist[side]);
		case Part::OTHER:
			break;
	}
	return Quat();
}

void Anatomy::pose(const JointAngles &p_angles, const Quat &p_heading, std::vector<Quat> &r_orientations) const {
	// First how far each limb is turned from where all angles are 0.
	r_orientations[0] = p_heading * exp(_left * p_angles.pitch);
	for (std::size_t i = 1; i < _limbs.size(); i++) {
		r_orientations[i] = r_orientations[std::size_t(_limbs[i].parent)] * find_turn(_limbs[i], p_angles);
	}
	for (std::size_t i = 0; i < _limbs.size(); i++) {
		r_orientations[i] = r_orientations[i] * _limbs[i].neutral;
	}
}

} // namespace ragdoll
