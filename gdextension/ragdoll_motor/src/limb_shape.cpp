// SPDX-License-Identifier: MIT
#include "limb_shape.hpp"

#include <algorithm>

namespace ragdoll {

namespace {

constexpr float PI = 3.14159265f;
constexpr float LARGEST = 4.0f; // m

} // namespace

Vec3 LimbShape::inertia(float p_mass) const {
	if (type == Type::BOX) {
		const Vec3 square = size.scaled(size);
		return Vec3{ square.y + square.z, square.x + square.z, square.x + square.y } * (p_mass / 12.0f);
	}
	// A cylinder with two half balls, by volume.
	const float cylinder = PI * radius * radius * length;
	const float ball = 4.0f / 3.0f * PI * radius * radius * radius;
	const float density = p_mass / (cylinder + ball);
	const float half = length / 2.0f;
	const float along = density * radius * radius * (cylinder / 2.0f + 0.4f * ball);
	const float across = density *
			(cylinder * (radius * radius / 4.0f + length * length / 12.0f) +
					ball * (0.4f * radius * radius + half * half + 0.75f * radius * half));
	return { across, along, across };
}

std::string LimbShape::find_fault() const {
	// Written so that NaN fails too.
	if (type == Type::PILL) {
		const bool fits = radius > 0.0f && radius < LARGEST / 2.0f && length >= 0.0f && length < LARGEST;
		return fits ? "" : "radius or length is no size of a limb";
	}
	const float smallest = std::min({ size.x, size.y, size.z });
	const bool fits = size.is_finite() && smallest > 0.0f && size.length() < LARGEST;
	return fits ? "" : "sizes must be above 0 and those of a limb";
}

} // namespace ragdoll
