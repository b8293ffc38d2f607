// SPDX-License-Identifier: MIT
#pragma once

#include "head.hpp"

#include <vector>

namespace audio {

/// One voice at the ears: a mono signal through both ears' filters. Its direction changes without a click: over the
/// frames of the next call the old filters fade into the new ones.
class BinauralFilter {
public:
	/// Hears from another direction from now on.
	void set_ears(const Ears &p_ears);
	/// Takes frames of mono sound, gives as many of both ears, one after the other: left, right.
	void process(const float *p_mono, float *r_both, std::size_t p_frames);
	/// Forgets what was heard.
	void clear();

private:
	void _convolve(const std::array<float, TAPS> &p_taps, std::size_t p_frames, std::vector<float> &r_ear);

	Ears _ears;
	Ears _next;
	bool _has_ears = false;
	bool _turns = false;
	/// The last TAPS - 1 frames, and behind them those that are processed now.
	std::vector<float> _heard = std::vector<float>(TAPS - 1, 0.0f);
	std::vector<float> _left;
	std::vector<float> _right;
	std::vector<float> _next_left;
	std::vector<float> _next_right;
};

} // namespace audio
