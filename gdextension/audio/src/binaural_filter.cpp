// SPDX-License-Identifier: MIT
#include "binaural_filter.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace audio {

namespace {

/// Frames that are worked out together, so that each tap is loaded once for all of them.
constexpr std::size_t GROUP = 16;

/// As many numbers as a register of the plainest processors holds.
using Lanes = float __attribute__((vector_size(4 * sizeof(float))));
constexpr std::size_t LANES = sizeof(Lanes) / sizeof(float);

/// Convolves a group of frames; the newest frame of the first one is given.
void convolve(const std::array<float, TAPS> &p_taps, const float *p_newest, std::array<float, GROUP> &r_group) {
	Lanes sums[GROUP / LANES] = {};
	for (std::size_t j = 0; j < TAPS; j++) {
		for (std::size_t k = 0; k < GROUP / LANES; k++) {
			Lanes heard;
			std::memcpy(&heard, p_newest - j + k * LANES, sizeof(heard));
			sums[k] += p_taps[j] * heard;
		}
	}
	std::memcpy(r_group.data(), sums, sizeof(sums));
}

/// A filter on its way to another one.
void blend(const std::array<float, TAPS> &p_from, const std::array<float, TAPS> &p_to, float p_share,
		std::array<float, TAPS> &r_taps) {
	for (std::size_t i = 0; i < TAPS; i++) {
		r_taps[i] = p_from[i] + (p_to[i] - p_from[i]) * p_share;
	}
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
	Ears now = _ears;
	std::array<float, GROUP> left;
	std::array<float, GROUP> right;
	for (std::size_t i = 0; i < p_frames; i += GROUP) {
		if (_turns) {
			const float share = std::min(1.0f, float(i + GROUP) / float(p_frames));
			blend(_ears.left, _next.left, share, now.left);
			blend(_ears.right, _next.right, share, now.right);
		}
		convolve(now.left, &_heard[TAPS - 1 + i], left);
		convolve(now.right, &_heard[TAPS - 1 + i], right);
		for (std::size_t k = 0; k < std::min(GROUP, p_frames - i); k++) {
			r_both[2 * (i + k)] = left[k];
			r_both[2 * (i + k) + 1] = right[k];
		}
	}
	if (_turns) {
		_ears = _next;
		_turns = false;
	}
	std::copy_n(_heard.begin() + std::ptrdiff_t(p_frames), TAPS - 1, _heard.begin());
	_heard.resize(TAPS - 1);
}

} // namespace audio
