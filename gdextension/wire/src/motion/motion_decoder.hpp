// SPDX-License-Identifier: MIT
#pragma once

#include "motion/motion_packet.hpp"

namespace wire {

/// Reads what one client's MotionEncoder wrote. Datagrams may be lost, late, twice, broken or hostile.
class MotionDecoder {
public:
	/// What became of a datagram.
	enum class Outcome {
		OK,
		OLD, ///< It came before, or is too late to tell.
		UNKNOWN_BASE, ///< Of use only together with one that is not here (any more).
		BROKEN, ///< No encoder wrote it.
	};

	/// Bytes of an acknowledgement, and how many datagrams before the newest it speaks of.
	static constexpr std::size_t ACK_BYTES = 2;
	static constexpr uint32_t ACK_BITS = 8;

	/// Skeleton and error are those of the encoder.
	MotionDecoder(const Skeleton &p_skeleton, double p_max_error_deg);

	/// Reads a datagram; what it says is in packet() if that is OK.
	Outcome decode(const uint8_t *p_bytes, std::size_t p_size);
	/// Of the last datagram that was OK.
	const MotionPacket &packet() const { return _packet; }
	/// The pose of a person in it, whose root is where the hips are.
	void restore(std::size_t p_person, PersonPose &r_pose) const;
	/// Bytes of that datagram that were read; what follows is not motion.
	std::size_t used() const { return _used; }
	/// Writes ACK_BYTES bytes for the encoder: what is here. False before anything is.
	bool write_ack(uint8_t *r_bytes) const;

private:
	Outcome _place(bool p_has_base, uint32_t &r_number) const;
	void _keep();

	Skeleton _skeleton;
	PersonLattice _lattice;
	PersonCodec _codec;
	MotionHistory _history;
	MotionPacket _packet;
	MotionPacket _reading;
	std::size_t _used = 0;
	uint32_t _newest = 0;
	bool _has_newest = false;
};

} // namespace wire
