// SPDX-License-Identifier: MIT
#pragma once

#include <clip_builder.hpp>
#include <motion_set.hpp>

#include <memory>
#include <string>
#include <vector>

/// A made-up person who walks straight on, whose feet stand half of the time.
namespace walker_fixture {

using namespace matching;

/// Where a foot is after so many seconds: m along the way, and its height.
inline Vec3 foot_at(float p_seconds, float p_speed, std::size_t p_side, const Body &p_body) {
	constexpr float CYCLE_S = 1.0f;
	const float stride = p_speed * CYCLE_S;
	const float at = p_seconds / CYCLE_S + (p_side == 0 ? 0.0f : 0.5f);
	const float whole = std::floor(at);
	const float share = at - whole;
	// Half a cycle in the air, half on the ground.
	const float ahead = share < 0.5f ? eased(share * 2.0f) : 1.0f;
	const float height = share < 0.5f ? 0.12f * std::sin(PI * share * 2.0f) : 0.0f;
	const float z = (whole + ahead - (p_side == 0 ? 0.0f : 0.5f) - 0.25f) * stride;
	return { p_side == 0 ? 0.09f : -0.09f, p_body.ankle_height + (p_speed > 0.0f ? height : 0.0f), z };
}

inline std::vector<RawFrame> walk(float p_speed, float p_seconds, const Body &p_body) {
	std::vector<RawFrame> frames;
	for (int i = 0; i < int(p_seconds * RATE); i++) {
		const float time = float(i) / RATE;
		RawFrame frame;
		frame.hips = { 0.0f, 0.97f * p_body.hip_height, p_speed * time };
		for (std::size_t side = 0; side < 2; side++) {
			const Vec3 joint = frame.hips + p_body.hip_joints[side];
			reach(joint, foot_at(time, p_speed, side, p_body), p_body.thigh, p_body.shank, { 0.0f, 0.0f, 1.0f },
					frame.limbs[thigh_of(side)], frame.limbs[thigh_of(side) + 1]);
		}
		frames.push_back(frame);
	}
	return frames;
}

inline Clip clip(const std::string &p_name, float p_speed) {
	const Body body = Body::of(1.0f);
	const std::vector<RawFrame> frames = walk(p_speed, 4.0f, body);
	Clip made = build_clip(frames, 30, frames.size() - 30, body);
	made.name = p_name;
	return made;
}

inline std::vector<Clip> clips() {
	return { clip("stand", 0.0f), clip("slow", 0.8f), clip("walk", 1.4f), clip("run", 3.0f) };
}

inline std::shared_ptr<const MotionSet> motion_set() {
	return std::make_shared<const MotionSet>(clips());
}

} // namespace walker_fixture
