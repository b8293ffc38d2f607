// SPDX-License-Identifier: MIT
#include "clip_builder.hpp"

#include <algorithm>
#include <cmath>

namespace matching {

namespace {

/// Half the width of the window over which the way is averaged, frames: more than half a step of a slow walk.
constexpr std::size_t HALF_WINDOW = 24;
/// Feet that stand: at most so much above where they are at their lowest nearby, m, and so fast, m/s, or this share of
/// the person's own speed.
constexpr float STANDING_HEIGHT = 0.035f;
constexpr float STANDING_SPEED = 0.35f;
constexpr float STANDING_SHARE = 0.25f;
/// Shortest time that a foot stands or swings, frames: what is shorter is noise.
constexpr int SHORTEST = 4;
/// Over how many frames the height of the ground is averaged.
constexpr float GROUND_WINDOW = 10.0f;

/// A value beyond both ends goes on as it went: an average must not stop there.
template <typename T>
T extended(const std::vector<T> &p_values, int p_at) {
	const int last = int(p_values.size()) - 1;
	const int reach = std::min(2 * int(HALF_WINDOW), last);
	if (p_at < 0) {
		return p_values[0] - (p_values[std::size_t(reach)] - p_values[0]) * (float(-p_at) / float(std::max(reach, 1)));
	}
	if (p_at > last) {
		const T &end = p_values[std::size_t(last)];
		return end + (end - p_values[std::size_t(last - reach)]) * (float(p_at - last) / float(std::max(reach, 1)));
	}
	return p_values[std::size_t(p_at)];
}

template <typename T>
std::vector<T> averaged(const std::vector<T> &p_values) {
	std::vector<T> result(p_values.size());
	for (int i = 0; i < int(p_values.size()); i++) {
		T sum{};
		float weights = 0.0f;
		for (int k = -int(HALF_WINDOW); k <= int(HALF_WINDOW); k++) {
			const float weight = 0.5f + 0.5f * std::cos(3.14159265f * float(k) / float(HALF_WINDOW + 1));
			sum = sum + extended(p_values, i + k) * weight;
			weights += weight;
		}
		result[std::size_t(i)] = sum * (1.0f / weights);
	}
	return result;
}

/// Where a person goes: places of the hips on the ground and headings of the chest, averaged.
struct Course {
	std::vector<Vec3> places;
	std::vector<float> headings;
};

Course find_course(const std::vector<RawFrame> &p_frames) {
	std::vector<Vec3> hips;
	std::vector<float> headings;
	float before = 0.0f;
	for (const RawFrame &frame : p_frames) {
		before += wrapped(facing_of(frame.limbs[CHEST]) - before);
		headings.push_back(before);
		hips.push_back({ frame.hips.x, 0.0f, frame.hips.z });
	}
	return { averaged(hips), averaged(headings) };
}

/// Removes runs of equal values that are shorter than they can be.
void clean(std::vector<bool> &r_values) {
	std::size_t begin = 0;
	while (begin < r_values.size()) {
		std::size_t end = begin;
		while (end < r_values.size() && r_values[end] == r_values[begin]) {
			end++;
		}
		if (int(end - begin) < SHORTEST && begin > 0 && end < r_values.size()) {
			for (std::size_t i = begin; i < end; i++) {
				r_values[i] = !r_values[i];
			}
		}
		begin = end;
	}
}

std::vector<bool> find_contacts(const std::vector<Vec3> &p_balls, float p_speed) {
	const float limit = std::max(STANDING_SPEED, STANDING_SHARE * p_speed);
	std::vector<bool> stands(p_balls.size());
	for (std::size_t i = 0; i < p_balls.size(); i++) {
		float lowest = p_balls[i].y;
		const std::size_t end = std::min(i + HALF_WINDOW, p_balls.size());
		for (std::size_t k = i > HALF_WINDOW ? i - HALF_WINDOW : 0; k < end; k++) {
			lowest = std::min(lowest, p_balls[k].y);
		}
		const Vec3 step = p_balls[std::min(i + 1, p_balls.size() - 1)] - p_balls[i == 0 ? 0 : i - 1];
		const float speed = std::hypot(step.x, step.z) * RATE * 0.5f;
		stands[i] = p_balls[i].y < lowest + STANDING_HEIGHT && speed < limit;
	}
	clean(stands);
	return stands;
}

/// Height of the ground at each frame: where balls of feet stand. Few recordings are quite level.
std::vector<float> find_ground(
		const std::array<std::vector<Vec3>, 2> &p_balls, const std::array<std::vector<bool>, 2> &p_stands) {
	std::vector<float> ground(p_balls[0].size());
	for (std::size_t i = 0; i < ground.size(); i++) {
		float sum = 0.0f;
		float weights = 0.0f;
		float lowest = p_balls[0][i].y;
		for (std::size_t k = 0; k < ground.size(); k++) {
			const float apart = (float(k) - float(i)) / GROUND_WINDOW;
			for (std::size_t side = 0; side < 2; side++) {
				lowest = std::min(lowest, p_balls[side][k].y);
				// It falls off slowly: where nobody stands for long, the next one who does tells it.
				const float width = 1.0f + apart * apart;
				const float weight = p_stands[side][k] ? 1.0f / (width * width) : 0.0f;
				sum += weight * p_balls[side][k].y;
				weights += weight;
			}
		}
		ground[i] = weights > 0.0f ? sum / weights : lowest;
	}
	return ground;
}

Vec3 in_way(const Vec3 &p_place, const Quat &p_back, const Vec3 &p_origin, float p_size) {
	return p_back.rotate(p_place - p_origin) * (1.0f / p_size);
}

} // namespace

Clip build_clip(const std::vector<RawFrame> &p_frames, std::size_t p_first, std::size_t p_end, const Body &p_body) {
	Clip clip;
	clip.ankle_height = p_body.ankle_height / p_body.hip_height;
	clip.foot = p_body.foot / p_body.hip_height;
	const std::size_t end = std::min(p_end, p_frames.size());
	if (end < p_first + 2) {
		return clip;
	}
	const Course way = find_course(p_frames);
	std::array<std::vector<Vec3>, 2> balls;
	std::vector<Pose> poses(p_frames.size());
	for (std::size_t i = 0; i < p_frames.size(); i++) {
		poses[i].hips = p_frames[i].hips;
		poses[i].limbs = p_frames[i].limbs;
		for (std::size_t side = 0; side < 2; side++) {
			poses[i].ankles[side] = ankle_of(p_body, poses[i], side);
			balls[side].push_back(poses[i].ankles[side] + poses[i].limbs[foot_of(side)].rotate(p_body.ball()));
		}
	}
	const Vec3 whole = way.places[end - 1] - way.places[p_first];
	const float speed = whole.length() * RATE / float(end - p_first);
	const std::array<std::vector<bool>, 2> stands{ find_contacts(balls[0], speed), find_contacts(balls[1], speed) };
	const std::vector<float> ground = find_ground(balls, stands);
	for (std::size_t i = p_first; i < end; i++) {
		const std::size_t next = std::min(i + 1, p_frames.size() - 1);
		const std::size_t last = i == 0 ? 0 : i - 1;
		const float per_second = RATE / float(next - last);
		const Quat back = turn_of(-way.headings[i]);
		ClipFrame frame;
		const Vec3 origin{ way.places[i].x, ground[i], way.places[i].z };
		frame.pose.hips = in_way(poses[i].hips, back, origin, p_body.hip_height);
		for (std::size_t side = 0; side < 2; side++) {
			frame.pose.ankles[side] = in_way(poses[i].ankles[side], back, origin, p_body.hip_height);
			frame.contacts = uint8_t(frame.contacts | (stands[side][i] ? 1U << side : 0U));
		}
		for (std::size_t limb = 0; limb < LIMBS; limb++) {
			frame.pose.limbs[limb] = back * poses[i].limbs[limb];
		}
		const Vec3 velocity = in_way(way.places[next], back, way.places[last], p_body.hip_height) * per_second;
		frame.velocity_x = velocity.x;
		frame.velocity_z = velocity.z;
		frame.turn_rate = (way.headings[next] - way.headings[last]) * per_second;
		clip.frames.push_back(frame);
	}
	return clip;
}

} // namespace matching
