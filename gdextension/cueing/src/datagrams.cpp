// SPDX-License-Identifier: MIT
#include "datagrams.hpp"

#include "little_endian.hpp"

#include <algorithm>
#include <cmath>

namespace cueing {

namespace {

/// In the bytes: DSMC.
constexpr uint32_t MAGIC = 0x434d5344U;
/// OutSim counts metres in parts of this.
constexpr double OUTSIM_METRE = 65536.0;

void put_triple(LittleEndianWriter &r_writer, const Triple &p_triple) {
	for (const double value : p_triple) {
		r_writer.put_f32(value);
	}
}

/// OutSim has X to the right, Y ahead and Z up.
Triple to_outsim(const Triple &p_vector) {
	return { p_vector[0], -p_vector[2], p_vector[1] };
}

Triple scaled(const Triple &p_vector, double p_factor) {
	return { p_vector[0] * p_factor, p_vector[1] * p_factor, p_vector[2] * p_factor };
}

Triple rotated(const kinematics::Quat &p_rotation, const Triple &p_vector) {
	const kinematics::Vec3 result = p_rotation.rotate({ float(p_vector[0]), float(p_vector[1]), float(p_vector[2]) });
	return { result.x, result.y, result.z };
}

/// Heading (anticlockwise from above, 0 along -Z), pitch (nose up), roll (right side down).
Triple outsim_angles(const kinematics::Quat &p_orientation) {
	const Triple ahead = rotated(p_orientation, { 0.0, 0.0, -1.0 });
	const Triple right = rotated(p_orientation, { 1.0, 0.0, 0.0 });
	const Triple up = rotated(p_orientation, { 0.0, 1.0, 0.0 });
	return { std::atan2(-ahead[0], -ahead[2]), std::asin(std::clamp(ahead[1], -1.0, 1.0)),
		std::atan2(-right[1], up[1]) };
}

} // namespace

std::size_t encode_cue(const CueMessage &p_message, std::array<uint8_t, MAX_DATAGRAM> &r_bytes) {
	LittleEndianWriter writer(r_bytes.data());
	unsigned flags = 0;
	flags |= p_message.is_paused ? 1U : 0U;
	flags |= p_message.has_teleported ? 2U : 0U;
	flags |= p_message.is_stale ? 4U : 0U;
	writer.put_u32(MAGIC);
	writer.put_u16(CUE_VERSION);
	writer.put_u16(uint16_t(flags));
	writer.put_u32(p_message.sequence);
	writer.put_u32(p_message.tick);
	writer.put_u64(p_message.time_usec);
	const kinematics::Quat &attitude = p_message.motion.orientation;
	for (const float part : { attitude.x, attitude.y, attitude.z, attitude.w }) {
		writer.put_f32(part);
	}
	put_triple(writer, p_message.motion.felt.specific_force);
	put_triple(writer, p_message.motion.felt.rates);
	put_triple(writer, p_message.cue.position);
	put_triple(writer, p_message.cue.attitude);
	writer.put_f32(p_message.gain);
	// Room for what a later version adds.
	writer.put_u32(0);
	writer.put_u32(crc32(r_bytes.data(), writer.size()));
	return writer.size();
}

std::size_t encode_outsim(const CueMessage &p_message, int32_t p_id, std::array<uint8_t, MAX_DATAGRAM> &r_bytes) {
	LittleEndianWriter writer(r_bytes.data());
	const SeatMotion &motion = p_message.motion;
	// The packet has no room for "paused" or "put elsewhere": what would move a platform follows the ramps instead.
	const double gain = p_message.gain;
	const Triple angles = outsim_angles(motion.orientation);
	writer.put_u32(uint32_t(p_message.time_usec / 1000));
	put_triple(writer, scaled(to_outsim(rotated(motion.orientation, motion.felt.rates)), gain));
	put_triple(writer, { angles[0], angles[1] * gain, angles[2] * gain });
	put_triple(writer, scaled(to_outsim(motion.acceleration), gain));
	put_triple(writer, scaled(to_outsim(motion.velocity), gain));
	for (const double metres : to_outsim(motion.position)) {
		const double most = 2147483647.0;
		writer.put_i32(int32_t(std::clamp(std::round(metres * OUTSIM_METRE), -most, most)));
	}
	if (p_id >= 0) {
		writer.put_i32(p_id);
	}
	return writer.size();
}

} // namespace cueing
