// SPDX-License-Identifier: MIT
#include <binaural_filter.hpp>

#include <check.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace test_binaural_filter {

using namespace audio;

namespace {

Ears spike(std::size_t p_left, std::size_t p_right, float p_level = 1.0f) {
	Ears ears;
	ears.left[p_left] = 1.0f;
	ears.right[p_right] = p_level;
	return ears;
}

std::vector<float> noise(std::size_t p_frames) {
	std::vector<float> made(p_frames);
	unsigned seed = 17;
	for (float &value : made) {
		seed = seed * 1664525u + 1013904223u;
		value = float(seed >> 8u) / float(1u << 23u) - 1.0f;
	}
	return made;
}

/// Processes a signal in blocks of a size.
std::vector<float> run(BinauralFilter &r_filter, const std::vector<float> &p_mono, std::size_t p_block) {
	std::vector<float> both(p_mono.size() * 2);
	for (std::size_t i = 0; i < p_mono.size(); i += p_block) {
		r_filter.process(&p_mono[i], &both[2 * i], std::min(p_block, p_mono.size() - i));
	}
	return both;
}

} // namespace

TEST(each_ear_hears_by_its_filter) {
	BinauralFilter filter;
	filter.set_ears(spike(3, 127, 0.5f));
	const std::vector<float> mono = noise(2000);
	const std::vector<float> both = run(filter, mono, 512);
	float worst = 0.0f;
	for (std::size_t i = 127; i < mono.size(); i++) {
		worst = std::max(worst, std::abs(both[2 * i] - mono[i - 3]));
		worst = std::max(worst, std::abs(both[2 * i + 1] - 0.5f * mono[i - 127]));
	}
	CHECK(worst < 1e-5f);
}

TEST(blocks_of_any_size_sound_alike) {
	Ears ears;
	const std::vector<float> taps = noise(2 * TAPS);
	std::copy_n(taps.begin(), TAPS, ears.left.begin());
	std::copy_n(taps.begin() + TAPS, TAPS, ears.right.begin());
	const std::vector<float> mono = noise(3000);
	BinauralFilter whole;
	whole.set_ears(ears);
	const std::vector<float> expected = run(whole, mono, 3000);
	for (const std::size_t block : { 1u, 7u, 16u, 100u, 512u, 1021u }) {
		BinauralFilter filter;
		filter.set_ears(ears);
		const std::vector<float> both = run(filter, mono, block);
		float worst = 0.0f;
		for (std::size_t i = 0; i < both.size(); i++) {
			worst = std::max(worst, std::abs(both[i] - expected[i]));
		}
		CHECK(worst < 1e-4f);
	}
}

TEST(a_turn_makes_no_click) {
	BinauralFilter filter;
	filter.set_ears(spike(10, 40));
	std::vector<float> tone(4096);
	for (std::size_t i = 0; i < tone.size(); i++) {
		tone[i] = std::sin(float(i) * 0.05f);
	}
	std::vector<float> both(2 * tone.size());
	float step = 0.0f;
	for (std::size_t i = 0; i < tone.size(); i += 512) {
		if (i >= 1024) {
			filter.set_ears(i % 1024 == 0 ? spike(10, 40) : spike(40, 10));
		}
		filter.process(&tone[i], &both[2 * i], 512);
	}
	for (std::size_t i = 256; i + 1 < tone.size(); i++) {
		step = std::max(step, std::abs(both[2 * i + 2] - both[2 * i]));
	}
	// The tone's own steps are 0.05 at most; to the other side at once would be one of 1.3.
	CHECK(step < 0.1f);
}

TEST(what_is_no_number_is_not_heard_for_ever) {
	BinauralFilter filter;
	filter.set_ears(spike(0, 0));
	std::vector<float> bad(64, std::numeric_limits<float>::quiet_NaN());
	bad[10] = std::numeric_limits<float>::infinity();
	for (const float value : run(filter, bad, 64)) {
		CHECK(value == 0.0f);
	}
}

TEST(nothing_is_heard_before_a_direction_is_known_and_after_a_stop) {
	BinauralFilter filter;
	const std::vector<float> mono(64, 1.0f);
	for (const float value : run(filter, mono, 64)) {
		CHECK(value == 0.0f);
	}
	filter.set_ears(spike(100, 100));
	run(filter, mono, 64);
	filter.clear();
	const std::vector<float> silence(256, 0.0f);
	for (const float value : run(filter, silence, 64)) {
		CHECK(value == 0.0f);
	}
}

} // namespace test_binaural_filter
