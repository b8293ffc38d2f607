// SPDX-License-Identifier: MIT
#pragma once

#include "base/archive.hpp"
#include "base/vectors.hpp"
#include "body/pose.hpp"
#include "motion/pose_filter.hpp"
#include "motion/rate_predictor.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace ragdoll {

/// Live samples of one person, in order of their time; answers what the pose is *now*.
///
/// Causal: only what has arrived is used. Between samples it interpolates. Beyond the newest it goes
/// on with the turning rates of the last samples (or a gyroscope's), which fade: human limbs brake.
/// How the rates change until the next sample is learnt from the motion (RatePredictor).
/// When the stream stalls it goes back to the last pose: stale feed-forward is worse than none. White
/// noise is taken out where that is asked for.
class PoseStream {
public:
	/// Age of the newest sample (s) beyond which the stream counts as stalled.
	static constexpr double STALL_AFTER = 0.1;
	/// Age of the newest sample (s) at which nothing of the extrapolation is left.
	static constexpr double HOLD_AFTER = 0.3;
	/// Samples further apart than this (s) say nothing about velocity.
	static constexpr double MAX_GAP = 0.25;
	/// How fast the past is forgotten when rates are estimated, s. The two constants are those of the
	/// best linear predictor of the repository's three clips (fitted at 30, 60 and 120 Hz).
	static constexpr double RATE_MEMORY = 0.002;
	/// How fast a rate fades beyond the newest sample, s.
	static constexpr double RATE_FADE = 0.5;
	/// Turning rates above this (rad/s) are glitches: the fastest joint of a boxer stays below 40.
	static constexpr float FASTEST_TURN = 50.0f;
	/// A root that moves by more than this (m) from one sample to the next, and faster than
	/// FASTEST_ROOT (m/s), has been put elsewhere.
	static constexpr float TELEPORT_DISTANCE = 0.5f;
	static constexpr float FASTEST_ROOT = 20.0f;

	/// Times that differ by no more than this are the same, s: clocks count in microseconds.
	static constexpr double SAME_TIME = 2e-6;
	/// A gyroscope's rate above this (rad/s) is wrong: the sample's rates are estimated instead.
	static constexpr float FASTEST_GYRO = 100.0f;
	/// A change of rate below this says nothing about the next change: of a limb (rad/s), of the root (m/s).
	static constexpr float SMALL_TURN = 0.035f;
	static constexpr float SMALL_SPEED = 0.02f;
	/// The stream begins anew after this many samples in a row that are older than the newest one, each newer
	/// than the one before: the clock was set back, or the time of the newest sample was wrong.
	static constexpr int CLOCK_SET_BACK = 30;

	explicit PoseStream(std::size_t p_limb_count);

	/// Takes a sample. Refuses (and returns false for) what is not finite, not a rotation
	/// (norm off by more than a tenth), or not newer than the newest; but see CLOCK_SET_BACK.
	/// @param p_time_s sampling time in the wearer's clock, s
	/// @param p_orientations 4 floats a limb: x y z w
	/// @param p_rates a gyroscope's turning rates, 3 floats a limb in the limb's own axes, rad/s; null
	/// where they are not known
	bool push(double p_time_s, const float *p_orientations, const Vec3 &p_root, const float *p_rates = nullptr);
	void clear();

	/// Whether noise is taken out of the samples to come: it costs a millisecond or two of lag where a
	/// recording is not quite clean.
	void set_calms(bool p_calms) { _calms = p_calms; }
	/// The noise of the samples; none where it is not taken out.
	const PoseFilter &get_filter() const { return _filter; }
	std::size_t get_limb_count() const { return _limb_count; }
	bool is_empty() const { return _count == 0; }
	/// Time of the newest and the oldest sample that is kept, s.
	double newest() const { return at(0).time_s; }
	double oldest() const { return at(_count - 1).time_s; }
	/// Whether nothing is known of a time: the newest sample is too old, or it is the first one after a pause that
	/// the time lies in.
	bool is_stalled(double p_time_s) const;
	/// Whether the newest sample tells velocities: one before it, or a gyroscope's.
	bool knows_rates() const { return !is_empty() && (at(0).span_s > 0.0 || at(0).knows_rates); }
	/// Whether the root has been put elsewhere since the last call.
	bool take_teleport();

	/// The pose at a time. The stream must not be empty; r_pose is resized once, then reused.
	void predict(double p_time_s, Pose &r_pose) const;
	/// The pose as it was sampled, with all its noise: for times up to the newest sample.
	void recall(double p_time_s, Pose &r_pose) const;

	void save(ArchiveWriter &p_archive) const;
	/// Returns false, and is empty, where the archive is not of a stream with as many limbs.
	bool restore(ArchiveReader &p_archive);

private:
	static constexpr std::size_t CAPACITY = 32;
	struct Sample {
		double time_s = 0.0;
		std::vector<Quat> sampled;
		std::vector<Quat> orientations; // Without noise.
		std::vector<Vec3> rates; // In the limbs' own axes, rad/s.
		Vec3 root;
		Vec3 root_rate; // m/s
		std::vector<Vec3> turn_changes; // Of the rates until the next sample, rad/s.
		Vec3 root_change; // m/s
		double span_s = 0.0; // Since the sample before; 0 where the changes are not known.
		bool knows_rates = false; // Whether the rates are a gyroscope's.
	};

	/// The sample that came p_age samples before the newest.
	const Sample &at(std::size_t p_age) const { return _ring[(_head + CAPACITY - p_age) % CAPACITY]; }
	void calm(Sample &r_sample, bool p_knows_rates);
	bool comes_late(double p_time_s);
	void estimate_rates(const Sample &p_before, Sample &r_sample) const;
	void foresee(Sample &r_sample);
	/// How many samples are newer than the one that ends the span in which a time lies.
	std::size_t find_after(double p_time_s) const;
	void interpolate(double p_time_s, std::vector<Quat> Sample::*p_which, Pose &r_pose) const;
	void extrapolate(double p_age_s, Pose &r_pose) const;

	/// Begins a predictor with the first sample, or with the first one after a pause.
	void begin(RatePredictor &r_predictor, const Vec3 &p_rate, bool p_knows_rate) const;
	float forgetting(double p_span_s) const;

	std::size_t _limb_count;
	std::array<Sample, CAPACITY> _ring;
	std::size_t _head = 0;
	std::size_t _count = 0;
	bool _teleported = false;
	int _late = 0; // Samples in a row that came late, and the time of the last.
	double _latest_late_s = 0.0;
	bool _calms = false;
	PoseFilter _filter;
	std::vector<RatePredictor> _turns; // One for each limb.
	RatePredictor _path{ SMALL_SPEED };
};

} // namespace ragdoll
