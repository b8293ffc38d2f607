// SPDX-License-Identifier: MIT
#include "motion_clip.hpp"

#include <algorithm>
#include <cmath>

namespace matching {

void level_feet(Clip &r_clip) {
	for (std::size_t side = 0; side < 2; side++) {
		Vec3 up;
		for (const ClipFrame &frame : r_clip.frames) {
			if (((frame.contacts >> side) & 1U) != 0) {
				up = up + frame.pose.limbs[foot_of(side)].inverse().rotate({ 0.0f, 1.0f, 0.0f });
			}
		}
		const Quat roll = exp({ 0.0f, 0.0f, -std::atan2(up.x, up.y) });
		for (ClipFrame &frame : r_clip.frames) {
			Quat &foot = frame.pose.limbs[foot_of(side)];
			foot = foot * roll;
		}
	}
}

Clip mirror(const Clip &p_clip) {
	Clip result = p_clip;
	result.name += "|mirrored";
	for (std::size_t i = 0; i < result.frames.size(); i++) {
		const ClipFrame &from = p_clip.frames[i];
		ClipFrame &to = result.frames[i];
		to.pose.hips.x = -from.pose.hips.x;
		for (std::size_t side = 0; side < 2; side++) {
			to.pose.ankles[side] = from.pose.ankles[1 - side];
			to.pose.ankles[side].x *= -1.0f;
		}
		for (std::size_t limb = 0; limb < LIMBS; limb++) {
			const Quat &other = from.pose.limbs[mirrored(limb)];
			to.pose.limbs[limb] = { other.x, -other.y, -other.z, other.w };
		}
		to.velocity_x = -from.velocity_x;
		to.turn_rate = -from.turn_rate;
		to.contacts = uint8_t(((from.contacts & 1U) << 1U) | ((from.contacts & 2U) >> 1U));
	}
	return result;
}

Clip reverse(const Clip &p_clip) {
	Clip result = p_clip;
	result.name += "|reversed";
	std::reverse(result.frames.begin(), result.frames.end());
	for (ClipFrame &frame : result.frames) {
		frame.velocity_x *= -1.0f;
		frame.velocity_z *= -1.0f;
		frame.turn_rate *= -1.0f;
	}
	return result;
}

} // namespace matching
