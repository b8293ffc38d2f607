// SPDX-License-Identifier: MIT
#pragma once

#include "quaternion.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace emulator {

/// How a limb is at one moment. Frame: Xsens' (right-handed, X north, Y west, Z up, metres); in the reset
/// pose the person faces north and every limb's axes are those of the world.
struct LimbMotion {
	kinematics::Quat orientation;
	/// In the limb's own axes, rad/s.
	kinematics::Vec3 rate;
	/// Of the sensor's position, in the world, m/s2, without gravity.
	kinematics::Vec3 acceleration;
};

/// The motion of a person's limbs, as scripts/emulation/write_suit_motion.gd makes it from a BVH file.
/// After its last frame it goes on at the frame where the loop begins.
///
/// The file is little-endian: "XBMOTION", u32 version (1), u32 limbs, f64 frames a second, u32 frames, u32 first
/// frame of the loop, 32 bytes of name for each limb, then for each frame and limb the orientation (w x y z)
/// and the position (x y z) as 7 f32.
class MotionStream {
public:
	/// Reads a file's bytes; an empty text, or what is wrong.
	std::string parse(const std::vector<uint8_t> &p_bytes);
	/// Stands still in the reset pose: what a suit without a file does.
	static MotionStream still(std::size_t p_limbs);

	std::size_t limb_count() const { return _names.size(); }
	const std::string &limb_name(std::size_t p_limb) const { return _names[p_limb]; }
	std::size_t frame_count() const { return _frame_count; }
	/// Seconds until the loop begins.
	double lead_in_s() const { return double(_loop_frame) / _rate; }

	/// How a limb is after so many seconds.
	LimbMotion at(std::size_t p_limb, double p_time_s) const;

	static constexpr std::size_t MAX_LIMBS = 64;

private:
	struct Key {
		kinematics::Quat orientation;
		kinematics::Vec3 position;
	};

	std::string _parse_keys(const uint8_t *p_bytes);
	/// Which frame is so many frames after the beginning, in the loop.
	std::size_t _frame(int64_t p_frame) const;
	const Key &_key(std::size_t p_limb, int64_t p_frame) const;

	std::vector<std::string> _names;
	std::vector<Key> _keys;
	double _rate = 100.0;
	std::size_t _frame_count = 1;
	std::size_t _loop_frame = 0;
};

} // namespace emulator
