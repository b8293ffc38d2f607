// SPDX-License-Identifier: MIT
#include "balance/foothold.hpp"

#include "base/calm.hpp"

#include <algorithm>
#include <cmath>

namespace ragdoll {

namespace {

constexpr float SAME_POSITION = 0.015f; // Ground under a point that has moved less (m) is looked at no more.
constexpr float LOOK_AGAIN_S = 0.1f; // And for so long.
constexpr float STEEPEST = 0.7f; // Ground that rises more from ankle to ball is a step, less is a slope.
constexpr float RISER = 0.35f; // The same towards where the toes come: stairs, no slope.
constexpr float NO_STEP = 1e9f;

} // namespace

void Foothold::begin(float p_height) {
	*this = Foothold();
	_height = p_height;
	_firm = p_height;
}

float Foothold::find_rise(const FootholdSettings &p_settings) const {
	// What a foot was lifted over carries nobody while it comes down.
	return std::min(_height, _firm + (_ground.is_loose ? p_settings.loose_rise : 0.0f));
}

void Foothold::look(const Ground &p_ground, const FootholdSettings &p_settings, const FootPlace &p_place) {
	_looked = p_place.ankle;
	_age_s = 0.0f;
	_ground = p_ground.find(p_place.ankle, Ground::STEP);
	_step = -NO_STEP;
	// On stairs the ball of a foot comes onto the next tread, the heel stays behind it.
	const Footing ahead = p_ground.find(p_place.ankle + p_place.ball, Ground::STEP);
	const bool is_step = !ahead.is_loose && ahead.height - _ground.height > STEEPEST * p_place.ball.length();
	if (is_step && ahead.height - p_place.sole < p_place.body + Ground::STEP) {
		_ground = ahead;
	}
	if (p_place.is_up) {
		look_ahead(p_ground, p_settings, p_place, ahead);
	}
}

void Foothold::look_ahead(
		const Ground &p_ground, const FootholdSettings &p_settings, const FootPlace &p_place, const Footing &p_ahead) {
	const Vec3 ball = p_place.ankle + p_place.ball;
	const Footing next = p_ground.find(ball + p_place.further, Ground::STEP);
	const auto is_riser = [&](const Footing &p_seen, const Vec3 &p_at) {
		return p_seen.height - _ground.height > RISER * level(p_at - _looked).length();
	};
	if (!is_riser(next, ball + p_place.further) && !is_riser(p_ahead, ball)) {
		return;
	}
	const auto raise = [&](const Footing &p_seen, float p_over) {
		const float higher = p_seen.height - p_over;
		if (std::isfinite(higher) && (!p_seen.is_loose || higher < _firm + p_settings.loose_climb)) {
			_step = std::max(_step, higher + (p_seen.is_loose ? p_settings.loose_clearance : p_settings.clearance));
		}
	};
	raise(_ground, p_place.sole);
	raise(p_ahead, p_place.toes);
	raise(next, p_place.sole);
}

void Foothold::advance(
		const Ground &p_ground, const FootholdSettings &p_settings, const FootPlace &p_place, float p_delta_s) {
	_age_s += p_delta_s;
	const bool is_old = _age_s > LOOK_AGAIN_S || _ground.moves();
	if (is_old || level(p_place.ankle - _looked).length() > SAME_POSITION) {
		look(p_ground, p_settings, p_place);
	}
	if (!std::isfinite(_ground.height)) {
		return;
	}
	float needed = _ground.height - p_place.sole;
	// Firm ground that is higher than the body is somewhere else by now.
	_firm = !_ground.is_loose && !p_place.is_up ? needed : std::min(_firm, p_place.body);
	if (_ground.is_loose && needed > _firm + p_settings.loose_climb) {
		needed = p_place.body;
	}
	const float wanted = p_place.is_up ? std::max(std::max(p_place.body, needed), _step) : needed;
	const float limited = std::clamp(wanted, p_place.body - p_settings.climb, p_place.body + p_settings.climb);
	float speed = p_settings.speed;
	if (p_place.is_up) {
		// A foot in the air hurries onto a step, or it would strike it.
		speed += p_settings.faster * std::max(limited - std::max(_height, p_place.body), 0.0f);
	}
	_height = towards(_height, limited, speed * p_delta_s);
}

void Foothold::save(ArchiveWriter &p_archive) const {
	for_each_saved(*this, [&](const auto &p_value) { p_archive.put(p_value); });
}

bool Foothold::restore(ArchiveReader &p_archive) {
	bool is_whole = true;
	for_each_saved(*this, [&](auto &r_value) { is_whole = p_archive.get(r_value) && is_whole; });
	return is_whole;
}

} // namespace ragdoll
