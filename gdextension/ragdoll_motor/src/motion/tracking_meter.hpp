// SPDX-License-Identifier: MIT
#pragma once

#include "base/histogram.hpp"
#include "base/vectors.hpp"
#include "body/rig.hpp"
#include "motion/pose_stream.hpp"

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
	/// Notes what the simulation has at a time of the wearer's clock, s.
	/// @param p_joints where the limbs' joints are, m
	void note(double p_time_s, const std::vector<Quat> &p_actual, const std::vector<Vec3> &p_joints);
	/// Compares what was noted with the samples that have arrived since.
	void settle(const PoseStream &p_stream, const Rig &p_rig);
	void clear();
	/// Forgets poses that have not been compared yet: another clock begins.
	void forget_waiting() { _waiting.clear(); }

	/// Number of limb orientations compared.
	std::uint64_t get_count() const { return _histogram.get_count(); }
	/// Mean and 95th percentile of the angle between limb and motion, rad.
	double mean() const { return get_count() > 0 ? _sum / double(get_count()) : 0.0; }
	double percentile(double p_fraction) const;
	/// Mean angle of the limbs in the pose compared last, rad.
	double latest() const { return _last_mean; }
	/// Mean distance between the limbs' joints and where the motion has them, m. Says something only
	/// where the root is where the motion has it.
	double mean_distance() const { return get_count() > 0 ? _distance_sum / double(get_count()) : 0.0; }
	/// How far the limbs come behind the motion, s: the delay of the motion with which they agree best;
	/// below 0 they are ahead of it. 0 unless `measures_lag`.
	double lag() const;
	/// Whether lag() is one: false where nothing was compared, and where the limbs agree best with a
	/// delay at either end of the search, MAX_LEAD or MAX_LAG; the true one lies beyond it.
	bool is_lag_known() const;
	/// Whether lag() is found; costs a comparison for each of SHIFTS delays. What is compared for it has
	/// to wait until the motion is known MAX_LEAD further.
	bool measures_lag = false;

	/// How far ahead of the motion and behind it limbs are looked for, s. Together with a tick they are
	/// what a stream of 240 Hz still remembers.
	static constexpr double MAX_LEAD = 0.04;
	static constexpr double MAX_LAG = 0.08;

private:
	static constexpr double BIN = 0.001; // rad
	static constexpr std::size_t BINS = 3142; // Up to pi.
	static constexpr std::size_t LONGEST = 64; // Poses that wait: about a second.
	static constexpr double SHIFT = 0.002; // Between the delays that are tried, s.
	static constexpr int SHIFTS = int((MAX_LEAD + MAX_LAG) / SHIFT + 1.5);
	struct Noted {
		double time_s;
		std::vector<Quat> actual;
		std::vector<Vec3> joints;
	};

	void compare_shifted(const Noted &p_noted, const PoseStream &p_stream);
	int find_best_shift() const;
	void compare(const Noted &p_noted, const PoseStream &p_stream, const Rig &p_rig);

	std::deque<Noted> _waiting;
	Histogram<BINS> _histogram;
	double _sum = 0.0;
	double _last_mean = 0.0;
	double _distance_sum = 0.0;
	std::array<double, SHIFTS> _shifted_sums{};
	std::uint64_t _shifted_count = 0;
	Pose _truth;
	Pose _shifted;
	std::vector<Vec3> _true_joints;
};

} // namespace ragdoll
