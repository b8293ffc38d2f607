// SPDX-License-Identifier: MIT
#include "gait/travel.hpp"

#include <algorithm>
#include <utility>

namespace ragdoll {

Travel::Travel(std::vector<ContactPoint> p_points) :
		_contacts(std::move(p_points)),
		_weights(_contacts.size(), 0.0f),
		_anchors(_contacts.size()),
		_last(_contacts.size()),
		_levels(_contacts.size()) {}

void Travel::reset(const Vec3 &p_root) {
	_root = p_root;
	_velocity = {};
	_flying = false;
	_begun = false;
}

void Travel::step(const GaitInput &p_input) {
	const std::vector<Vec3> &points = *p_input.points;
	bool good = points.size() == _contacts.size() && !points.empty() && p_input.centre.is_finite() &&
			std::isfinite(p_input.delta_s) && p_input.delta_s > 0.0f;
	for (const Vec3 &point : points) {
		good = good && point.is_finite();
	}
	if (!good) {
		return;
	}
	const Vec3 before = _root;
	if (!_begun) {
		_begun = true;
		forget_ground();
		_floor = _root.y + std::min_element(points.begin(), points.end(), [](const Vec3 &p_a, const Vec3 &p_b) {
			return p_a.y < p_b.y;
		})->y;
		begin(p_input);
	} else {
		advance(p_input);
		_velocity = (_root - before) * (1.0f / p_input.delta_s);
	}
	_last = points;
}

void Travel::shift(const Vec3 &p_offset) {
	_root = _root + p_offset;
	_floor += p_offset.y;
	for (Vec3 &anchor : _anchors) {
		anchor = anchor + p_offset;
	}
}

Vec3 Travel::ahead(const std::vector<Vec3> &p_points, float p_delta_s) const {
	Vec3 moved;
	float sum = 0.0f;
	for (std::size_t i = 0; i < _contacts.size() && i < p_points.size(); i++) {
		const Vec3 carried = get_carry(i, _root + _last[i], p_delta_s);
		moved = moved + (_last[i] - p_points[i] + carried) * _weights[i];
		sum += _weights[i];
	}
	return _root + moved + _velocity * (std::max(1.0f - sum, 0.0f) * p_delta_s);
}

Vec3 Travel::get_carry(std::size_t p_point, const Vec3 &p_at, float p_delta_s) const {
	const Footing &footing = _levels[p_point].footing;
	return footing.moves() ? footing.carry(p_at, p_delta_s) : Vec3();
}

Footing Travel::find_footing(const GaitInput &p_input, std::size_t p_point, const Vec3 &p_at) const {
	if (!p_input.shown) {
		return p_input.ground->find(p_at, STEP);
	}
	// The body cannot be in the ground, wherever the target is.
	const float actual = (*p_input.shown)[p_point].y;
	const Vec3 from{ p_at.x, std::max(p_at.y, actual), p_at.z };
	const Footing found = p_input.ground->find(from, STEP);
	const bool steps_up = _contacts[p_point].sole && !found.is_loose;
	if (steps_up || !(found.height > actual + SUNK)) {
		return found;
	}
	return p_input.ground->find({ p_at.x, actual, p_at.z }, SUNK);
}

float Travel::look(const GaitInput &p_input, std::size_t p_point, const Vec3 &p_at) {
	Level &level = _levels[p_point];
	level.age_s += p_input.delta_s;
	const Vec3 moved{ p_at.x - level.at.x, 0.0f, p_at.z - level.at.z };
	if (level.age_s > LOOK_AGAIN_S || moved.length() > SAME_PLACE || level.footing.moves()) {
		level = { p_at, find_footing(p_input, p_point, p_at), 0.0f };
	}
	return level.footing.height;
}

float Travel::find_heights(const GaitInput &p_input, const std::vector<Vec3> &p_points, const Vec3 &p_reference,
		std::vector<float> &r_heights) {
	float likely = NOWHERE; // By the ground that carried the body until now.
	for (std::size_t i = 0; i < _contacts.size(); i++) {
		r_heights[i] = _floor + _contacts[i].radius - p_points[i].y;
		likely = std::max(likely, r_heights[i]);
	}
	float highest = NOWHERE;
	for (std::size_t i = 0; i < _contacts.size(); i++) {
		if (r_heights[i] < likely - STEP) {
			r_heights[i] = NOWHERE;
			_levels[i] = Level(); // What was under it is not what is under it now.
			continue;
		}
		const float level = look(p_input, i, p_reference + p_points[i]);
		r_heights[i] = std::isfinite(level) ? level + _contacts[i].radius - p_points[i].y : NOWHERE;
		highest = std::max(highest, r_heights[i]);
	}
	return highest;
}

void Travel::save(ArchiveWriter &p_archive) const {
	p_archive.put_all(_weights);
	p_archive.put_all(_anchors);
	p_archive.put_all(_last);
	p_archive.put_all(_levels);
	p_archive.put(_floor);
	p_archive.put(_root);
	p_archive.put(_velocity);
	p_archive.put(_flying);
	p_archive.put(_begun);
}

bool Travel::restore(ArchiveReader &p_archive) {
	return p_archive.get_all(_weights) && p_archive.get_all(_anchors) && p_archive.get_all(_last) &&
			p_archive.get_all(_levels) && p_archive.get(_floor) && p_archive.get(_root) && p_archive.get(_velocity) &&
			p_archive.get(_flying) && p_archive.get(_begun);
}

} // namespace ragdoll
