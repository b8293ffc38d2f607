// SPDX-License-Identifier: MIT
#include "suit/motion_stream.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace emulator {
namespace {

using kinematics::Quat;
using kinematics::Vec3;

constexpr char MAGIC[] = "XBMOTION";
constexpr std::size_t MAGIC_SIZE = 8;
constexpr std::size_t HEAD = 32;
constexpr std::size_t NAME = 32;
constexpr std::size_t KEY = 28;

// The file is little-endian, and so are the machines that the emulator runs on.
template <class T>
T read(const uint8_t *p_bytes) {
	T value{};
	std::memcpy(&value, p_bytes, sizeof(value));
	return value;
}

} // namespace

std::string MotionStream::parse(const std::vector<uint8_t> &p_bytes) {
	if (p_bytes.size() < HEAD || std::memcmp(p_bytes.data(), MAGIC, MAGIC_SIZE) != 0) {
		return "it is no motion stream";
	}
	if (read<uint32_t>(p_bytes.data() + 8) != 1) {
		return "it is a motion stream of an unknown version";
	}
	const std::size_t limbs = read<uint32_t>(p_bytes.data() + 12);
	_rate = read<double>(p_bytes.data() + 16);
	_frame_count = read<uint32_t>(p_bytes.data() + 24);
	_loop_frame = read<uint32_t>(p_bytes.data() + 28);
	if (limbs < 1 || limbs > MAX_LIMBS || !(_rate >= 1.0 && _rate <= 10000.0)) {
		return "it says an impossible number of limbs or frames a second";
	}
	if (_frame_count < 1 || _loop_frame >= _frame_count) {
		return "its loop begins behind its end";
	}
	const std::size_t needed = HEAD + limbs * NAME + _frame_count * limbs * KEY;
	if (p_bytes.size() != needed) {
		return "it has " + std::to_string(p_bytes.size()) + " bytes instead of " + std::to_string(needed);
	}
	_names.clear();
	_names.reserve(limbs);
	for (std::size_t i = 0; i < limbs; i++) {
		const char *name = reinterpret_cast<const char *>(p_bytes.data() + HEAD + i * NAME);
		_names.emplace_back(name, strnlen(name, NAME));
	}
	return _parse_keys(p_bytes.data() + HEAD + limbs * NAME);
}

std::string MotionStream::_parse_keys(const uint8_t *p_bytes) {
	_keys.resize(_frame_count * _names.size());
	for (std::size_t i = 0; i < _keys.size(); i++) {
		float values[7];
		std::memcpy(values, p_bytes + i * KEY, KEY);
		const Quat orientation{ values[1], values[2], values[3], values[0] };
		const Vec3 position{ values[4], values[5], values[6] };
		if (!orientation.is_finite() || !position.is_finite() ||
				std::fabs(orientation.dot(orientation) - 1.0F) > 0.01F) {
			return "its frame " + std::to_string(i / _names.size()) + " holds what is no rotation";
		}
		_keys[i] = { orientation.normalized(), position };
	}
	return {};
}

MotionStream MotionStream::still(std::size_t p_limbs) {
	MotionStream stream;
	stream._keys.resize(p_limbs);
	stream._names.reserve(p_limbs);
	for (std::size_t i = 0; i < p_limbs; i++) {
		stream._names.push_back("Sensor" + std::to_string(i + 1));
	}
	return stream;
}

std::size_t MotionStream::_frame(int64_t p_frame) const {
	const auto count = int64_t(_frame_count);
	const auto first = int64_t(_loop_frame);
	const int64_t frame = std::max<int64_t>(p_frame, 0);
	return std::size_t(frame < count ? frame : first + (frame - first) % (count - first));
}

const MotionStream::Key &MotionStream::_key(std::size_t p_limb, int64_t p_frame) const {
	return _keys[_frame(p_frame) * _names.size() + p_limb];
}

LimbMotion MotionStream::at(std::size_t p_limb, double p_time_s) const {
	const double at = std::max(p_time_s, 0.0) * _rate;
	const auto frame = int64_t(at);
	const auto part = float(at - double(frame));
	const Key &before = _key(p_limb, frame - 1);
	const Key &from = _key(p_limb, frame);
	const Key &to = _key(p_limb, frame + 1);
	const Vec3 turn = log(from.orientation.inverse() * to.orientation);
	LimbMotion motion;
	motion.orientation = from.orientation * exp(turn * part);
	motion.rate = turn * float(_rate);
	const float squared = float(_rate * _rate);
	motion.acceleration = (to.position - from.position * 2.0F + before.position) * squared;
	return motion;
}

} // namespace emulator
