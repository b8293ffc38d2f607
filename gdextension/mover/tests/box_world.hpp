// SPDX-License-Identifier: MIT
#pragma once

#include <surroundings.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

/// A world of upright boxes, through which an upright box as wide as the cylinder is moved, exactly.
class BoxWorld : public mover::Surroundings {
public:
	struct Box {
		mover::Vec3 low;
		mover::Vec3 high;
		std::uint32_t carrier = 0;
		bool is_ladder = false;
	};

	BoxWorld() { add({ -100.0f, -1.0f, -100.0f }, { 100.0f, 0.0f, 100.0f }); }

	Box &add(const mover::Vec3 &p_low, const mover::Vec3 &p_high) {
		boxes.push_back({ p_low, p_high, 0, false });
		return boxes.back();
	}

	void sweep(mover::Stance p_stance, const mover::Vec3 &p_from, const mover::Vec3 &p_motion,
			mover::Sweep &r_sweep) const override {
		sweeps++;
		r_sweep = mover::Sweep();
		float share = 1.0f;
		for (const Box &box : boxes) {
			mover::Contact contact;
			const float hit = reach(box, p_stance, p_from, p_motion, contact.normal);
			if (hit < share) {
				share = hit;
				contact.carrier = box.carrier;
				contact.is_ladder = box.is_ladder;
				r_sweep.is_stopped = true;
				r_sweep.contacts[0] = contact;
				r_sweep.count = 1;
			}
		}
		// Stops a little before, as engines do.
		const float length = p_motion.length();
		const float kept = r_sweep.is_stopped && length > 0.0f ? std::max(share - 1e-4f / length, 0.0f) : share;
		r_sweep.travel = p_motion * kept;
		r_sweep.left = p_motion * (1.0f - kept);
	}

	bool find_frame(std::uint32_t p_carrier, mover::Frame &r_frame) const override {
		const auto found = frames.find(p_carrier);
		if (found == frames.end()) {
			return false;
		}
		r_frame = found->second;
		return true;
	}

	std::vector<Box> boxes;
	std::map<std::uint32_t, mover::Frame> frames;
	mutable int sweeps = 0;

private:
	/// The share of a motion after which a box is met; above 1: it is not.
	static float reach(const Box &p_box, mover::Stance p_stance, const mover::Vec3 &p_from, const mover::Vec3 &p_motion,
			mover::Vec3 &r_normal) {
		const float radius = mover::RADIUS;
		const float height = mover::HEIGHTS[std::size_t(p_stance)];
		const float from[3] = { p_from.x, p_from.y, p_from.z };
		const float motion[3] = { p_motion.x, p_motion.y, p_motion.z };
		const float low[3] = { p_box.low.x - radius, p_box.low.y - height, p_box.low.z - radius };
		const float high[3] = { p_box.high.x + radius, p_box.high.y, p_box.high.z + radius };
		float enter = -1e9f;
		float leave = 1e9f;
		int axis = -1;
		for (int i = 0; i < 3; i++) {
			if (std::fabs(motion[i]) < 1e-9f) {
				if (from[i] <= low[i] || from[i] >= high[i]) {
					return 2.0f;
				}
				continue;
			}
			const float a = (low[i] - from[i]) / motion[i];
			const float b = (high[i] - from[i]) / motion[i];
			if (std::min(a, b) > enter) {
				enter = std::min(a, b);
				axis = i;
			}
			leave = std::min(leave, std::max(a, b));
		}
		if (axis < 0 || enter >= leave || enter < -1e-3f || enter > 1.0f) {
			return 2.0f;
		}
		const float sign = motion[axis] > 0.0f ? -1.0f : 1.0f;
		r_normal = { axis == 0 ? sign : 0.0f, axis == 1 ? sign : 0.0f, axis == 2 ? sign : 0.0f };
		return std::max(enter, 0.0f);
	}
};
