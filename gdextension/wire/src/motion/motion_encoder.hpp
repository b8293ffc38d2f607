// SPDX-License-Identifier: MIT
#pragma once

#include "motion/motion_packet.hpp"

namespace wire {

/// Codes what a client's people do, up to eight at one moment in one datagram, against datagrams that
/// the server has acknowledged. Each datagram can be read without any that was not acknowledged.
///
/// begin(), put() for each person, then finish(). Nothing here allocates.
class MotionEncoder {
public:
	/// Numbers begin at p_first: one that another encoder of the same client is unlikely to have used.
	MotionEncoder(const Skeleton &p_skeleton, double p_max_error_deg, uint32_t p_first);

	/// Begins a datagram: when its first sample was taken (Unix time, us), how long it was held (us), and
	/// when it is sent (us of the server's clock, 0: not known).
	void begin(int64_t p_time_usec, int64_t p_held_usec, int64_t p_sent_usec);
	/// Adds a sample of a person (0 to 7), taken at a time, whose hips are at pose.root; false if that is no
	/// pose. A person put twice is there once.
	bool put(std::size_t p_person, uint32_t p_sample, int64_t p_time_usec, const PersonPose &p_pose);
	/// Writes it; returns its size, or 0 if there is nobody in it or it does not fit.
	std::size_t finish(uint8_t *r_bytes, std::size_t p_capacity);
	/// Takes what MotionDecoder::write_ack() wrote. False for what it never writes.
	bool take_ack(const uint8_t *p_bytes, std::size_t p_size);

private:
	const MotionPacket *_baseline(uint32_t p_from, uint32_t p_to) const;

	Skeleton _skeleton;
	PersonLattice _lattice;
	PersonCodec _codec;
	MotionHistory _history;
	std::array<PersonState, MAX_WEARERS> _previous{};
	std::array<bool, MAX_WEARERS> _has_previous{};
	MotionPacket _packet;
	uint32_t _number;
};

} // namespace wire
