// SPDX-License-Identifier: MIT
#include "root/tether.hpp"

#include "base/calm.hpp"

#include <algorithm>

namespace ragdoll {

namespace {

constexpr float HELD_S = 0.2f; // Who was held back a moment ago still is.
constexpr float COMING = 1.0f; // Who comes back faster than this (m/s) is not held,
constexpr float FLUNG = 12.0f; // nor who leaves faster than people run,
constexpr float PULLED = 5.0f; // nor who is accelerated back by so much (m/s^2) over
constexpr float PULL_S = 0.05f; // some steps.

} // namespace

void Tether::clear() {
	_now = {};
	_next = {};
	_free_s = HELD_S;
	_distance = 0.0f;
	_leaving = 0.0f;
	_pull = 0.0f;
}

void Tether::set(const Vec3 &p_offset) {
	_now = level(p_offset);
	_next = _now;
	_free_s = 0.0f;
	_distance = 0.0f;
	_leaving = 0.0f;
	_pull = 0.0f;
}

void Tether::advance(const Vec3 &p_off, float p_delta_s) {
	_now = _next;
	const Vec3 off = level(p_off);
	float distance = off.length();
	// A body that was flung away is pulled back faster and faster; one that is held is not.
	const float leaving = (distance - _distance) / p_delta_s;
	_pull = _pull + ((_leaving - leaving) / p_delta_s - _pull) * share(p_delta_s, PULL_S);
	_leaving = leaving;
	const bool is_met = distance > SLACK && leaving > -COMING && leaving < FLUNG && _pull < PULLED;
	_free_s += p_delta_s;
	// Who is held anyway need not lean against it until that is felt again.
	if (is_met || (is_held() && distance > REST && leaving < FLUNG)) {
		_free_s = 0.0f;
		_now = _now + off * (1.0f - REST / distance);
		distance = REST;
		_leaving = 0.0f;
		_pull = 0.0f;
	}
	_distance = distance;
	const float fastest = std::min(FAST + FASTER * std::max(_free_s - HELD_S, 0.0f), FASTEST);
	const float speed = std::clamp(BACK * _now.length(), SLOWEST, fastest);
	_next = _now - _now.limited(speed * p_delta_s);
}

bool Tether::is_held() const {
	return _free_s < HELD_S;
}

void Tether::save(ArchiveWriter &p_archive) const {
	p_archive.put(_now);
	p_archive.put(_next);
	p_archive.put(_free_s);
	p_archive.put(_distance);
	p_archive.put(_leaving);
	p_archive.put(_pull);
}

bool Tether::restore(ArchiveReader &p_archive) {
	return p_archive.get(_now) && p_archive.get(_next) && p_archive.get(_free_s) && p_archive.get(_distance) &&
			p_archive.get(_leaving) && p_archive.get(_pull);
}

} // namespace ragdoll
