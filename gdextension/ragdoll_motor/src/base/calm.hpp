// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>

namespace ragdoll {

/// The share of the distance to a value that a first-order low-pass covers in a step: 1 - exp(-dt / T).
/// @param p_time_s its time constant T, s
inline float share(float p_delta_s, float p_time_s) {
	return 1.0f - std::exp(-p_delta_s / p_time_s);
}

/// A value brought nearer to another one by no more than a step.
inline float towards(float p_from, float p_to, float p_most) {
	return p_from + std::clamp(p_to - p_from, -p_most, p_most);
}

/// Says how much of what a predictor did not expect is noise, and so how far the predictor is corrected.
///
/// A predictor of position and rate is corrected by shares of its surprises (the critically damped g-h
/// filter). Of a surprise's mean square the measured noise explains a part, and that part is left out:
/// what rests is averaged for long, what moves is followed, and clean motion passes as it is.
class Calm {
public:
	/// Takes a surprise.
	/// @param p_square mean square of its components
	/// @param p_noise size of the noise, in the same unit
	/// @param p_span_s time since the last one, s
	/// @param p_memory_s surprises are averaged over this time, s
	/// @param p_most at most this share is left out, so that what rests can start to move
	void advance(float p_square, float p_noise, float p_span_s, float p_memory_s, float p_most) {
		_surprise += share(p_span_s, p_memory_s) * (p_square - _surprise);
		_left_out = _surprise > 0.0f ? std::min(p_noise / std::sqrt(_surprise), p_most) : 0.0f;
	}
	/// Share of the surprise by which the position is corrected.
	float get_gain() const { return 1.0f - _left_out * _left_out; }
	/// Share of it by which the rate is corrected, for a span of one.
	float get_rate_gain() const { return (1.0f - _left_out) * (1.0f - _left_out); }

private:
	float _surprise = 0.0f; // Mean square.
	float _left_out = 0.0f;
};

} // namespace ragdoll
