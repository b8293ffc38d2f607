// SPDX-License-Identifier: MIT
#pragma once

#include "pose_stream.hpp"
#include "quaternion.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

namespace ragdoll {

/// Measures how well the simulated limbs follow the motion, honestly: a pose is compared with the
/// true motion at the same time, which is known only once a later sample has arrived.
class TrackingMeter {
public:
	/// Notes the simulated orientations at a time of the wearer's clock, s.
	void note(double p_time_s, const std::vector<Quat> &p_actual);
	/// Compares what was noted with the samples that have arrived since.
	void settle(const PoseStream &p_stream);
	void clear();

	/// Number of limb orientations compared.
	std::uint64_t get_count() const { return count; }
	/// Mean and 95th percentile of the angle between limb and motion, rad.
	double mean() const { return count > 0 ? sum / double(count) : 0.0; }
	double percentile(double p_fraction) const;
	/// Mean angle of the limbs in the pose compared last, rad.
	double latest() const { return last_mean; }

private:
	static constexpr double BIN = 0.001; // rad
	static constexpr std::size_t BINS = 3142; // Up to pi.
	static constexpr std::size_t LONGEST = 64; // Poses that wait: about a second.
	struct Noted {
		double time_s;
		std::vector<Quat> actual;
	};

	void compare(const Noted &p_noted, const Pose &p_truth);

	std::deque<Noted> waiting;
	std::array<std::uint64_t, BINS> histogram{};
	std::uint64_t count = 0;
	double sum = 0.0;
	double last_mean = 0.0;
	Pose truth;
};

} // namespace ragdoll
