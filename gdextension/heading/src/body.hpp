// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace heading {

/// Where sensors are worn, in the order of the project's BodyMounts.
constexpr int MOUNTS = 17;
constexpr int LEFT_FOOT = 13;
constexpr int RIGHT_FOOT = 16;
constexpr int LEFT_SHANK = 12;
constexpr int RIGHT_SHANK = 15;

/// The mount one joint nearer to the pelvis, -1 for the pelvis.
constexpr std::array<int, MOUNTS> PARENTS{ -1, 0, 1, 1, 3, 4, 5, 1, 7, 8, 9, 0, 11, 12, 0, 14, 15 };

constexpr double PI = 3.14159265358979323846;

/// Degrees in rad.
constexpr double degrees(double p_degrees) {
	return p_degrees * PI / 180.0;
}

} // namespace heading
