// SPDX-License-Identifier: MIT
#include "head.hpp"

#include <mysofa.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace audio {

namespace {

/// Taps over which a filter that was cut off fades.
constexpr std::size_t FADE = 16;
/// Silence that comes before the nearer ear's response is left out, but for so many taps.
constexpr int LEAD = 8;
/// Where the response begins: the first tap of this share of the largest.
constexpr float ONSET = 0.1f;
/// Most bytes of a file: the largest sets of public databases have some ten megabytes.
constexpr std::size_t MAX_BYTES = 64u << 20u;
constexpr float MIN_RATE = 8000.0f;
constexpr float MAX_RATE = 192000.0f;

int onset_of(const std::vector<float> &p_taps) {
	float largest = 0.0f;
	for (const float tap : p_taps) {
		largest = std::max(largest, std::abs(tap));
	}
	for (std::size_t i = 0; i < p_taps.size(); i++) {
		if (std::abs(p_taps[i]) >= ONSET * largest) {
			return int(i);
		}
	}
	return 0;
}

/// Copies a response from a tap on.
void put(const std::vector<float> &p_taps, std::size_t p_from, std::array<float, TAPS> &r_ear) {
	for (std::size_t i = 0; i < TAPS; i++) {
		const std::size_t at = i + p_from;
		r_ear[i] = at < p_taps.size() ? p_taps[at] : 0.0f;
		if (i >= TAPS - FADE) {
			r_ear[i] *= float(TAPS - i) / float(FADE + 1);
		}
	}
}

/// Whether all bytes of an HDF5 file are there: its first block (version 0, as SOFA files have it) says where it ends.
/// libmysofa reads beyond a file that was cut off.
bool is_whole(const std::vector<char> &p_bytes) {
	static const char signature[] = { '\x89', 'H', 'D', 'F', '\r', '\n', '\x1a', '\n', '\0' };
	constexpr std::size_t end_at = 40;
	std::uint64_t end = 0;
	if (p_bytes.size() < end_at + sizeof(end) || std::memcmp(p_bytes.data(), signature, sizeof(signature)) != 0) {
		return false;
	}
	for (std::size_t i = 0; i < sizeof(end); i++) {
		end |= std::uint64_t(std::uint8_t(p_bytes[end_at + i])) << (8 * i);
	}
	return end == p_bytes.size();
}

} // namespace

void Head::Close::operator()(MYSOFA_EASY *p_easy) const {
	mysofa_close(p_easy);
}

Head::Head() = default;
Head::~Head() = default;

std::string Head::open(const std::vector<char> &p_bytes, float p_rate) {
	_easy.reset();
	if (!(p_rate >= MIN_RATE && p_rate <= MAX_RATE)) {
		return "a rate of " + std::to_string(p_rate) + " Hz makes no sense";
	}
	if (p_bytes.empty() || p_bytes.size() > MAX_BYTES) {
		return "a file of " + std::to_string(p_bytes.size()) + " bytes is no measured head";
	}
	if (!is_whole(p_bytes)) {
		return "it is no SOFA file, or a part of it is missing";
	}
	int error = MYSOFA_OK;
	int length = 0;
	_easy.reset(mysofa_open_data(p_bytes.data(), long(p_bytes.size()), p_rate, &length, &error));
	if (_easy == nullptr || error != MYSOFA_OK || length <= 0) {
		_easy.reset();
		return "it is no SOFA file of a measured head (libmysofa's error " + std::to_string(error) + ")";
	}
	_length = length;
	_rate = p_rate;
	return "";
}

void Head::find_whole(float p_x, float p_y, float p_z, std::vector<float> &r_left, std::vector<float> &r_right) const {
	r_left.assign(std::size_t(std::max(_length, 0)), 0.0f);
	r_right = r_left;
	if (_easy == nullptr) {
		return;
	}
	const float length = std::sqrt(p_x * p_x + p_y * p_y + p_z * p_z);
	const bool is_sound = std::isfinite(length) && length > 1e-6f;
	// SOFA's frame: x ahead, y to the left, z up.
	const float ahead = is_sound ? -p_z / length : 1.0f;
	const float left = is_sound ? -p_x / length : 0.0f;
	const float up = is_sound ? p_y / length : 0.0f;
	float left_delay = 0.0f;
	float right_delay = 0.0f;
	mysofa_getfilter_float(_easy.get(), ahead, left, up, r_left.data(), r_right.data(), &left_delay, &right_delay);
	const float shared = std::min(left_delay, right_delay);
	const auto late = [this, shared](std::vector<float> &r_taps, float p_delay) {
		const auto taps = std::size_t(std::max(0.0f, std::round((p_delay - shared) * _rate)));
		r_taps.insert(r_taps.begin(), std::min<std::size_t>(taps, TAPS), 0.0f);
	};
	late(r_left, left_delay);
	late(r_right, right_delay);
}

Ears Head::find(float p_x, float p_y, float p_z) const {
	Ears ears;
	std::vector<float> left;
	std::vector<float> right;
	find_whole(p_x, p_y, p_z, left, right);
	if (left.empty()) {
		return ears;
	}
	const auto from = std::size_t(std::max(0, std::min(onset_of(left), onset_of(right)) - LEAD));
	put(left, from, ears.left);
	put(right, from, ears.right);
	return ears;
}

} // namespace audio
