// SPDX-License-Identifier: MIT
#pragma once

#include "motion_estimator.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace cueing {

/// What a platform, or a program between, is sent at a time.
struct CueMessage {
	uint32_t sequence = 0;
	/// The simulation's, 0 where there is none.
	uint32_t tick = 0;
	/// Since the sender began, microseconds.
	uint64_t time_usec = 0;
	/// The vehicle was at a standstill by order: the session pauses.
	bool is_paused = false;
	/// The vehicle was put elsewhere since the message before, or a little earlier.
	bool has_teleported = false;
	/// Nothing new was heard of the vehicle for the dead man's time.
	bool is_stale = false;
	/// How far the platform takes part, 0 (neutral) to 1: between on a ramp.
	double gain = 0.0;
	SeatMotion motion;
	Pose cue;
};

/// Our own datagram, docs/motion-platform.md.
constexpr std::size_t CUE_SIZE = 100;
constexpr uint16_t CUE_VERSION = 1;
/// OutSim's packet (Live for Speed), and with an id.
constexpr std::size_t OUTSIM_SIZE = 64;
constexpr std::size_t OUTSIM_ID_SIZE = 68;
constexpr std::size_t MAX_DATAGRAM = CUE_SIZE;

/// Returns the number of bytes, CUE_SIZE.
std::size_t encode_cue(const CueMessage &p_message, std::array<uint8_t, MAX_DATAGRAM> &r_bytes);
/// Raw motion for programs with filters of their own. Without an id (-1) OUTSIM_SIZE bytes, else OUTSIM_ID_SIZE.
std::size_t encode_outsim(const CueMessage &p_message, int32_t p_id, std::array<uint8_t, MAX_DATAGRAM> &r_bytes);

} // namespace cueing
