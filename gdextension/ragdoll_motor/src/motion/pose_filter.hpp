// SPDX-License-Identifier: MIT
#pragma once

#include "base/archive.hpp"
#include "base/calm.hpp"
#include "base/vectors.hpp"

#include <cstddef>
#include <vector>

namespace ragdoll {

/// Takes white noise out of orientations, limb by limb, as far as there is any: clean motion passes
/// unchanged and at once.
///
/// Each limb has a predictor of orientation and turning rate whose gains follow from what is measured
/// (see Calm): a limb at rest is averaged for long, one that swings is followed.
class PoseFilter {
public:
	/// Noise up to this (rad, each axis) counts as none: optical recordings have as much.
	static constexpr float CLEAN = 0.002f;
	/// A measured noise is taken to be this at most, rad.
	static constexpr float NOISIEST = 0.1f;
	/// The noise is averaged over this time, s.
	static constexpr float NOISE_S = 0.5f;
	/// A limb's surprises are averaged over this time, s.
	static constexpr float SURPRISE_S = 0.05f;
	/// Noise (rad) at which the motion counts as half noise.
	static constexpr float SHAKY = 0.009f;
	/// At most this share of a surprise is left out, so that a limb at rest can start to move.
	static constexpr float CALMEST = 0.95f;

	explicit PoseFilter(std::size_t p_limb_count) : _limbs(p_limb_count), _levels(p_limb_count, 0.0f) {}

	void clear();
	bool is_empty() const { return _known == 0; }
	/// Begins anew with a pose at rest; what is known of the noise stays.
	void begin(const std::vector<Quat> &p_sampled);
	/// Takes the next pose.
	/// @param p_span_s time since the one before, s
	void advance(const std::vector<Quat> &p_sampled, float p_span_s);

	/// White noise of each axis of the limbs, rad; 0 where the motion is clean.
	float get_noise() const { return _noise; }
	/// How noisy the motion is: 0 where it is clean, towards 1 the more it shakes.
	float get_unrest() const { return _noise / (_noise + SHAKY); }
	const Quat &get_orientation(std::size_t p_limb) const { return _limbs[p_limb].calm; }
	/// Turning rate in the limb's axes, rad/s.
	const Vec3 &get_rate(std::size_t p_limb) const { return _limbs[p_limb].rate; }

	void save(ArchiveWriter &p_archive) const;
	bool restore(ArchiveReader &p_archive);

private:
	struct Limb {
		Quat sampled;
		Vec3 turned[2]; // From sample to sample, newest first, rad.
		Vec3 third; // Third difference, rad.
		float product = 0.0f; // Of successive third differences, mean, rad^2.
		Calm surprises;
		Quat calm;
		Vec3 rate;
	};

	void find_noise(const std::vector<Quat> &p_sampled, float p_span_s);

	std::vector<Limb> _limbs;
	std::vector<float> _levels; // Variance of each limb's noise, rad^2; scratch.
	float _noise = 0.0f;
	float _span = 0.0f; // Of the last two samples, s.
	int _known = 0; // Samples in a row at even spans.
};

} // namespace ragdoll
