// SPDX-License-Identifier: MIT
#include "player.hpp"

#include <algorithm>
#include <cmath>

namespace matching {

namespace {

/// What it costs to turn a motion about the vertical, for each rad squared.
constexpr float TURNING_COST = 0.5f;
/// Motion is never turned by more, rad: from there on the opposite direction is nearer.
constexpr float MAX_TURNING = 1.95f;
/// What stays in favour of going on as before: changes of motion are seen.
constexpr float GOING_ON = 0.35f;
/// Frames of the same clip that are nearer than this are no other moment.
constexpr float SAME_FRAMES = 12.0f;
/// Who goes less far in a second stands, heights of the hips: nobody who stands is shown walking, nor the other way.
constexpr float MIN_WAY = 0.2f;
/// What it costs to run where walking is meant, and the other way.
constexpr float OTHER_GAIT_COST = 6.0f;

} // namespace

void Player::reset(const MotionSet &p_set) {
	*this = Player();
	for (const MotionSet::Family &family : p_set.families()) {
		if (family.stance == STAND && family.stands) {
			_entry = p_set.place_of(family.first_row).entry;
		}
	}
}

void Player::enter(const MotionSet &p_set, const Features &p_current, const Way &p_way, Stance p_stance, bool p_runs) {
	reset(p_set);
	float own_cost = 0.0f;
	const FeatureTable::Found best = _nearest(p_set, p_current, p_way, p_stance, p_runs, own_cost);
	if (best.row >= 0) {
		_go_to(p_set.place_of(best.row));
	}
}

FeatureTable::Found Player::_nearest(const MotionSet &p_set, const Features &p_current, const Way &p_way,
		Stance p_stance, bool p_runs, float &r_own_cost) const {
	const Stance stance = p_set.has(p_stance) ? p_stance : STAND;
	const int own_family = entry(p_set).family;
	const bool goes = std::hypot(p_way.x[2], p_way.z[2]) > MIN_WAY;
	const float travel = std::atan2(p_way.x[2], p_way.z[2]);
	const bool has_both = p_set.has(stance, false) && p_set.has(stance, true);
	const bool has_gait = p_set.has_gait(stance, p_runs);
	FeatureTable::Found best;
	for (std::size_t i = 0; i < p_set.families().size(); i++) {
		const MotionSet::Family &family = p_set.families()[i];
		if (family.stance != stance || (family.stands == goes && has_both)) {
			continue;
		}
		const float turning = family.stands || !goes ? 0.0f : wrapped(travel - family.travel);
		if (std::fabs(turning) > MAX_TURNING) {
			continue;
		}
		Features row = p_current;
		put_way(p_way, -turning, row);
		p_set.table().scale(row);
		const bool is_other_gait = !family.stands && has_gait && family.runs != p_runs;
		const float extra = TURNING_COST * turning * turning + (is_other_gait ? OTHER_GAIT_COST : 0.0f);
		if (int(i) == own_family) {
			r_own_cost = p_set.table().cost(p_set.row_of({ _entry, int(_frame) }), row) + extra;
		}
		FeatureTable::Found found = p_set.table().nearest(row, family.first_row, family.end_row, best.cost - extra);
		if (found.row >= 0) {
			best = { found.row, found.cost + extra };
		}
	}
	return best;
}

void Player::_go_to(const MotionSet::Place &p_place) {
	_entry = p_place.entry;
	_frame = float(p_place.frame);
	_direction = 1.0f;
}

bool Player::search(const MotionSet &p_set, const Way &p_way, Stance p_stance, bool p_runs) {
	float own_cost = std::numeric_limits<float>::max();
	const Features &current = p_set.features_at({ _entry, int(_frame) });
	const FeatureTable::Found best = _nearest(p_set, current, p_way, p_stance, p_runs, own_cost);
	const bool can_go_on =
			entry(p_set).stands || _frame < float(entry(p_set).clip.frames.size()) - float(MotionSet::LAST_FRAMES);
	if (best.row < 0 || (can_go_on && best.cost > own_cost - GOING_ON)) {
		return false;
	}
	const MotionSet::Place &place = p_set.place_of(best.row);
	const bool both_stand = entry(p_set).stands && p_set.entries()[std::size_t(place.entry)].stands;
	if (both_stand || (place.entry == _entry && std::fabs(float(place.frame) - _frame) < SAME_FRAMES && can_go_on)) {
		return false;
	}
	_go_to(place);
	return true;
}

float Player::_clamped(const MotionSet &p_set, float p_frame) const {
	return std::clamp(p_frame, 0.0f, float(entry(p_set).clip.frames.size()) - 1.0f);
}

bool Player::advance(const MotionSet &p_set, float p_delta, float p_rate) {
	const MotionSet::Entry &now = entry(p_set);
	const float last = float(now.clip.frames.size()) - 1.0f;
	_frame += p_delta * RATE * p_rate * _direction;
	if (now.stands) {
		if (_frame >= last || _frame <= 0.0f) {
			_direction = _frame >= last ? -1.0f : 1.0f;
		}
		_frame = _clamped(p_set, _frame);
		return true;
	}
	_frame = _clamped(p_set, _frame);
	return _frame < last - 2.0f;
}

Player::Sample Player::sample(const MotionSet &p_set, float p_ahead_s) const {
	const std::vector<ClipFrame> &frames = entry(p_set).clip.frames;
	const float at = _clamped(p_set, _frame + p_ahead_s * RATE * _direction);
	const std::size_t first = std::min(std::size_t(at), frames.size() - 2);
	const float share = at - float(first);
	const ClipFrame &from = frames[first];
	const ClipFrame &to = frames[first + 1];
	Sample sample;
	sample.pose.hips = blend(from.pose.hips, to.pose.hips, share);
	for (std::size_t side = 0; side < 2; side++) {
		sample.pose.ankles[side] = blend(from.pose.ankles[side], to.pose.ankles[side], share);
		sample.stands[side] = (((share < 0.5f ? from : to).contacts >> side) & 1U) != 0;
	}
	for (std::size_t limb = 0; limb < LIMBS; limb++) {
		sample.pose.limbs[limb] = blend(from.pose.limbs[limb], to.pose.limbs[limb], share);
	}
	sample.velocity_x = from.velocity_x + (to.velocity_x - from.velocity_x) * share;
	sample.velocity_z = from.velocity_z + (to.velocity_z - from.velocity_z) * share;
	return sample;
}

} // namespace matching
