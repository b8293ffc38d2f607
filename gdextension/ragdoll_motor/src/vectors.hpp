// SPDX-License-Identifier: MIT
#pragma once

#include <quaternion.hpp>

namespace ragdoll {

using kinematics::angle_between;
using kinematics::exp;
using kinematics::from_axes;
using kinematics::log;
using kinematics::Quat;
using kinematics::slerp;
using kinematics::Vec3;

} // namespace ragdoll
