// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

struct MYSOFA_EASY;

namespace audio {

/// Taps of an ear's filter: 2.7 ms at 48 kHz hold the delay between the ears and what the pinna does.
constexpr std::size_t TAPS = 128;

/// What both ears hear of an impulse from one direction.
struct Ears {
	std::array<float, TAPS> left{};
	std::array<float, TAPS> right{};
};

/// A measured head (AES69, a SOFA file), by libmysofa.
class Head {
public:
	Head();
	~Head();
	Head(const Head &) = delete;
	Head &operator=(const Head &) = delete;

	/// Takes the bytes of a SOFA file, for a sample rate (Hz). Returns why they cannot be used, or an empty text. For
	/// files of our own: libmysofa is not made for hostile ones.
	std::string open(const std::vector<char> &p_bytes, float p_rate);
	bool is_open() const { return _easy != nullptr; }
	/// The filters for a direction in the listener's frame: x to the right, y up, z back, as a camera has it. Of any
	/// length above 0; one of no length is straight ahead.
	Ears find(float p_x, float p_y, float p_z) const;
	/// All taps that the head was measured with, at the rate; as find() otherwise.
	void find_whole(float p_x, float p_y, float p_z, std::vector<float> &r_left, std::vector<float> &r_right) const;

private:
	struct Close {
		void operator()(MYSOFA_EASY *p_easy) const;
	};
	std::unique_ptr<MYSOFA_EASY, Close> _easy;
	int _length = 0;
	float _rate = 48000.0f;
};

} // namespace audio
