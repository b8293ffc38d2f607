// SPDX-License-Identifier: MIT
#pragma once

#include "bus/framer.hpp"
#include "bus/message.hpp"
#include "session/suit_stream.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace xbus {

/// Where a session is.
enum class SessionState : uint8_t {
	SEARCHING, ///< Nobody has answered yet.
	CONFIGURING,
	MEASURING,
	SILENT, ///< Was measuring, and says nothing any more.
	UNSUPPORTED, ///< Answered, and is a device that can't be used.
	STOPPED,
};

/// The state in plain words.
const char *state_text(SessionState p_state);

/// What is known of a tracker.
struct TrackerReport {
	uint32_t device_id = 0;
	uint8_t bus_id = 0;
	DeviceStatistics samples;
	TrackerFlow flow;
};

/// What is known of a master, for people.
struct SessionReport {
	SessionState state = SessionState::SEARCHING;
	uint32_t device_id = 0;
	DeviceKind kind = DeviceKind::UNKNOWN;
	/// Speed of the line, bit/s; 0 where it has none.
	uint32_t baud = 0;
	/// Samples per second that were asked for.
	double rate_hz = 0.0;
	/// 0 to 1, negative where it is not known.
	double battery = -1.0;
	FramerStatistics framer;
	StreamStatistics stream;
	/// Error messages of the device.
	uint64_t errors = 0;
	/// How often it was brought up anew.
	uint64_t restarts = 0;
	/// Part of the samples that was lost in the last seconds, 0 to 1.
	double lost_share = 0.0;
	/// What is wrong now, or an empty text.
	std::string problem;
	std::vector<TrackerReport> trackers;
};

} // namespace xbus
