// SPDX-License-Identifier: MIT
#include "gait/inertial_gait.hpp"

#include "base/calm.hpp"

#include <algorithm>
#include <utility>

namespace ragdoll {

namespace {

constexpr float NEVER = 1e9f;
constexpr float SURE = 0.05f; // Weight of a point from which it can be anchored.
constexpr float LOWEST = 0.03f; // Points of the pose that are no higher above the lowest (m) may stand.
constexpr float LOW = 0.09f; // The same for a foot that is about to strike: who walks has one, who flies has none.
constexpr float LIKELY = 0.2f; // Share of the surest point's weight from which the body stands on a point.
constexpr int FIRST_LOOKS = 6; // Steps that ground is looked for above who is told to begin in it.
constexpr float FIRM = 0.3f; // Sum of weights from which the points' own rise counts.

} // namespace

InertialGait::InertialGait(std::vector<ContactPoint> p_points) :
		Travel(std::move(p_points)),
		_filters(_contacts.size()),
		_smooth(_contacts.size()),
		_footing(_contacts.size()),
		_implied(_contacts.size()),
		_heights(_contacts.size(), 0.0f),
		_costs(_contacts.size(), 0.0f),
		_locks(_contacts.size(), 0) {}

void InertialGait::shift(const Vec3 &p_offset) {
	Travel::shift(p_offset);
	_centre = _centre + p_offset;
}

void InertialGait::begin(const GaitInput &p_input) {
	const std::vector<Vec3> &points = *p_input.points;
	_centre = _root + p_input.centre;
	_drift = {};
	_lift = 0.0f;
	_misfit = 0.0f;
	_doubt = settings.unknown * settings.unknown;
	_tall = NOWHERE;
	takeoff.clear();
	for (std::size_t i = 0; i < _contacts.size(); i++) {
		const Vec3 point = points[i] - p_input.centre;
		_filters[i] = { { point, point }, { point, point } };
		_smooth[i] = point;
		_footing[i] = point;
		_locks[i] = 0;
		_weights[i] = 0.0f;
		_tall = std::max(_tall, _contacts[i].radius - point.y);
	}
	const float highest = find_first_support(p_input);
	_flying = highest <= NOWHERE;
	if (!_flying) {
		_centre.y = highest;
		const auto stands = [&](float p_height) { return p_height > highest - settings.clearance; };
		const float count = float(std::count_if(_heights.begin(), _heights.end(), stands));
		for (std::size_t i = 0; i < _contacts.size(); i++) {
			_weights[i] = stands(_heights[i]) ? 1.0f / count : 0.0f;
		}
	}
	_root = _centre - p_input.centre;
}

float InertialGait::find_first_support(const GaitInput &p_input) {
	float highest = find_heights(p_input, _smooth, _centre, _heights);
	GaitInput blind = p_input;
	blind.shown = nullptr;
	for (int up = 1; highest <= NOWHERE && up <= FIRST_LOOKS; up++) {
		forget_ground();
		highest = find_heights(blind, _smooth, _centre + Vec3{ 0.0f, STEP * float(up), 0.0f }, _heights);
	}
	return highest;
}

Vec3 InertialGait::slip(const GaitInput &p_input, std::size_t p_point, const Vec3 &p_at) const {
	const Vec3 carried = get_carry(p_point, p_at, p_input.delta_s) * (1.0f / p_input.delta_s);
	if (!p_input.turns) {
		return carried;
	}
	const ContactPoint &contact = _contacts[p_point];
	return carried + (*p_input.turns)[std::size_t(contact.limb)].cross({ 0.0f, contact.radius, 0.0f });
}

void InertialGait::filter(const GaitInput &p_input) {
	const float k = std::tan(PI * std::min(settings.cutoff * p_input.delta_s, 0.45f));
	const float scale = 1.0f / (1.0f + std::sqrt(2.0f) * k + k * k);
	const float b = k * k * scale;
	const float a1 = 2.0f * (k * k - 1.0f) * scale;
	const float a2 = (1.0f - std::sqrt(2.0f) * k + k * k) * scale;
	const float rate = 1.0f / p_input.delta_s;
	_tall = NOWHERE;
	for (std::size_t i = 0; i < _contacts.size(); i++) {
		Filter &state = _filters[i];
		const Vec3 point = (*p_input.points)[i] - p_input.centre;
		const Vec3 result =
				(point + state.input[0] * 2.0f + state.input[1]) * b - state.output[0] * a1 - state.output[1] * a2;
		state.input[1] = state.input[0];
		state.input[0] = point;
		state.output[1] = state.output[0];
		state.output[0] = result;
		_implied[i] = (_smooth[i] - result) * rate + slip(p_input, i, _centre + _smooth[i]);
		_smooth[i] = result;
		_footing[i] = point; // Heights need no low-pass, which would come late.
		_tall = std::max(_tall, _contacts[i].radius - point.y);
	}
}

float InertialGait::find_support(const GaitInput &p_input) {
	return find_heights(p_input, _footing, _centre + _drift * p_input.delta_s, _heights);
}

float InertialGait::find_slide() const {
	float least = NEVER;
	for (std::size_t i = 0; i < _contacts.size(); i++) {
		if (_contacts[i].radius - _footing[i].y > _tall - LOW) {
			least = std::min(least, level(_implied[i] - _drift).length());
		}
	}
	return least;
}

float InertialGait::cost_of(std::size_t p_point, float p_expected, float p_persistence) const {
	// On the wearer's own floor, or on the world's.
	const float over_floor = _tall + takeoff.get_gap() - (_contacts[p_point].radius - _footing[p_point].y);
	const float over_ground = std::max(p_expected - _heights[p_point], 0.0f);
	const float clear = std::min(over_floor, over_ground);
	if (_heights[p_point] <= NOWHERE || clear > REACH) {
		return NEVER;
	}
	// A limb that stood is likely to stand on, be it with another of its points.
	float stood = 0.0f;
	for (std::size_t j = 0; j < _contacts.size(); j++) {
		stood += _contacts[j].limb == _contacts[p_point].limb ? _weights[j] : 0.0f;
	}
	const float off = level(_implied[p_point] - _drift).length();
	const float above = clear / settings.clearance;
	return above * above + off * off / (settings.contradiction * settings.contradiction + _doubt) -
			p_persistence * stood;
}

void InertialGait::weigh(const GaitInput &p_input, float p_highest) {
	// The shorter the step, the less likely is it that another limb stands in the next one.
	const float persistence = settings.persistence * std::clamp(1.0f / (60.0f * p_input.delta_s), 1.0f, 2.0f);
	const float expected = std::max(_centre.y + _drift.y * p_input.delta_s, p_highest - SUNK);
	float least = settings.air;
	for (std::size_t i = 0; i < _contacts.size(); i++) {
		_costs[i] = cost_of(i, expected, persistence);
		least = std::min(least, _costs[i]);
	}
	// With a wrong velocity every swinging foot agrees and no standing one: a trap that walks backward.
	_misfit += share(p_input.delta_s, settings.misfit_s) * (std::max(least, 0.0f) - _misfit);
	if (_misfit > settings.misfit) {
		_misfit = 0.0f;
		_doubt = settings.unknown * settings.unknown;
	}
	const auto odds = [&](float p_cost) { return std::exp(-0.5f * (p_cost - least) / settings.sharpness); };
	float sum = odds(settings.air);
	for (const float cost : _costs) {
		sum += cost < NEVER ? odds(cost) : 0.0f;
	}
	_standing = 0.0f;
	for (std::size_t i = 0; i < _contacts.size(); i++) {
		_weights[i] = _costs[i] < NEVER ? odds(_costs[i]) / sum : 0.0f;
		_standing += _weights[i];
	}
}

float InertialGait::find_standing_height() const {
	const float surest = *std::max_element(_weights.begin(), _weights.end());
	float height = 0.0f;
	float highest = NOWHERE;
	for (std::size_t i = 0; i < _contacts.size(); i++) {
		height += _weights[i] > 0.0f ? _weights[i] * _heights[i] : 0.0f;
		highest = _weights[i] > LIKELY * surest ? std::max(highest, _heights[i]) : highest;
	}
	if (_standing < SURE) {
		return NOWHERE;
	}
	// Who stands on several points stands on the highest, unless pose and ground disagree on which that is.
	const float mean = height / _standing;
	return highest - mean < LOWEST ? highest : mean;
}

void InertialGait::walk(const GaitInput &p_input) {
	Vec3 mean = _drift * (1.0f - _standing);
	for (std::size_t i = 0; i < _contacts.size(); i++) {
		mean = mean + _implied[i] * _weights[i];
	}
	const float delta = p_input.delta_s;
	_centre = _centre + level(mean) * delta;
	_doubt += (settings.wander + (settings.lost - settings.wander) * (1.0f - _standing)) * delta;
	if (_standing > 0.0f) {
		// The Kalman filter of a velocity that wanders; what hardly stands says hardly anything.
		const float gain = _doubt / (_doubt + settings.scatter * settings.scatter / _standing);
		const Vec3 off = level(mean - _drift) * (gain / _standing);
		_drift = _drift + off;
		_doubt *= 1.0f - gain;
	}
	float rising = 0.0f;
	float lifted = 0.0f;
	for (std::size_t i = 0; i < _contacts.size(); i++) {
		rising += _implied[i].y * _weights[i];
		lifted += get_carry(i, _centre, delta).y / delta * _weights[i];
	}
	const bool firm = _standing > FIRM;
	climb(firm ? rising / _standing : _drift.y, firm ? lifted / _standing : _lift, delta);
	hold(p_input);
}

void InertialGait::climb(float p_rising, float p_lifted, float p_delta_s) {
	const float wanted = find_standing_height();
	const float before = _centre.y;
	_centre.y += p_rising * p_delta_s;
	if (wanted > NOWHERE) {
		const float off = wanted - _centre.y;
		const float most = std::max(settings.adapt * p_delta_s, share(p_delta_s, settings.adapt_s) * std::fabs(off));
		_centre.y += std::clamp(off, -most, most);
		if (off < -settings.drop) {
			_flying = true;
			_centre.y = before + p_rising * p_delta_s;
		}
	}
	const float follow = share(p_delta_s, settings.follow_up_s);
	_drift.y += follow * (p_rising - _drift.y);
	_lift += follow * (p_lifted - _lift);
}

void InertialGait::hold(const GaitInput &p_input) {
	const float surest = *std::max_element(_weights.begin(), _weights.end());
	Vec3 away;
	float sum = 0.0f;
	for (std::size_t i = 0; i < _contacts.size(); i++) {
		const Vec3 position = _centre + _smooth[i];
		const float from = _locks[i] != 0 ? settings.release_below : settings.hold_from;
		if (_weights[i] < from * surest || surest < SURE) {
			_locks[i] = 0;
			continue;
		}
		if (_locks[i] == 0) {
			_locks[i] = 1;
			_anchors[i] = position;
		} else {
			_anchors[i] = _anchors[i] + slip(p_input, i, _anchors[i]) * p_input.delta_s;
		}
		away = away + (_anchors[i] - position) * _weights[i];
		sum += _weights[i];
	}
	if (sum > 0.0f) {
		_centre = _centre + level(away) * (share(p_input.delta_s, settings.hold_s) / sum);
	}
}

void InertialGait::fly(const GaitInput &p_input, float p_height) {
	const float delta = p_input.delta_s;
	_centre = _centre + _drift * delta + p_input.gravity * (0.5f * delta * delta);
	_drift = _drift + p_input.gravity * delta;
	_flying = _centre.y > p_height;
	std::fill(_weights.begin(), _weights.end(), 0.0f);
	std::fill(_locks.begin(), _locks.end(), std::uint8_t(0));
}

void InertialGait::advance(const GaitInput &p_input) {
	const float before = _tall;
	filter(p_input);
	const float height = find_support(p_input);
	if (!_flying && takeoff.advance(_tall, _drift.y - _lift, find_slide(), -p_input.gravity.y, p_input.delta_s)) {
		_centre.y += _tall - before + takeoff.get_gap();
		_drift.y = takeoff.get_speed() + _lift;
		_flying = true;
	}
	_flying = _flying || height <= NOWHERE;
	if (_flying) {
		takeoff.clear();
		fly(p_input, height);
	} else {
		weigh(p_input, height);
		walk(p_input);
	}
	finish();
	_root = _centre - p_input.centre;
}

void InertialGait::finish() {
	float support = NOWHERE;
	for (std::size_t i = 0; i < _contacts.size() && !_flying; i++) {
		if (_heights[i] > support) {
			support = _heights[i];
			_floor = _heights[i] - _contacts[i].radius + _footing[i].y;
		}
	}
}

void InertialGait::save(ArchiveWriter &p_archive) const {
	Travel::save(p_archive);
	p_archive.put_all(_filters);
	p_archive.put_all(_smooth);
	p_archive.put_all(_locks);
	p_archive.put(_centre);
	p_archive.put(_drift);
	p_archive.put(_lift);
	p_archive.put(_doubt);
	p_archive.put(_misfit);
	p_archive.put(_tall);
	takeoff.save(p_archive);
}

bool InertialGait::restore(ArchiveReader &p_archive) {
	return Travel::restore(p_archive) && p_archive.get_all(_filters) && p_archive.get_all(_smooth) &&
			p_archive.get_all(_locks) && p_archive.get(_centre) && p_archive.get(_drift) && p_archive.get(_lift) &&
			p_archive.get(_doubt) && p_archive.get(_misfit) && p_archive.get(_tall) && takeoff.restore(p_archive);
}

} // namespace ragdoll
