// SPDX-License-Identifier: MIT
#include "binaural_filter.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace audio {

namespace {

/// Frames that are worked out together, so that each tap is loaded once for all of them.
constexpr std::size_t GROUP = 16;
/// Numbers in a register.
constexpr std::size_t LANES = 4;

using Lanes = float __attribute__((vector_size(LANES * sizeof(float))));

Lanes load(const float *p_from) {
	Lanes lanes;
	std::memcpy(&lanes, p_from, sizeof(lanes));
	return lanes;
}

} // namespace

void BinauralFilter::set_ears(const Ears &p_ears) {
	if (!_has_ears) {
		_ears = p_ears;
		_has_ears = true;
		return;
	}
	_next = p_ears;
	_turns = true;
}

void BinauralFilter::clear() {
	_heard.assign(TAPS - 1, 0.0f);
	if (_turns) {
		_ears = _next;
		_turns = false;
	}
}

void BinauralFilter::process(const float *p_mono, float *r_both, std::size_t p_frames) {
	if (p_frames == 0) {
		return;
	}
	// Room behind for the last group, which may be fuller than what is asked for.
	_heard.resize(TAPS - 1 + p_frames + GROUP, 0.0f);
	for (std::size_t i = 0; i < p_frames; i++) {
		// One value that is no number would be heard for ever in whatever comes behind.
		_heard[TAPS - 1 + i] = std::isfinite(p_mono[i]) ? p_mono[i] : 0.0f;
	}
	_convolve(_ears.left, p_frames, _left);
	_convolve(_ears.right, p_frames, _right);
	if (_turns) {
		_convolve(_next.left, p_frames, _next_left);
		_convolve(_next.right, p_frames, _next_right);
		for (std::size_t i = 0; i < p_frames; i++) {
			const float share = float(i + 1) / float(p_frames);
			_left[i] += (_next_left[i] - _left[i]) * share;
			_right[i] += (_next_right[i] - _right[i]) * share;
		}
		_ears = _next;
		_turns = false;
	}
	for (std::size_t i = 0; i < p_frames; i++) {
		r_both[2 * i] = _left[i];
		r_both[2 * i + 1] = _right[i];
	}
	std::copy_n(_heard.begin() + std::ptrdiff_t(p_frames), TAPS - 1, _heard.begin());
	_heard.resize(TAPS - 1);
}

void BinauralFilter::_convolve(const std::array<float, TAPS> &p_taps, std::size_t p_frames, std::vector<float> &r_ear) {
	r_ear.resize(p_frames + GROUP);
	for (std::size_t i = 0; i < p_frames; i += GROUP) {
		Lanes sums[GROUP / LANES] = {};
		const float *newest = &_heard[TAPS - 1 + i];
		for (std::size_t j = 0; j < TAPS; j++) {
			const float tap = p_taps[j];
			const Lanes taps = { tap, tap, tap, tap };
			for (std::size_t k = 0; k < GROUP / LANES; k++) {
				sums[k] += taps * load(newest - j + k * LANES);
			}
		}
		std::memcpy(&r_ear[i], sums, sizeof(sums));
	}
}

} // namespace audio
