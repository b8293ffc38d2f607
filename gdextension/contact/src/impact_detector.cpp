// SPDX-License-Identifier: MIT
#include "impact_detector.hpp"

#include <algorithm>
#include <cmath>

namespace contact {

namespace {

/// How much harder than usual a contact must press to be an impact of what already touches.
constexpr float JOLT_FACTOR = 4.0f;
/// How quickly the support follows, a share each step.
constexpr float FOLLOW = 0.15f;
/// Pairs that have not touched for so long are forgotten, steps.
constexpr int MEMORY_STEPS = 120;
/// A further impact within the merged time is told if it is so much stronger.
constexpr float STRONGER = 2.0f;

bool is_sound(const Touch &p_touch) {
	return std::isfinite(p_touch.impulse) && std::isfinite(p_touch.slip) && p_touch.impulse > 0.0f &&
			p_touch.mass > 0.0f;
}

} // namespace

std::size_t ImpactDetector::Hash::operator()(const Pair &p_pair) const {
	// A multiplication mixes better than a xor of numbers that lie close together.
	return std::size_t((p_pair.first * 0x9e3779b97f4a7c15ull) ^ p_pair.second);
}

std::vector<Impact> ImpactDetector::advance(const std::vector<Touch> &p_touches, std::size_t p_most) {
	_step++;
	_sums.clear();
	for (const Touch &touch : p_touches) {
		if (!is_sound(touch)) {
			continue;
		}
		Sum &sum = _sums[touch.pair];
		sum.impulse += touch.impulse;
		sum.slip = std::max(sum.slip, touch.slip);
		if (touch.impulse > sum.strongest) {
			sum.strongest = touch.impulse;
			sum.mass = touch.mass;
			sum.tag = touch.tag;
		}
	}
	std::vector<Impact> found;
	for (const auto &[pair, sum] : _sums) {
		State &state = _pairs[pair];
		if (state.seen < 0 || _step - state.seen > APART_STEPS) {
			state.begun = _step;
			state.support = 0.0f;
		}
		if (_is_impact(state, sum)) {
			found.push_back({ pair, sum.impulse, 0.0f, sum.tag });
		} else if (_is_scrape(state, sum)) {
			found.push_back({ pair, sum.impulse, sum.slip, sum.tag });
		}
		state.support += (sum.impulse - state.support) * (_step == state.begun ? 1.0f : FOLLOW);
		state.seen = _step;
	}
	if (_step % MEMORY_STEPS == 0) {
		_drop_old();
	}
	std::sort(found.begin(), found.end(), [](const Impact &p_a, const Impact &p_b) {
		// The numbers make the order the same on each run.
		return p_a.impulse != p_b.impulse ? p_a.impulse > p_b.impulse : p_a.pair.first < p_b.pair.first;
	});
	if (found.size() > p_most) {
		found.resize(p_most);
	}
	return found;
}

bool ImpactDetector::_is_impact(State &r_state, const Sum &p_sum) const {
	if (p_sum.impulse < MIN_SPEED * p_sum.mass) {
		return false;
	}
	const bool is_new = r_state.begun == _step;
	if (!is_new && p_sum.impulse < JOLT_FACTOR * r_state.support) {
		return false;
	}
	if (_step - r_state.told <= MERGED_STEPS && p_sum.impulse < STRONGER * r_state.told_impulse) {
		return false;
	}
	r_state.told = _step;
	r_state.told_impulse = p_sum.impulse;
	return true;
}

bool ImpactDetector::_is_scrape(State &r_state, const Sum &p_sum) const {
	if (p_sum.slip < MIN_SLIP || _step - r_state.begun < MERGED_STEPS || _step - r_state.scraped < SCRAPE_STEPS) {
		return false;
	}
	r_state.scraped = _step;
	return true;
}

void ImpactDetector::forget(std::uint64_t p_body) {
	for (auto it = _pairs.begin(); it != _pairs.end();) {
		it = it->first.first == p_body || it->first.second == p_body ? _pairs.erase(it) : std::next(it);
	}
}

void ImpactDetector::_drop_old() {
	for (auto it = _pairs.begin(); it != _pairs.end();) {
		it = _step - it->second.seen > MEMORY_STEPS ? _pairs.erase(it) : std::next(it);
	}
}

} // namespace contact
