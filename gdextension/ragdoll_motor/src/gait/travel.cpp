// SPDX-License-Identifier: MIT
#include "travel.hpp"

#include <algorithm>
#include <utility>

namespace ragdoll {

Travel::Travel(std::vector<ContactPoint> p_points) :
		contacts(std::move(p_points)),
		weights(contacts.size(), 0.0f),
		anchors(contacts.size()),
		last(contacts.size()),
		levels(contacts.size()) {}

void Travel::reset(const Vec3 &p_root) {
	root = p_root;
	velocity = {};
	flying = false;
	begun = false;
}

void Travel::step(const GaitInput &p_input) {
	const std::vector<Vec3> &points = *p_input.points;
	bool good = points.size() == contacts.size() && !points.empty() && p_input.centre.is_finite() &&
			std::isfinite(p_input.delta_s) && p_input.delta_s > 0.0f;
	for (const Vec3 &point : points) {
		good = good && point.is_finite();
	}
	if (!good) {
		return;
	}
	const Vec3 before = root;
	if (!begun) {
		begun = true;
		std::fill(levels.begin(), levels.end(), Level());
		floor = root.y + std::min_element(points.begin(), points.end(), [](const Vec3 &p_a, const Vec3 &p_b) {
			return p_a.y < p_b.y;
		})->y;
		begin(p_input);
	} else {
		advance(p_input);
		velocity = (root - before) * (1.0f / p_input.delta_s);
	}
	last = points;
}

void Travel::shift(const Vec3 &p_offset) {
	root = root + p_offset;
	floor += p_offset.y;
	for (Vec3 &anchor : anchors) {
		anchor = anchor + p_offset;
	}
}

Vec3 Travel::ahead(const std::vector<Vec3> &p_points, float p_delta_s) const {
	Vec3 moved;
	float sum = 0.0f;
	for (std::size_t i = 0; i < contacts.size() && i < p_points.size(); i++) {
		moved = moved + (last[i] - p_points[i]) * weights[i];
		sum += weights[i];
	}
	return root + moved + velocity * (std::max(1.0f - sum, 0.0f) * p_delta_s);
}

float Travel::look(const GaitInput &p_input, std::size_t p_point, const Vec3 &p_at) {
	Level &level = levels[p_point];
	level.age_s += p_input.delta_s;
	const Vec3 moved{ p_at.x - level.at.x, 0.0f, p_at.z - level.at.z };
	if (level.age_s > LOOK_AGAIN_S || moved.length() > SAME_PLACE) {
		level = { p_at, p_input.ground->height(p_at), 0.0f };
	}
	return level.height;
}

float Travel::find_heights(const GaitInput &p_input, const std::vector<Vec3> &p_points, const Vec3 &p_reference,
		std::vector<float> &r_heights) {
	float likely = NOWHERE; // By the ground that carried the body until now.
	for (std::size_t i = 0; i < contacts.size(); i++) {
		r_heights[i] = floor + contacts[i].radius - p_points[i].y;
		likely = std::max(likely, r_heights[i]);
	}
	float highest = NOWHERE;
	for (std::size_t i = 0; i < contacts.size(); i++) {
		if (r_heights[i] < likely - STEP) {
			r_heights[i] = NOWHERE;
			continue;
		}
		const float level = look(p_input, i, p_reference + p_points[i]);
		r_heights[i] = std::isfinite(level) ? level + contacts[i].radius - p_points[i].y : NOWHERE;
		highest = std::max(highest, r_heights[i]);
	}
	return highest;
}

void Travel::save(ArchiveWriter &p_archive) const {
	p_archive.put_all(weights);
	p_archive.put_all(anchors);
	p_archive.put_all(last);
	p_archive.put_all(levels);
	p_archive.put(floor);
	p_archive.put(root);
	p_archive.put(velocity);
	p_archive.put(flying);
	p_archive.put(begun);
}

bool Travel::restore(ArchiveReader &p_archive) {
	return p_archive.get_all(weights) && p_archive.get_all(anchors) && p_archive.get_all(last) &&
			p_archive.get_all(levels) && p_archive.get(floor) && p_archive.get(root) && p_archive.get(velocity) &&
			p_archive.get(flying) && p_archive.get(begun);
}

} // namespace ragdoll
