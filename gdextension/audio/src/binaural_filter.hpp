// SPDX-License-Identifier: MIT
#pragma once

#include "head.hpp"

#include <vector>

namespace audio {

/// One voice at the ears: a mono signal through both ears' filters. Its direction changes without a click: over the
/// frames of the next call, sixteen at a time, the old filters become the new ones.
class BinauralFilter {
public:
	/// Hears from another direction from now on.
	void set_ears(const Ears &p_ears);
	/// Takes frames of mono sound, gives as many of both ears, one after the other: left, right.
	void process(const float *p_mono, float *r_both, std::size_t p_frames);
	/// Forgets what was heard.
	void clear();

private:
	Ears _ears;
	Ears _next;
	bool _has_ears = false;
	bool _turns = false;
	/// The last TAPS - 1 frames, and behind them those that are processed now.
	std::vector<float> _heard = std::vector<float>(TAPS - 1, 0.0f);
};

} // namespace audio
