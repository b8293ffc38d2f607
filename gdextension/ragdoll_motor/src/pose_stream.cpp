// SPDX-License-Identifier: MIT
#include "pose_stream.hpp"

#include <algorithm>

namespace ragdoll {

PoseStream::PoseStream(std::size_t p_limb_count) : limb_count(p_limb_count) {
	for (Sample &sample : ring) {
		sample.orientations.resize(limb_count);
	}
}

void PoseStream::clear() {
	count = 0;
}

bool PoseStream::push(double p_time_s, const float *p_orientations, const Vec3 &p_root) {
	if (!std::isfinite(p_time_s) || !p_root.is_finite() || (count > 0 && p_time_s <= newest())) {
		return false;
	}
	for (std::size_t i = 0; i < limb_count; i++) {
		const float *values = p_orientations + 4 * i;
		const Quat orientation{ values[0], values[1], values[2], values[3] };
		// Written so that NaN fails too.
		const float norm = std::sqrt(orientation.dot(orientation));
		if (!(norm > 0.9f && norm < 1.1f)) {
			return false;
		}
	}
	const std::size_t next = (head + 1) % CAPACITY;
	Sample &sample = ring[next];
	sample.time_s = p_time_s;
	sample.root = p_root;
	for (std::size_t i = 0; i < limb_count; i++) {
		const float *values = p_orientations + 4 * i;
		sample.orientations[i] = Quat{ values[0], values[1], values[2], values[3] }.normalized();
	}
	head = next;
	count = std::min(count + 1, CAPACITY);
	return true;
}

void PoseStream::predict(double p_time_s, Pose &r_pose) const {
	r_pose.orientations.resize(limb_count);
	std::size_t age = 0; // Of the later of the two samples that the time lies between.
	while (age + 2 < count && at(age + 1).time_s > p_time_s) {
		age++;
	}
	const Sample &after = at(age);
	const bool alone = count < 2 || after.time_s - at(age + 1).time_s > LONGEST_GAP;
	if (alone || is_stalled(p_time_s)) {
		r_pose.orientations = after.orientations;
		r_pose.root = after.root;
		return;
	}
	const Sample &before = at(age + 1);
	const double span = after.time_s - before.time_s;
	const double time = std::max(p_time_s, before.time_s);
	const float fraction = float((time - before.time_s) / span);
	for (std::size_t i = 0; i < limb_count; i++) {
		r_pose.orientations[i] = slerp(before.orientations[i], after.orientations[i], fraction);
	}
	r_pose.root = before.root + (after.root - before.root) * fraction;
}

} // namespace ragdoll
