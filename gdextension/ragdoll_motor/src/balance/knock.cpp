// SPDX-License-Identifier: MIT
#include "balance/knock.hpp"

#include "base/calm.hpp"

#include <algorithm>

namespace ragdoll {

namespace {

constexpr float USUAL_S = 0.15f; // What changes more slowly is no knock.

} // namespace

void Knock::advance(const Vec3 &p_velocity, const Vec3 &p_error, float p_delta_s) {
	_left_s = std::max(_left_s - p_delta_s, 0.0f);
	const Vec3 moved = p_velocity - _usual_velocity;
	const Vec3 off = p_error - _usual_error;
	// Where the motion itself jumps, the body is not knocked but follows it.
	const bool follows = (moved - off).length() > 0.5f * settings.speed;
	if (!follows && std::min(moved.length(), off.length()) > settings.speed) {
		_left_s = settings.duration_s;
	}
	const float part = share(p_delta_s, USUAL_S);
	_usual_error = _usual_error + off * part;
	_usual_velocity = _usual_velocity + moved * part;
}

void Knock::rest(const Vec3 &p_velocity, const Vec3 &p_error) {
	_left_s = 0.0f;
	_usual_velocity = p_velocity;
	_usual_error = p_error;
}

void Knock::save(ArchiveWriter &p_archive) const {
	p_archive.put(_usual_error);
	p_archive.put(_usual_velocity);
	p_archive.put(_left_s);
}

bool Knock::restore(ArchiveReader &p_archive) {
	return p_archive.get(_usual_error) && p_archive.get(_usual_velocity) && p_archive.get(_left_s);
}

} // namespace ragdoll
