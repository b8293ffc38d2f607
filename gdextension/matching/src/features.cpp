// SPDX-License-Identifier: MIT
#include "features.hpp"

#include <algorithm>
#include <cmath>

namespace matching {

namespace {

/// A clip's way from its beginning.
struct Path {
	std::vector<float> x;
	std::vector<float> z;
	std::vector<float> heading;
};

Path path_of(const Clip &p_clip) {
	Path path;
	float x = 0.0f;
	float z = 0.0f;
	float heading = 0.0f;
	const int ahead = int(std::lround(AHEAD.back() * RATE)) + 1;
	for (int i = 0; i < int(p_clip.frames.size()) + ahead; i++) {
		path.x.push_back(x);
		path.z.push_back(z);
		path.heading.push_back(heading);
		// Beyond its end it goes straight on.
		const bool is_beyond = i >= int(p_clip.frames.size());
		const ClipFrame &frame = p_clip.frames[std::min(std::size_t(i), p_clip.frames.size() - 1)];
		const float middle = heading + (is_beyond ? 0.0f : 0.5f * frame.turn_rate / RATE);
		x += (frame.velocity_z * std::sin(middle) + frame.velocity_x * std::cos(middle)) / RATE;
		z += (frame.velocity_z * std::cos(middle) - frame.velocity_x * std::sin(middle)) / RATE;
		heading += is_beyond ? 0.0f : frame.turn_rate / RATE;
	}
	return path;
}

void put(const Vec3 &p_vector, std::size_t p_at, Features &r_row) {
	r_row[p_at] = p_vector.x;
	r_row[p_at + 1] = p_vector.y;
	r_row[p_at + 2] = p_vector.z;
}

} // namespace

void put_way(const Way &p_way, float p_turn, Features &r_row) {
	const float cosine = std::cos(p_turn);
	const float sine = std::sin(p_turn);
	for (std::size_t i = 0; i < AHEAD.size(); i++) {
		r_row[PLACES + 2 * i] = p_way.x[i] * cosine + p_way.z[i] * sine;
		r_row[PLACES + 2 * i + 1] = p_way.z[i] * cosine - p_way.x[i] * sine;
		r_row[DIRECTIONS + 2 * i] = std::sin(p_way.heading[i]);
		r_row[DIRECTIONS + 2 * i + 1] = std::cos(p_way.heading[i]);
	}
}

std::vector<Features> features_of(const Clip &p_clip) {
	std::vector<Features> rows(p_clip.frames.size());
	if (p_clip.frames.empty()) {
		return rows;
	}
	const Path path = path_of(p_clip);
	for (std::size_t i = 0; i < rows.size(); i++) {
		Way way;
		for (std::size_t k = 0; k < AHEAD.size(); k++) {
			const std::size_t then = i + std::size_t(std::lround(AHEAD[k] * RATE));
			const float x = path.x[then] - path.x[i];
			const float z = path.z[then] - path.z[i];
			const float cosine = std::cos(path.heading[i]);
			const float sine = std::sin(path.heading[i]);
			way.x[k] = x * cosine - z * sine;
			way.z[k] = z * cosine + x * sine;
			way.heading[k] = path.heading[then] - path.heading[i];
		}
		Features &row = rows[i];
		row.fill(0.0f);
		put_way(way, 0.0f, row);
		const std::size_t from = i == 0 ? 0 : i - 1;
		const std::size_t to = std::min(i + 1, rows.size() - 1);
		const float per_second = RATE / float(std::max<std::size_t>(to - from, 1));
		for (std::size_t side = 0; side < 2; side++) {
			put(p_clip.frames[i].pose.ankles[side], ANKLES + 3 * side, row);
			put((p_clip.frames[to].pose.ankles[side] - p_clip.frames[from].pose.ankles[side]) * per_second,
					ANKLE_VELOCITIES + 3 * side, row);
		}
		put((p_clip.frames[to].pose.hips - p_clip.frames[from].pose.hips) * per_second, HIPS_VELOCITY, row);
	}
	return rows;
}

} // namespace matching
