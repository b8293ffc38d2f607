// SPDX-License-Identifier: MIT
#pragma once

#include "quaternion.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace ragdoll {

/// Where every limb is to be at one moment, and how fast it turns.
struct Pose {
	std::vector<Quat> orientations; ///< World orientation of each limb.
	Vec3 root; ///< World position of the root limb's joint, m.
};

/// Live samples of one person, in order of their time; answers what the pose is *now*.
///
/// Causal: only what has arrived is used. Between samples it interpolates, beyond the newest it
/// extrapolates with the angular velocity of the last two (backward difference), and when the
/// stream stalls it holds the last pose: stale feed-forward is worse than none.
class PoseStream {
public:
	/// Longest extrapolation, s. Beyond it the stream counts as stalled.
	static constexpr double STALL_AFTER = 0.1;
	/// Samples further apart than this (s) say nothing about velocity.
	static constexpr double LONGEST_GAP = 0.25;

	explicit PoseStream(std::size_t p_limb_count);

	/// Takes a sample. Refuses (and returns false for) what is not finite, not a rotation
	/// (norm off by more than a tenth), or not newer than the newest.
	/// @param p_time_s sampling time in the wearer's clock, s
	/// @param p_orientations 4 floats a limb: x y z w
	bool push(double p_time_s, const float *p_orientations, const Vec3 &p_root);
	void clear();

	bool is_empty() const { return count == 0; }
	/// Time of the newest and the oldest sample that is kept, s.
	double newest() const { return at(0).time_s; }
	double oldest() const { return at(count - 1).time_s; }
	bool is_stalled(double p_time_s) const { return is_empty() || p_time_s - newest() > STALL_AFTER; }

	/// The pose at a time. The stream must not be empty; r_pose is resized once, then reused.
	void predict(double p_time_s, Pose &r_pose) const;

private:
	static constexpr std::size_t CAPACITY = 32;
	struct Sample {
		double time_s = 0.0;
		std::vector<Quat> orientations;
		Vec3 root;
	};

	/// The sample p_age places before the newest.
	const Sample &at(std::size_t p_age) const { return ring[(head + CAPACITY - p_age) % CAPACITY]; }

	std::size_t limb_count;
	std::array<Sample, CAPACITY> ring;
	std::size_t head = 0;
	std::size_t count = 0;
};

} // namespace ragdoll
