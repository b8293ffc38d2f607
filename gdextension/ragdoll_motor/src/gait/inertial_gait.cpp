// SPDX-License-Identifier: MIT
#include "gait/inertial_gait.hpp"

#include "calm.hpp"

#include <algorithm>
#include <utility>

namespace ragdoll {

namespace {

constexpr float PI = 3.14159265f;
constexpr float NEVER = 1e9f;
constexpr float SURE = 0.05f; // Weight of a point from which it can be anchored.
constexpr float NEAR_STEP = 0.02f; // Points so little (m) above the lowest ground are on it.

Vec3 level(const Vec3 &p_vector) {
	return { p_vector.x, 0.0f, p_vector.z };
}

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
	_flown_s = 1.0f;
	for (std::size_t i = 0; i < _contacts.size(); i++) {
		const Vec3 point = points[i] - p_input.centre;
		_filters[i] = { { point, point }, { point, point } };
		_smooth[i] = point;
		_footing[i] = point;
		_locks[i] = 0;
		_weights[i] = 0.0f;
	}
	const float highest = find_heights(p_input, _smooth, _centre, _heights);
	if (highest > NOWHERE) {
		_centre.y = highest;
		const auto stands = [&](float p_height) { return p_height > highest - settings.clearance; };
		const float count = float(std::count_if(_heights.begin(), _heights.end(), stands));
		for (std::size_t i = 0; i < _contacts.size(); i++) {
			_weights[i] = stands(_heights[i]) ? 1.0f / count : 0.0f;
		}
	}
	_root = _centre - p_input.centre;
}

void InertialGait::filter(const GaitInput &p_input) {
	const float k = std::tan(PI * std::min(settings.cutoff * p_input.delta_s, 0.45f));
	const float scale = 1.0f / (1.0f + std::sqrt(2.0f) * k + k * k);
	const float b = k * k * scale;
	const float a1 = 2.0f * (k * k - 1.0f) * scale;
	const float a2 = (1.0f - std::sqrt(2.0f) * k + k * k) * scale;
	const float rate = 1.0f / p_input.delta_s;
	for (std::size_t i = 0; i < _contacts.size(); i++) {
		Filter &state = _filters[i];
		const Vec3 point = (*p_input.points)[i] - p_input.centre;
		const Vec3 result =
				(point + state.input[0] * 2.0f + state.input[1]) * b - state.output[0] * a1 - state.output[1] * a2;
		state.input[1] = state.input[0];
		state.input[0] = point;
		state.output[1] = state.output[0];
		state.output[0] = result;
		_implied[i] = (_smooth[i] - result) * rate;
		_smooth[i] = result;
		_footing[i] = point; // Heights need no low-pass, which would come late.
	}
}

float InertialGait::find_support(const GaitInput &p_input) {
	const Vec3 coming = _centre + _drift * p_input.delta_s;
	if (find_heights(p_input, _footing, coming, _heights) <= NOWHERE) {
		return NOWHERE;
	}
	float lowest = -NOWHERE;
	for (const float height : _heights) {
		lowest = height > NOWHERE ? std::min(lowest, height) : lowest;
	}
	// A step that would lift the body all at once is not what the foot stands on, unless there is
	// nothing else.
	const float gate = std::max(coming.y + settings.step_up, lowest + NEAR_STEP);
	const bool all = _flying || _flown_s < settings.settle_s;
	float best = NOWHERE;
	for (float &height : _heights) {
		height = all || height < gate ? height : NOWHERE;
		best = std::max(best, height);
	}
	return best;
}

bool InertialGait::is_falling(const GaitInput &p_input, float p_height) {
	const float delta = p_input.delta_s;
	const float path = _centre.y + (_drift.y + 0.5f * p_input.gravity.y * delta) * delta;
	if (_flying || p_height <= NOWHERE) {
		return path > p_height;
	}
	return _drift.y > settings.takeoff && path > p_height + settings.takeoff_gap * std::min(60.0f * delta, 1.0f);
}

void InertialGait::weigh(float p_height, float p_delta_s) {
	// The shorter the step, the less likely is it that another limb stands in the next one.
	const float persistence = settings.persistence * std::clamp(1.0f / (60.0f * p_delta_s), 1.0f, 2.0f);
	// A limb that stood is likely to stand on, be it with another of its points.
	float least = settings.air;
	for (std::size_t i = 0; i < _contacts.size(); i++) {
		const float clear = p_height - _heights[i];
		if (_heights[i] <= NOWHERE || clear > REACH) {
			_costs[i] = NEVER;
			continue;
		}
		float stood = 0.0f;
		for (std::size_t j = 0; j < _contacts.size(); j++) {
			stood += _contacts[j].limb == _contacts[i].limb ? _weights[j] : 0.0f;
		}
		const float off = level(_implied[i] - _drift).length() / settings.contradiction;
		const float above = clear / settings.clearance;
		_costs[i] = above * above + off * off - persistence * stood;
		least = std::min(least, _costs[i]);
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

void InertialGait::walk(const GaitInput &p_input, float p_height) {
	Vec3 mean = level(_drift) * (1.0f - _standing);
	for (std::size_t i = 0; i < _contacts.size(); i++) {
		mean = mean + _implied[i] * _weights[i];
	}
	const float delta = p_input.delta_s;
	// Hardly anything stands: the body's own rise or fall says more than the points do.
	const float rising = _standing > 0.3f ? mean.y / _standing : (p_height - _centre.y) / delta;
	_centre = _centre + level(mean) * delta;
	_centre.y = p_height;
	const float across = share(delta, settings.follow_s);
	const float up = share(delta, settings.follow_up_s);
	_drift.x += across * (mean.x - _drift.x);
	_drift.z += across * (mean.z - _drift.z);
	_drift.y += up * (rising - _drift.y);
	_flown_s += delta;
	hold(p_input);
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
		}
		away = away + (_anchors[i] - position) * _weights[i];
		sum += _weights[i];
	}
	if (sum > 0.0f) {
		_centre = _centre + level(away) * (share(p_input.delta_s, settings.hold_s) / sum);
	}
}

void InertialGait::fly(const GaitInput &p_input) {
	const float delta = p_input.delta_s;
	_centre = _centre + _drift * delta + p_input.gravity * (0.5f * delta * delta);
	_drift = _drift + p_input.gravity * delta;
	_flown_s = 0.0f;
	std::fill(_weights.begin(), _weights.end(), 0.0f);
	std::fill(_locks.begin(), _locks.end(), std::uint8_t(0));
}

void InertialGait::advance(const GaitInput &p_input) {
	filter(p_input);
	const float height = find_support(p_input);
	_flying = is_falling(p_input, height);
	if (_flying) {
		fly(p_input);
	} else {
		weigh(height, p_input.delta_s);
		walk(p_input, height);
	}
	finish(p_input);
}

void InertialGait::finish(const GaitInput &p_input) {
	_root = _centre - p_input.centre;
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
	p_archive.put(_flown_s);
}

bool InertialGait::restore(ArchiveReader &p_archive) {
	return Travel::restore(p_archive) && p_archive.get_all(_filters) && p_archive.get_all(_smooth) &&
			p_archive.get_all(_locks) && p_archive.get(_centre) && p_archive.get(_drift) && p_archive.get(_flown_s);
}

} // namespace ragdoll
