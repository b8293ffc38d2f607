// SPDX-License-Identifier: MIT
#pragma once

#include <headings.hpp>
#include <quaternion.hpp>

namespace ragdoll {

using kinematics::angle_between;
using kinematics::exp;
using kinematics::from_axes;
using kinematics::level;
using kinematics::log;
using kinematics::Quat;
using kinematics::slerp;
using kinematics::Vec3;

constexpr float PI = 3.14159265f;
constexpr float TAU = 6.28318531f;

} // namespace ragdoll
