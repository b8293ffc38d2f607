// SPDX-License-Identifier: MIT
#pragma once

#include "body.hpp"

namespace matching {

/// Poses for what a set does not hold, made by rules. In the frame of the person's way, m: its origin is where he
/// stands on the ground, +Z where he faces.

/// Bends a pose's trunk and arms for somebody who crouches, by a share from 0 to 1; the hips go down by as much as is
/// returned, m, and the legs must reach for the feet again.
float crouch(float p_share, const Body &p_body, Pose &r_pose);
/// Legs and arms of somebody in the air, who goes up or down by so many m/s.
Pose airborne(const Pose &p_from, const Body &p_body, float p_rising);
/// Somebody on his belly, who has crawled so far, m.
Pose prone(const Body &p_body, float p_travelled);
/// Somebody on a ladder in front of him, who has climbed so far, m.
Pose ladder(const Body &p_body, float p_climbed);
/// Somebody who supports himself on an edge in front of him.
Pose vault(const Body &p_body);

} // namespace matching
