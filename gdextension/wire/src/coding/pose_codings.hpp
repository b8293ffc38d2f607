// SPDX-License-Identifier: MIT
#pragma once

#include <quaternion.hpp>

#include <cstddef>
#include <cstdint>

namespace wire {

/// Ways to write a pose alone, without any other to refer to.
enum class PoseCoding {
	FLOATS, ///< Four floats a limb, 16 bytes.
	THESIS_12, ///< Three floats, w is worked out (thesis 7.3), 12 bytes.
	THESIS_4, ///< Polar coordinates and length of the vector part (thesis 7.3), 4 bytes.
	SMALLEST_3, ///< Three whole numbers beside the largest component, 2 + 3 x bits bits.
};

/// Bits of each component that SMALLEST_3 can have.
constexpr int MIN_BITS = 4;
constexpr int MAX_BITS = 16;

/// Bytes that so many limbs take.
std::size_t coded_size(PoseCoding p_coding, int p_bits, std::size_t p_limbs);
/// How many limbs so many bytes are, or 0 if they cannot be a pose.
std::size_t coded_limbs(PoseCoding p_coding, int p_bits, std::size_t p_bytes);
/// Writes coded_size() bytes. False if a rotation is none: numbers that are not finite, or a norm that is
/// not between 0.9 and 1.1.
bool encode_pose(
		PoseCoding p_coding, int p_bits, const kinematics::Quat *p_rotations, std::size_t p_limbs, uint8_t *r_bytes);
/// Reads coded_limbs() unit quaternions. False if the bytes are no pose.
bool decode_pose(
		PoseCoding p_coding, int p_bits, const uint8_t *p_bytes, std::size_t p_size, kinematics::Quat *r_rotations);

} // namespace wire
