// SPDX-License-Identifier: MIT
#pragma once

#include <coding/person_coder.hpp>
#include <coding/person_lattice.hpp>

#include <vector>

namespace training {

using wire::PersonModel;
using wire::PersonState;
using wire::Skeleton;

/// One motion: a person's pose at 60 ticks a second.
using Clip = std::vector<kinematics::PersonPose>;

/// Everything that the header holds.
struct Models {
	uint16_t shares[wire::SHAPES][wire::SHARE_POINTS];
	PersonModel whole[2];
	PersonModel still[2][wire::AGE_STEPS];
	PersonModel moving[2][wire::AGE_STEPS];
};

/// The skeleton of the clips: Limbs.PARENTS of scripts/core/limbs.gd.
Skeleton skeleton();
std::vector<Clip> read_clips(const char *p_path);
Models train_all(const std::vector<Clip> &p_clips);
/// Prints bits of a person with models of all clips, and with models of the other clips.
void report_left_out(const std::vector<Clip> &p_clips);
bool write_models(const Models &p_models, const char *p_path);

} // namespace training
