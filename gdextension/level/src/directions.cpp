// SPDX-License-Identifier: MIT
#include "directions.hpp"

#include <cmath>

namespace level {

namespace {

constexpr float TAU = 6.28318530717959f;
constexpr float GOLDEN = 0.61803398875f;

} // namespace

Frame frame_of(const Vec3 &p_normal) {
	const Vec3 helper = std::fabs(p_normal.y) < 0.9f ? Vec3{ 0.0f, 1.0f, 0.0f } : Vec3{ 1.0f, 0.0f, 0.0f };
	const Vec3 across = p_normal.cross(helper);
	const Vec3 x = across * (1.0f / across.length());
	return { x, p_normal.cross(x), p_normal };
}

std::vector<Vec3> hemisphere(int p_count) {
	std::vector<Vec3> ways;
	for (int index = 0; index < p_count; index++) {
		const float square = (float(index) + 0.5f) / float(p_count);
		const float radius = std::sqrt(square);
		const float angle = TAU * std::fmod(float(index) * GOLDEN, 1.0f);
		ways.push_back({ radius * std::cos(angle), radius * std::sin(angle), std::sqrt(1.0f - square) });
	}
	return ways;
}

std::vector<Vec3> sphere(int p_count) {
	std::vector<Vec3> ways;
	for (int index = 0; index < p_count; index++) {
		const float y = 1.0f - 2.0f * (float(index) + 0.5f) / float(p_count);
		const float radius = std::sqrt(1.0f - y * y);
		const float angle = TAU * std::fmod(float(index) * GOLDEN, 1.0f);
		ways.push_back({ radius * std::cos(angle), y, radius * std::sin(angle) });
	}
	return ways;
}

} // namespace level
