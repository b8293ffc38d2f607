// SPDX-License-Identifier: MIT
#include "gait/foot_lock.hpp"

#include "base/calm.hpp"

#include <algorithm>
#include <limits>

namespace ragdoll {

namespace {

constexpr float LOOSE = 0.1f; // A grip below this holds nothing.
constexpr float UPRIGHT = 0.3f; // Sum of the soles' weights from which a body stands on its feet.

} // namespace

FootLock::FootLock(const Rig &p_rig, const std::vector<ContactPoint> &p_contacts) :
		_contacts(p_contacts),
		_anchors(p_contacts.size()),
		_grounds(p_contacts.size()),
		_grips(p_contacts.size(), 0.0f) {
	for (const Leg &limbs : find_legs(p_rig, p_contacts)) {
		HeldLeg leg;
		static_cast<Leg &>(leg) = limbs;
		_legs.push_back(leg);
	}
	for (HeldLeg &leg : _legs) {
		for (std::size_t i = 0; i < _contacts.size(); i++) {
			if (_contacts[i].limb == leg.foot) {
				leg.points.push_back(i);
				leg.sole = leg.sole + _contacts[i].local;
			}
		}
		leg.sole = leg.sole * (1.0f / float(leg.points.size()));
	}
}

void FootLock::clear() {
	for (HeldLeg &leg : _legs) {
		leg.offset = {};
		leg.away = {};
		leg.rise = 0.0f;
		leg.tilt = {};
		leg.place = NOWHERE;
	}
	std::fill(_grips.begin(), _grips.end(), 0.0f);
	_drop = 0.0f;
}

void FootLock::advance(const Travel &p_travel, const Vec3 &p_root, const std::vector<Vec3> &p_points,
		const std::vector<Vec3> &p_shown, float p_unrest, float p_delta_s) {
	const float grip_s = GRIP_S * p_unrest;
	_floor = std::numeric_limits<float>::infinity();
	for (std::size_t i = 0; i < _contacts.size(); i++) {
		_floor = std::min(_floor, p_points[i].y - _contacts[i].radius);
	}
	find_level(p_travel, p_points);
	const float kept = grip_s > 0.0f ? std::exp(-p_delta_s / grip_s) : 0.0f;
	for (HeldLeg &leg : _legs) {
		find_clearance(leg, p_travel, p_root, p_points, p_delta_s);
		leg.offset = leg.offset * std::exp(-p_delta_s / LET_GO_S);
		const float excess = std::max(leg.away.length() - SLIPS_FROM - SLIPS_LATER * p_unrest, 0.0f);
		const Vec3 slip = leg.away.limited(excess) * share(p_delta_s, SLIP_S);
		for (std::size_t i = 0; i < _contacts.size(); i++) {
			if (_contacts[i].limb != leg.foot) {
				continue;
			}
			if (_grips[i] < LOOSE) {
				_anchors[i] = p_root + p_points[i] + leg.offset;
			}
			_anchors[i] = _anchors[i] + p_travel.get_carry(i, _anchors[i], p_delta_s);
			const float wanted = p_travel.is_anchored(i) ? 1.0f : 0.0f;
			_grips[i] = wanted + (_grips[i] - wanted) * kept;
			_anchors[i] = _anchors[i] - slip;
			const float height = p_travel.get_standing_height(i);
			_anchors[i].y = std::isfinite(height) ? height : _anchors[i].y;
			_grounds[i] = { p_root.x + p_points[i].x, height, p_root.z + p_points[i].z };
			if (p_shown[i].y < _anchors[i].y + DOWN) { // What is in the air still comes to where it is held.
				const Vec3 off = level(p_shown[i] - _anchors[i]);
				_anchors[i] = _anchors[i] + off - off.limited(SLACK);
			}
		}
		fit(leg, p_root, p_points, p_unrest, p_delta_s);
	}
}

void FootLock::find_level(const Travel &p_travel, const std::vector<Vec3> &p_points) {
	float sum = 0.0f;
	_level = 0.0f;
	for (std::size_t i = 0; i < _contacts.size(); i++) {
		const float weight = _contacts[i].sole ? p_travel.get_weights()[i] : 0.0f;
		_level += (p_points[i].y - _contacts[i].radius) * weight;
		sum += weight;
	}
	_level = sum > UPRIGHT ? _level / sum : -std::numeric_limits<float>::infinity();
}

void FootLock::find_clearance(HeldLeg &r_leg, const Travel &p_travel, const Vec3 &p_root,
		const std::vector<Vec3> &p_points, float p_delta_s) const {
	Vec3 place = p_root;
	for (const std::size_t point : r_leg.points) {
		place = place + p_points[point] * (1.0f / float(r_leg.points.size()));
	}
	const Vec3 carried = r_leg.points.empty() ? Vec3() : p_travel.get_carry(r_leg.points[0], r_leg.place, p_delta_s);
	const float speed = level(place - r_leg.place - carried).length() / p_delta_s;
	r_leg.place = place;
	const float fast = speed > CLEARS_FROM ? std::min((speed - CLEARS_FROM) / (CLEARS_AT - CLEARS_FROM), 1.0f) : 0.0f;
	r_leg.clearance = CLEARS * fast; // None where nothing is known of the place before.
}

Vec3 FootLock::find_tilt(const HeldLeg &p_leg) const {
	if (p_leg.points.size() < 3) {
		return {};
	}
	const Vec3 &heel = _grounds[p_leg.points[0]];
	const Vec3 &left = _grounds[p_leg.points[1]];
	Vec3 normal = (left - heel).cross(_grounds[p_leg.points[2]] - heel);
	normal = normal * ((normal.y < 0.0f ? -1.0f : 1.0f) / std::max(normal.length(), 1e-9f));
	for (const std::size_t point : p_leg.points) {
		// Written so that no ground fails too.
		if (!(std::fabs((_grounds[point] - heel).dot(normal)) < PLANE)) {
			return {};
		}
	}
	return log(rotation_between({ 0.0f, 1.0f, 0.0f }, normal)).limited(STEEPEST);
}

float FootLock::find_rise(
		const HeldLeg &p_leg, const Vec3 &p_root, const std::vector<Vec3> &p_points, float p_unrest) const {
	Vec3 middle;
	for (const std::size_t point : p_leg.points) {
		middle = middle + p_points[point] * (1.0f / float(p_leg.points.size()));
	}
	const Quat turn = exp(p_leg.tilt);
	// The foot is held beside where the motion has it, where a slope is higher or lower.
	const Vec3 normal = turn.rotate({ 0.0f, 1.0f, 0.0f });
	const float beside = -(normal.x * p_leg.offset.x + normal.z * p_leg.offset.z) / normal.y;
	float deepest = 0.0f;
	float sinks = -HIGHEST;
	float lowest = 0.0f; // Of the sole over the level that the motion stands on, where it is below that.
	float held = 0.0f;
	float sum = 0.0f;
	for (const std::size_t point : p_leg.points) {
		if (!std::isfinite(_grounds[point].y)) {
			continue;
		}
		const Vec3 place = p_root + middle + turn.rotate(p_points[point] - middle);
		const float depth = _grounds[point].y + beside - place.y;
		// What swings shall clear the ground as it clears the floor, and by more the faster it does.
		const float over = std::max(std::min(p_points[point].y - _floor, SWING), p_leg.clearance);
		deepest = std::max(deepest, depth + over * (1.0f - p_unrest));
		const float over_level = p_points[point].y - _contacts[point].radius - _level;
		sinks = std::max(sinks, depth + std::max(over_level, p_leg.clearance));
		lowest = std::min(lowest, over_level);
		held += depth * _grips[point];
		sum += _grips[point];
	}
	if (sum < LOOSE && deepest <= 0.0f) {
		// It comes down to lower ground as it does to the floor, unless the motion is stepping down itself.
		deepest = std::min(sinks, 0.0f) * std::max(1.0f + lowest / LOWER, 0.0f) * (1.0f - p_unrest);
	}
	const float rise = sum < LOOSE ? deepest : held / sum;
	const float beyond = std::max(std::fabs(rise) - UNEVEN * p_unrest, 0.0f);
	return beyond < EVEN ? 0.0f : std::copysign(std::min(beyond, HIGHEST), rise);
}

void FootLock::fit(
		HeldLeg &r_leg, const Vec3 &p_root, const std::vector<Vec3> &p_points, float p_unrest, float p_delta_s) const {
	const float part = share(p_delta_s, FIT_S + GRIP_S * p_unrest);
	r_leg.tilt = r_leg.tilt + (find_tilt(r_leg) - r_leg.tilt) * part;
	r_leg.rise += (find_rise(r_leg, p_root, p_points, p_unrest) - r_leg.rise) * part;
}

Vec3 FootLock::tilt(const HeldLeg &p_leg, Pose &r_pose) const {
	if (p_leg.tilt.length() < 1e-4f) {
		return {};
	}
	Quat &foot = r_pose.orientations[std::size_t(p_leg.foot)];
	const Vec3 before = foot.rotate(p_leg.sole);
	foot = exp(p_leg.tilt) * foot;
	return before - foot.rotate(p_leg.sole);
}

float FootLock::sink(const Rig &p_rig, float p_unrest, const std::vector<Vec3> &p_joints, float p_delta_s) {
	float needed = 0.0f;
	for (const HeldLeg &leg : _legs) {
		const Vec3 hip = p_joints[std::size_t(leg.thigh)];
		const Vec3 pose = p_joints[std::size_t(leg.foot)] - hip;
		const float length =
				p_rig[std::size_t(leg.shin)].anchor.length() + p_rig[std::size_t(leg.foot)].anchor.length();
		const float reach = std::max(length * STRETCHED, pose.length());
		const Vec3 wanted = pose + leg.offset + Vec3{ 0.0f, leg.rise, 0.0f };
		const float across = level(wanted).length();
		if (wanted.length() > reach && across < reach) {
			needed = std::max(needed, -wanted.y - std::sqrt(reach * reach - across * across));
		}
	}
	needed = std::max(needed - UNEVEN * p_unrest, 0.0f);
	const float most = SINK_SPEED * p_delta_s;
	const float off = (std::min(needed, HIGHEST) - _drop) * share(p_delta_s, SINK_S);
	_drop += std::clamp(off, -most, most);
	return _drop;
}

void FootLock::shift(const Vec3 &p_offset) {
	for (Vec3 &anchor : _anchors) {
		anchor = anchor + p_offset;
	}
	for (HeldLeg &leg : _legs) {
		leg.place = leg.place + p_offset;
	}
}

void FootLock::save(ArchiveWriter &p_archive) const {
	for (const HeldLeg &leg : _legs) {
		p_archive.put(leg.offset);
		p_archive.put(leg.away);
		p_archive.put(leg.rise);
		p_archive.put(leg.tilt);
		p_archive.put(leg.place);
	}
	p_archive.put_all(_anchors);
	p_archive.put_all(_grips);
	p_archive.put(_drop);
}

bool FootLock::restore(ArchiveReader &p_archive) {
	for (HeldLeg &leg : _legs) {
		if (!p_archive.get(leg.offset) || !p_archive.get(leg.away) || !p_archive.get(leg.rise) ||
				!p_archive.get(leg.tilt) || !p_archive.get(leg.place)) {
			return false;
		}
	}
	return p_archive.get_all(_anchors) && p_archive.get_all(_grips) && p_archive.get(_drop);
}

void FootLock::apply(const Rig &p_rig, float p_unrest, Pose &r_pose, std::vector<Vec3> &r_joints) {
	// How high the feet are, the root's height sees to, unless shaking knees lift them.
	const float lift = std::min(2.0f * p_unrest, 1.0f);
	for (HeldLeg &leg : _legs) {
		const Vec3 moved = tilt(leg, r_pose);
		const Quat &foot = r_pose.orientations[std::size_t(leg.foot)];
		const Vec3 ankle = r_joints[std::size_t(leg.foot)] + moved;
		Vec3 away;
		float sum = 0.0f;
		float firmest = 0.0f;
		for (std::size_t i = 0; i < _contacts.size(); i++) {
			if (_contacts[i].limb == leg.foot && _grips[i] >= LOOSE) {
				// All that are held count alike: as weights change, the foot must not.
				const Vec3 position = ankle + foot.rotate(_contacts[i].local);
				away = away + (_anchors[i] - position) * _grips[i];
				sum += _grips[i];
				firmest = std::max(firmest, _grips[i]);
			}
		}
		leg.away = {};
		if (sum > 0.0f) {
			leg.away = Vec3{ away.x, 0.0f, away.z } * (1.0f / sum);
			const Vec3 wanted = (Vec3{ away.x, away.y * lift, away.z } * (1.0f / sum)).limited(FURTHEST);
			leg.offset = leg.offset + (wanted - leg.offset) * firmest;
		}
		const Vec3 offset = leg.offset + moved + Vec3{ 0.0f, leg.rise + _drop, 0.0f };
		if (offset.length() > 1e-5f) {
			bend_leg(p_rig, leg, offset, r_pose, r_joints);
		}
	}
}

} // namespace ragdoll
