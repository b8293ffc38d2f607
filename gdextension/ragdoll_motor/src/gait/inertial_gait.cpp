// SPDX-License-Identifier: MIT
#include "inertial_gait.hpp"

#include "../calm.hpp"

#include <algorithm>
#include <utility>

namespace ragdoll {

namespace {

constexpr float GRAVITY = 9.81f; // m/s^2
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
		filters(contacts.size()),
		smooth(contacts.size()),
		footing(contacts.size()),
		implied(contacts.size()),
		heights(contacts.size(), 0.0f),
		costs(contacts.size(), 0.0f),
		locks(contacts.size(), 0) {}

void InertialGait::shift(const Vec3 &p_offset) {
	Travel::shift(p_offset);
	centre = centre + p_offset;
}

void InertialGait::begin(const GaitInput &p_input) {
	const std::vector<Vec3> &points = *p_input.points;
	centre = root + p_input.centre;
	drift = {};
	flown_s = 1.0f;
	for (std::size_t i = 0; i < contacts.size(); i++) {
		const Vec3 point = points[i] - p_input.centre;
		filters[i] = { { point, point }, { point, point } };
		smooth[i] = point;
		footing[i] = point;
		locks[i] = 0;
		weights[i] = 0.0f;
	}
	const float highest = find_heights(p_input, smooth, centre, heights);
	if (highest > NOWHERE) {
		centre.y = highest;
		const auto stands = [&](float p_height) { return p_height > highest - settings.clearance; };
		const float count = float(std::count_if(heights.begin(), heights.end(), stands));
		for (std::size_t i = 0; i < contacts.size(); i++) {
			weights[i] = stands(heights[i]) ? 1.0f / count : 0.0f;
		}
	}
	root = centre - p_input.centre;
}

void InertialGait::filter(const GaitInput &p_input) {
	const float k = std::tan(PI * std::min(settings.cutoff * p_input.delta_s, 0.45f));
	const float scale = 1.0f / (1.0f + std::sqrt(2.0f) * k + k * k);
	const float b = k * k * scale;
	const float a1 = 2.0f * (k * k - 1.0f) * scale;
	const float a2 = (1.0f - std::sqrt(2.0f) * k + k * k) * scale;
	const float rate = 1.0f / p_input.delta_s;
	for (std::size_t i = 0; i < contacts.size(); i++) {
		Filter &state = filters[i];
		const Vec3 point = (*p_input.points)[i] - p_input.centre;
		const Vec3 result =
				(point + state.input[0] * 2.0f + state.input[1]) * b - state.output[0] * a1 - state.output[1] * a2;
		state.input[1] = state.input[0];
		state.input[0] = point;
		state.output[1] = state.output[0];
		state.output[0] = result;
		implied[i] = (smooth[i] - result) * rate;
		smooth[i] = result;
		footing[i] = point; // Heights need no low-pass, which would come late.
	}
}

float InertialGait::find_support(const GaitInput &p_input) {
	const Vec3 coming = centre + drift * p_input.delta_s;
	if (find_heights(p_input, footing, coming, heights) <= NOWHERE) {
		return NOWHERE;
	}
	float lowest = -NOWHERE;
	for (const float height : heights) {
		lowest = height > NOWHERE ? std::min(lowest, height) : lowest;
	}
	// A step that would lift the body all at once is not what the foot stands on, unless there is
	// nothing else.
	const float gate = std::max(coming.y + settings.step_up, lowest + NEAR_STEP);
	const bool all = flying || flown_s < settings.settle_s;
	float best = NOWHERE;
	for (float &height : heights) {
		height = all || height < gate ? height : NOWHERE;
		best = std::max(best, height);
	}
	return best;
}

bool InertialGait::is_falling(float p_height, float p_delta_s) {
	const float path = centre.y + (drift.y - 0.5f * GRAVITY * p_delta_s) * p_delta_s;
	if (flying || p_height <= NOWHERE) {
		return path > p_height;
	}
	return drift.y > settings.takeoff && path > p_height + settings.takeoff_gap * std::min(60.0f * p_delta_s, 1.0f);
}

void InertialGait::weigh(float p_height, float p_delta_s) {
	// The shorter the step, the less likely is it that another limb stands in the next one.
	const float persistence = settings.persistence * std::clamp(1.0f / (60.0f * p_delta_s), 1.0f, 2.0f);
	// A limb that stood is likely to stand on, be it with another of its points.
	float least = settings.air;
	for (std::size_t i = 0; i < contacts.size(); i++) {
		const float clear = p_height - heights[i];
		if (heights[i] <= NOWHERE || clear > REACH) {
			costs[i] = NEVER;
			continue;
		}
		float stood = 0.0f;
		for (std::size_t j = 0; j < contacts.size(); j++) {
			stood += contacts[j].limb == contacts[i].limb ? weights[j] : 0.0f;
		}
		const float off = level(implied[i] - drift).length() / settings.contradiction;
		const float above = clear / settings.clearance;
		costs[i] = above * above + off * off - persistence * stood;
		least = std::min(least, costs[i]);
	}
	const auto odds = [&](float p_cost) { return std::exp(-0.5f * (p_cost - least) / settings.sharpness); };
	float sum = odds(settings.air);
	for (const float cost : costs) {
		sum += cost < NEVER ? odds(cost) : 0.0f;
	}
	standing = 0.0f;
	for (std::size_t i = 0; i < contacts.size(); i++) {
		weights[i] = costs[i] < NEVER ? odds(costs[i]) / sum : 0.0f;
		standing += weights[i];
	}
}

void InertialGait::walk(const GaitInput &p_input, float p_height) {
	Vec3 mean = level(drift) * (1.0f - standing);
	for (std::size_t i = 0; i < contacts.size(); i++) {
		mean = mean + implied[i] * weights[i];
	}
	const float delta = p_input.delta_s;
	// Hardly anything stands: the body's own way up or down says more than the points do.
	const float rising = standing > 0.3f ? mean.y / standing : (p_height - centre.y) / delta;
	centre = centre + level(mean) * delta;
	centre.y = p_height;
	const float across = share(delta, settings.follow_s);
	const float up = share(delta, settings.follow_up_s);
	drift.x += across * (mean.x - drift.x);
	drift.z += across * (mean.z - drift.z);
	drift.y += up * (rising - drift.y);
	flown_s += delta;
	hold(p_input);
}

void InertialGait::hold(const GaitInput &p_input) {
	const float surest = *std::max_element(weights.begin(), weights.end());
	Vec3 away;
	float sum = 0.0f;
	for (std::size_t i = 0; i < contacts.size(); i++) {
		const Vec3 place = centre + smooth[i];
		const float from = locks[i] != 0 ? settings.release_below : settings.hold_from;
		if (weights[i] < from * surest || surest < SURE) {
			locks[i] = 0;
			continue;
		}
		if (locks[i] == 0) {
			locks[i] = 1;
			anchors[i] = place;
		}
		away = away + (anchors[i] - place) * weights[i];
		sum += weights[i];
	}
	if (sum > 0.0f) {
		centre = centre + level(away) * (share(p_input.delta_s, settings.hold_s) / sum);
	}
}

void InertialGait::fly(const GaitInput &p_input) {
	const float delta = p_input.delta_s;
	centre = centre + drift * delta;
	centre.y -= 0.5f * GRAVITY * delta * delta;
	drift.y -= GRAVITY * delta;
	flown_s = 0.0f;
	std::fill(weights.begin(), weights.end(), 0.0f);
	std::fill(locks.begin(), locks.end(), std::uint8_t(0));
}

void InertialGait::advance(const GaitInput &p_input) {
	filter(p_input);
	const float height = find_support(p_input);
	flying = is_falling(height, p_input.delta_s);
	if (flying) {
		fly(p_input);
	} else {
		weigh(height, p_input.delta_s);
		walk(p_input, height);
	}
	finish(p_input);
}

void InertialGait::finish(const GaitInput &p_input) {
	root = centre - p_input.centre;
	float support = NOWHERE;
	for (std::size_t i = 0; i < contacts.size() && !flying; i++) {
		if (heights[i] > support) {
			support = heights[i];
			floor = heights[i] - contacts[i].radius + footing[i].y;
		}
	}
}

void InertialGait::save(ArchiveWriter &p_archive) const {
	Travel::save(p_archive);
	p_archive.put_all(filters);
	p_archive.put_all(smooth);
	p_archive.put_all(locks);
	p_archive.put(centre);
	p_archive.put(drift);
	p_archive.put(flown_s);
}

bool InertialGait::restore(ArchiveReader &p_archive) {
	return Travel::restore(p_archive) && p_archive.get_all(filters) && p_archive.get_all(smooth) &&
			p_archive.get_all(locks) && p_archive.get(centre) && p_archive.get(drift) && p_archive.get(flown_s);
}

} // namespace ragdoll
