// SPDX-License-Identifier: MIT
#pragma once

#include "body.hpp"
#include "motion_clip.hpp"

#include <vector>

namespace matching {

/// What a motion file says of a person at a moment: 60 a second, in the world, m.
struct RawFrame {
	Vec3 hips;
	std::array<Quat, LIMBS> limbs{};
};

/// Makes a clip out of a recording: finds the person's way, his feet and when they stand. Takes the frames from
/// `p_first` up to `p_end` out; those around are used to find the way at both ends.
Clip build_clip(const std::vector<RawFrame> &p_frames, std::size_t p_first, std::size_t p_end, const Body &p_body);

} // namespace matching
